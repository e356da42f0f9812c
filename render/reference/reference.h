// The reference: renders the same scene with Embree, one ray through the centre of each pixel. Direct light
// has the same shadows as in the renderer (scene/shadow_view.h), the light of the environment is sampled,
// and materials are evaluated by libbrdf in float.
#pragma once

#include <functional>

#include "io/files/parallel.h"
#include "render/picture/picture.h"
#include "render/scene/prepared.h"

namespace brdf::render {

// Value of f_r cos_i per channel for a pair of directions in the surface's frame, and whether the value is
// known. Replaces the material of an object.
struct MeasuredValue {
  glm::vec3 f_cos{0};
  bool known = true;
  MeasuredValue(const glm::vec3& value, bool is_known = true) : f_cos(value), known(is_known) {}
};
using Measured = std::function<MeasuredValue(const glm::vec3& wi, const glm::vec3& wo)>;

struct ReferenceOptions {
  unsigned threads = io::all_processors();
  // If set, shades all objects (ambient light then has no effect). Pixels lit from directions for which the
  // value is not known have the alpha kNotMeasured.
  const Measured* measured = nullptr;
  // Samples of the environment's light, which is left out if `measured` is set.
  int samples = 256;
  std::uint32_t seed = 1;
  Picture* standard_error = nullptr;  // if set, receives the standard error of each pixel
};

// Returns the picture of the reference. A is 1 for surfaces, kNotMeasured for surfaces with unknown values,
// 0 for the background.
Picture render_reference(const PreparedScene& scene, const ReferenceOptions& options = {});

// A shading evaluation: one entry per pixel and light that reaches the front of its surface, in the order
// of the pixels. Directions are in the surface's frame.
struct LitPoint {
  int x = 0, y = 0;
  std::size_t object = 0;
  glm::vec3 wi{0}, wo{0};
  glm::vec3 irradiance{0};  // on a surface that faces the light
};
std::vector<LitPoint> lit_points(const PreparedScene& scene);

// The surface hit by a ray through the centre of a pixel.
struct PixelProbe {
  bool hit = false;
  std::size_t object = 0;
  glm::vec3 position{0}, normal{0};
  glm::vec3 wi{0}, wo{0};  // local frame, wi to the first light
  glm::vec3 value{0};      // f_r for the first light
};
PixelProbe pixel_probe(const PreparedScene& scene, int x, int y);
// Returns the probe as text: object, place, angles in degrees, f_r.
std::vector<std::string> lines(const PixelProbe& probe);

}  // namespace brdf::render
