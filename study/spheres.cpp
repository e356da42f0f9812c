#include "study/spheres.h"

#include "io/colour/channel_colours.h"
#include "measured/on_sphere.h"

namespace brdf::study {
namespace {

constexpr int kPicturePixels = 360, kSmallPixels = 112;  // per side

}  // namespace

Spheres draw(const io::SampleTable& samples, const Material& fitted, const std::function<bool()>& stops) {
  if (!io::channel_colours(fitted.channels)) return {.missing = "the channels are not colours"};
  Spheres spheres;
  spheres.seen = measured::seen_in_colour(samples, &fitted);
  if (stops()) return spheres;
  const double brightness = io::sphere::studio_exposure(fitted);
  if (stops()) return spheres;
  spheres.studio = io::sphere::studio_pictures(fitted, brightness, 2 * kSmallPixels);
  if (stops()) return spheres;
  const auto of_fitted = io::sphere::fitted_pairs(fitted);
  const auto of_samples = measured::on_sphere(spheres.seen);
  const double exposure = io::sphere::exposure_of(of_fitted);
  spheres.whole = io::sphere::still_pictures(of_fitted, of_samples, exposure, kPicturePixels);
  if (stops()) return spheres;
  spheres.lobes = lobes_of(samples, fitted);
  return spheres;
}

}  // namespace brdf::study
