// The demands of a scene on a material: the directions of its lit pixels, and models fitted to exactly these
// directions.
#pragma once

#include <functional>

#include "io/samples/samples.h"
#include "render/reference/reference.h"

namespace brdf::trade {

// f_r per channel (three) in 1/sr for unit directions in the surface's frame.
using RgbFunction = std::function<std::array<double, 3>(const Vec3<double>& wi, const Vec3<double>& wo)>;

RgbFunction rgb_function(const Material& material);
RgbFunction rgb_function(const io::SampleTable& table);  // interpolated

// Returns true if values are unchanged, to 1e-4 on average, when the surface is turned under fixed
// directions of light and viewer.
bool is_isotropic(const RgbFunction& reference);

// The lit points of the scene. The surface frames are independent of any material's own tangent.
struct SceneView {
  render::PreparedScene scene;
  std::vector<render::LitPoint> points;
};
// Prepares the scene and returns its lit points.
SceneView view_of(render::Scene scene);

// Returns the lit points as samples of the reference, at most about `rows` of them, weighted by their
// contribution to the picture: sigma is 1/(irradiance cos_i), which makes a fit's residual equal to the
// difference of a pixel.
io::SampleTable scene_samples(const SceneView& view, const RgbFunction& reference, std::size_t rows);

// Returns samples of the reference over both hemispheres up to 85 degrees, with uniform density (the
// additive recurrence in equal solid angles).
io::SampleTable hemisphere_samples(const RgbFunction& reference, std::size_t rows);

// Returns mean |dL| / mean L over the lit pixels, with |dL| averaged over the channels.
double image_error(const SceneView& view, const RgbFunction& model, const RgbFunction& reference);

// Pictures of model and reference by the reference renderer, and the image_error() of the pictures.
struct RenderedPair {
  render::Picture model, reference;
  double image_error = 0;
};
RenderedPair render_both(const SceneView& view, const RgbFunction& model, const RgbFunction& reference);

// Fits the form with the residual of a picture, (f - g) cos_i, and returns the best minimum.
Material fit_to_picture(const Reflectance& form, const io::SampleTable& table, bool anisotropic);

// Distribution of the lit pixels' directions, in degrees.
struct Coverage {
  std::size_t pixels = 0;
  double most_theta_i = 0, most_theta_o = 0, most_theta_d = 0, least_theta_h = 90, most_theta_h = 0;
  // Half vectors off the normal have azimuths within `azimuth_spread` of `azimuth_of_h`.
  double azimuth_of_h = 0, azimuth_spread = 180;
};
// Returns the distribution.
Coverage coverage_of(const SceneView& view);

}  // namespace brdf::trade
