#include "study/spheres.h"

#include "io/channel_colours.h"
#include "io/error.h"
#include "render/compare/measured.h"

namespace brdf::study {
namespace {

constexpr int kPixels = 360;   // of a side
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

}  // namespace

bool can_draw() {
  return true;
}

Spheres draw(const io::SampleTable& samples, const Material& fitted) {
  try {
    const render::MeasuredSpheres spheres = render::measured_spheres(fitted, samples, kPixels);
    const auto colours = io::channel_colours(fitted.channels);
    return {.measured = render::png_of(spheres.measured),
            .fitted = render::png_of(spheres.fitted),
            .difference = render::png_of(spheres.difference),
            .small_measured = render::png_of(reduced(spheres.measured)),
            .small_fitted = render::png_of(reduced(spheres.fitted)),
            .note = colours ? colours->note : ""};
  } catch (const InputError& error) {
    return {.missing = error.what()};
  }
}

}  // namespace brdf::study
