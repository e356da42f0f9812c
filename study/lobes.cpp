#include "study/lobes.h"

#ifdef BRDF_HAS_RENDER
#include <algorithm>

#include "render/compare/lobe_body.h"
#include "render/compare/lobe_points.h"

namespace brdf::study {
namespace {

constexpr int kLobePixels = 480;  // width and height

}  // namespace

bool has_lobes() {
  return true;
}

std::vector<Lobe> lobes_of(const io::SampleTable& samples, const Material& fitted) {
  std::vector<double> angles;
  double outer = 0;
  for (const double wished : {30.0, 65.0}) {
    const double theta_i = render::nearest_light(samples, wished);
    if (!angles.empty() && angles.back() == theta_i) continue;
    angles.push_back(theta_i);
    outer = std::max(outer, render::largest_of_lobe(fitted, theta_i, &samples));
  }
  std::vector<Lobe> lobes;
  for (const double theta_i : angles)
    lobes.push_back({theta_i, outer,
                     render::png_of(render::lobe_body_picture(fitted, "fitted", theta_i, &samples,
                                                              kLobePixels, outer, false)),
                     render::lobe_to_turn(fitted, theta_i, &samples, outer)});
  return lobes;
}

}  // namespace brdf::study
#else
namespace brdf::study {

bool has_lobes() {
  return false;
}

std::vector<Lobe> lobes_of(const io::SampleTable&, const Material&) {
  return {};
}

}  // namespace brdf::study
#endif
