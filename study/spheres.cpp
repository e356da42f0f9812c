#include "study/spheres.h"

#include "io/error.h"
#include "render/compare/lobe_body.h"
#include "render/compare/lobe_points.h"
#include "render/compare/measured.h"

namespace brdf::study {
namespace {

constexpr int kPixels = 360;  // of a side
constexpr int kLobePixels = 480;
constexpr int kReduction = 3;  // of the small ones

render::BytePicture reduced(const render::BytePicture& picture) {
  render::BytePicture out(picture.width / kReduction, picture.height / kReduction);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        int sum = 0;
        for (int j = 0; j < kReduction * kReduction; ++j) {
          const int row = kReduction * y + j / kReduction, column = kReduction * x + j % kReduction;
          sum += picture.pixels[std::size_t(row * picture.width + column)][c];
        }
        out.pixels[std::size_t(y * out.width + x)][c] =
            std::uint8_t((sum + kReduction * kReduction / 2) / (kReduction * kReduction));
      }
  return out;
}

// A light at which a lobe is compact, and one at which it is drawn out.
std::vector<Spheres::Lobe> lobes_of(const io::SampleTable& samples, const Material& fitted) {
  std::vector<Spheres::Lobe> lobes;
  for (const double wished : {30.0, 65.0}) {
    const double theta_i = render::nearest_light(samples, wished);
    if (!lobes.empty() && lobes.back().theta_i == theta_i) continue;
    lobes.push_back({theta_i, render::png_of(render::lobe_body_picture(fitted, "fitted", theta_i, &samples,
                                                                       kLobePixels))});
  }
  return lobes;
}

}  // namespace

bool can_draw() {
  return true;
}

Spheres draw(const io::SampleTable& samples, const Material& fitted) {
  try {
    const render::MeasuredSpheres spheres = render::measured_spheres(fitted, samples, kPixels);
    return {.measured = render::png_of(spheres.measured),
            .fitted = render::png_of(spheres.fitted),
            .difference = render::png_of(spheres.difference),
            .small_measured = render::png_of(reduced(spheres.measured)),
            .small_fitted = render::png_of(reduced(spheres.fitted)),
            .lobes = lobes_of(samples, fitted),
            .missing = ""};
  } catch (const InputError& error) {
    return {.missing = error.what()};
  }
}

}  // namespace brdf::study
