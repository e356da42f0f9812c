// The reference: the same scene by Embree, one ray through every pixel's centre, direct light without shadows
// as in the renderer and the environment's by samples, materials by libbrdf's own float evaluation.
#pragma once

#include <functional>

#include "io/files/parallel.h"
#include "render/picture/picture.h"
#include "render/scene/prepared.h"

namespace brdf::render {

// Value of f_r cos_i per channel for a pair of directions in the surface's frame, and whether it is known;
// replaces an object's material.
struct MeasuredValue {
  glm::vec3 f_cos{0};
  bool known = true;
  MeasuredValue(const glm::vec3& value, bool is_known = true) : f_cos(value), known(is_known) {}
};
using Measured = std::function<MeasuredValue(const glm::vec3& wi, const glm::vec3& wo)>;

struct ReferenceOptions {
  unsigned threads = io::all_processors();
  // Shades every object where set (ambient then has nothing to act on); pixels lit along directions of which
  // it knows nothing have the alpha kNotMeasured.
  const Measured* measured = nullptr;
  // Of the environment's light, which what is measured leaves out.
  int samples = 256;
  std::uint32_t seed = 1;
  Picture* standard_error = nullptr;  // where wanted: that of each pixel
};

Picture render_reference(const PreparedScene& scene, const ReferenceOptions& options = {});

// What the shading of a pixel is asked for: one entry per pixel and light that reaches its surface's front,
// in the order of the pixels. Directions in the surface's frame.
struct LitPoint {
  int x = 0, y = 0;
  std::size_t object = 0;
  glm::vec3 wi{0}, wo{0};
  glm::vec3 irradiance{0};  // on a surface that faces the light
};
std::vector<LitPoint> lit_points(const PreparedScene& scene);

// What a ray through the centre of a pixel meets.
struct PixelProbe {
  bool hit = false;
  std::size_t object = 0;
  glm::vec3 position{0}, normal{0};
  glm::vec3 wi{0}, wo{0};  // local frame, wi to the first light
  glm::vec3 value{0};      // f_r of the first light
};
PixelProbe pixel_probe(const PreparedScene& scene, int x, int y);
// In words: object, place, angles in degrees, f_r.
std::vector<std::string> lines(const PixelProbe& probe);

}  // namespace brdf::render
