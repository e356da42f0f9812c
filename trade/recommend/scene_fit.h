// What a scene asks of a material: the directions of its lit pixels, and models fitted to exactly those.
#pragma once

#include <functional>

#include "io/samples/samples.h"
#include "render/reference/reference.h"

namespace brdf::trade {

// f_r per channel (three) in 1/sr for unit directions in the surface's frame.
using RgbFunction = std::function<std::array<double, 3>(const Vec3<double>& wi, const Vec3<double>& wo)>;

RgbFunction rgb_function(const Material& material);
RgbFunction rgb_function(const io::SampleTable& table);  // interpolated

// Whether values stay the same, to a ten-thousandth on average, when the surface is turned under light and
// viewer.
bool is_isotropic(const RgbFunction& reference);

// The scene's lit points, the surface frames free of any material's own tangent.
struct SceneView {
  render::PreparedScene scene;
  std::vector<render::LitPoint> points;
};
SceneView view_of(render::Scene scene);

// The lit points as samples of the reference, at most about `rows` of them, weighted as they shine: sigma is
// 1/(irradiance cos_i), and a fit's residual then is what a pixel differs by.
io::SampleTable scene_samples(const SceneView& view, const RgbFunction& reference, std::size_t rows);

// Samples of the reference over both hemispheres, every direction alike (the additive recurrence in equal
// solid angles), up to 85 degrees.
io::SampleTable hemisphere_samples(const RgbFunction& reference, std::size_t rows);

// mean |dL| / mean L over the lit pixels, L averaged over the channels' absolute differences.
double image_error(const SceneView& view, const RgbFunction& model, const RgbFunction& reference);

// The same, from pictures of both rendered by the reference renderer.
struct RenderedPair {
  render::Picture model, reference;
  double image_error = 0;
};
RenderedPair render_both(const SceneView& view, const RgbFunction& model, const RgbFunction& reference);

// Fit with the residual of a picture, (f - g) cos_i; the best minimum of the form.
Material fit_to_picture(const Reflectance& form, const io::SampleTable& table, bool anisotropic);

// How the lit pixels' directions are distributed, in degrees.
struct Coverage {
  std::size_t pixels = 0;
  double most_theta_i = 0, most_theta_o = 0, most_theta_d = 0, least_theta_h = 90, most_theta_h = 0;
  double azimuth_of_h = 0, azimuth_spread = 180;  // half vectors off the normal stay within spread of it
};
Coverage coverage_of(const SceneView& view);

}  // namespace brdf::trade
