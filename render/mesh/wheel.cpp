#include "render/mesh/wheel.h"

#include <glm/gtc/matrix_transform.hpp>

#include "brdf/scalar.h"
#include "render/mesh/lathe.h"
#include "render/mesh/loft.h"

namespace brdf::render {
namespace {

// Turns a mesh of the lathe, which has the axis y, onto the axle.
Mesh onto_axle(const Mesh& turned) {
  Mesh out;
  append(out, turned, glm::rotate(glm::mat4(1), float(kPi / 2), {1, 0, 0}));
  return out;
}

}  // namespace

Mesh make_tyre() {
  return onto_axle(lathe(filleted({{{0, -0.1f}},
                                   {{0.3f, -0.1f}, 0.02f},
                                   {{kTyreRadius, -0.07f}, 0.05f},
                                   {{kTyreRadius, 0.07f}, 0.05f},
                                   {{0.30f, 0.105f}, 0.03f},
                                   {{0.235f, 0.09f}, 0.01f},
                                   {{0.225f, 0.02f}, 0.01f},
                                   {{0, 0.0f}}},
                                  6),
                         96));
}

Mesh make_rim() {
  const Mesh ring = lathe(
      filleted({{{0.236f, 0.03f}}, {{0.236f, 0.1f}, 0.006f}, {{0.214f, 0.1f}, 0.006f}, {{0.214f, 0.0f}}}, 4),
      96);
  const Mesh hub = lathe(filleted({{{0.055f, 0.0f}}, {{0.055f, 0.085f}, 0.02f}, {{0, 0.085f}}}, 6), 48);
  Mesh rim = onto_axle(ring);
  append(rim, onto_axle(hub));
  const Mesh rod = make_sphere(24, 16);
  for (int k = 0; k < 10; ++k) {
    const glm::mat4 turn = glm::rotate(glm::mat4(1), 2 * float(kPi) * float(k) / 10, {0, 0, 1});
    append(rim, placed(rod, {0.135f, 0, 0.058f}, {0.1f, 0.02f, 0.022f}), turn);
  }
  return rim;
}

}  // namespace brdf::render
