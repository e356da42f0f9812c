#include "study/lobes.h"

#ifdef BRDF_HAS_RENDER
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
  std::vector<Lobe> lobes;
  for (const double wished : {30.0, 65.0}) {
    const double theta_i = render::nearest_light(samples, wished);
    if (!lobes.empty() && lobes.back().theta_i == theta_i) continue;
    lobes.push_back({theta_i, render::png_of(render::lobe_body_picture(fitted, "fitted", theta_i, &samples,
                                                                       kLobePixels))});
  }
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
