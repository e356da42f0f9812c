// Tests `synth --registration`: every image shows the surface shifted a little, by the amount requested.
#include <gtest/gtest.h>

#include "tests/maps/stack.h"

namespace brdf {
namespace {

// Returns the image of the surface for a camera with this shift, in one channel and under one light.
std::vector<double> shifted_image(const synth::Surface& surface, const texel::Stack& stack, std::size_t image,
                                  double shift_x, double shift_y) {
  const DirectionArrays<double> arrays = io::unit_directions(stack.lights);
  std::vector<double> out, pixel(stack.channels.size());
  for (std::size_t t = 0; t < stack.width * stack.height; ++t) {
    const double x = double(t % stack.width) + shift_x, y = double(t / stack.width) + shift_y;
    const Vec3<double> n = surface.normal(x, y);
    eval_cos(surface.material(x, y), in_frame_of(n, arrays.view().wi(image)),
             in_frame_of(n, arrays.view().wo(image)), pixel);
    out.push_back(pixel[0]);
  }
  return out;
}

double squares(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

struct Shift {
  double x = 0, y = 0, error = 0;  // error: the remaining difference, relative to the image
};

// Returns the shift that explains an image, by Gauss-Newton steps.
Shift shift_of(const synth::Surface& surface, const texel::Stack& stack, std::size_t image,
               const std::vector<double>& seen) {
  Shift s;
  const double step = 1e-5;
  for (int round = 0; round < 12; ++round) {
    const auto here = shifted_image(surface, stack, image, s.x, s.y),
               right = shifted_image(surface, stack, image, s.x + step, s.y),
               down = shifted_image(surface, stack, image, s.x, s.y + step);
    double xx = 0, xy = 0, yy = 0, x = 0, y = 0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const double dx = (right[k] - here[k]) / step, dy = (down[k] - here[k]) / step, off = seen[k] - here[k];
      xx += dx * dx, xy += dx * dy, yy += dy * dy, x += dx * off, y += dy * off;
    }
    const double determinant = xx * yy - xy * xy;
    s.x += (yy * x - xy * y) / determinant;
    s.y += (xx * y - xy * x) / determinant;
  }
  s.error = std::sqrt(squares(seen, shifted_image(surface, stack, image, s.x, s.y)) /
                      squares(seen, std::vector<double>(seen.size())));
  return s;
}

TEST(Registration, ShiftsEveryImageByItself) {
  synth::TexelOptions o = small_stack(0, 40);
  o.width = 14;
  o.height = 10;
  o.vary = {{"alpha", 0.3, 0.5}, {"kd", 0.1, 0.6}};
  o.tilt = 15;
  o.registration = 0.3;
  const io::TemporaryFolder folder;
  synth::write_stack(folder.path(), lacquer(), o);
  const texel::Stack stack = texel::open_stack(folder.path());
  const std::size_t texels = o.width * o.height, images = stack.images.size();
  const std::vector<float> pixels = texel::read_region(stack, {0, 0, o.width, o.height});
  const synth::Surface surface(lacquer(), o);
  double sum[2] = {}, square = 0;
  for (std::size_t image = 0; image < images; ++image) {
    std::vector<double> seen;
    for (std::size_t t = 0; t < texels; ++t)
      seen.push_back(double(pixels[t * stack.channels.size() * images + image]));
    const Shift s = shift_of(surface, stack, image, seen);
    EXPECT_LT(s.error, 1e-5) << image;
    EXPECT_GT(std::sqrt(squares(seen, shifted_image(surface, stack, image, 0, 0))), 1e-4) << image;
    sum[0] += s.x, sum[1] += s.y, square += s.x * s.x + s.y * s.y;
  }
  // The standard deviation of 80 normal numbers is known to 8 %, and the mean of 40 numbers for each axis
  // to the standard deviation divided by sqrt(40). The bounds are four times these figures.
  EXPECT_NEAR(std::sqrt(square / double(2 * images)), o.registration, 0.32 * o.registration);
  for (const double s : sum) EXPECT_LT(std::abs(s) / double(images), 4 * o.registration / std::sqrt(images));
}

TEST(Registration, OfNothingLeavesImagesInPlace) {
  synth::TexelOptions o = small_stack(6, 5);
  const io::TemporaryFolder folder;
  synth::write_stack(folder.path(), lacquer(), o);
  const texel::Stack stack = texel::open_stack(folder.path());
  const std::vector<float> pixels = texel::read_region(stack, {0, 0, 6, 6});
  const std::vector<double> expected = shifted_image(synth::Surface(lacquer(), o), stack, 3, 0, 0);
  for (std::size_t t = 0; t < 36; ++t)
    EXPECT_NEAR(double(pixels[t * 15 + 3]), expected[t], 1e-6 * expected[t]);
}

}  // namespace
}  // namespace brdf
