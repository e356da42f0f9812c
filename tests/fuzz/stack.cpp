// Stacks of photographs: the single image of a stack, and the table of lights of two valid images.
#include <cmath>

#include "tests/fuzz/fuzz.h"
#include "texel/planes.h"
#include "texel/stack.h"

namespace brdf::fuzz {
namespace {

constexpr std::size_t kMostPixels = 1000;  // larger pictures only take longer

void check_pixels(const texel::Stack& stack) {
  require(stack.width > 0 && stack.height > 0 && !stack.channels.empty(), "a stack has texels and channels");
  require(stack.images.size() == stack.lights.rows(), "every image has its light");
  if (stack.width * stack.height > kMostPixels) return;
  const texel::Region whole{0, 0, stack.width, stack.height};
  const std::vector<float> pixels = texel::read_region(stack, whole);
  require(pixels.size() == whole.size() * stack.channels.size() * stack.images.size(),
          "a stack has the pixels of its size");
  for (const float value : pixels) require(!std::isinf(value), "pixels are numbers or none");
  const std::vector<std::size_t> last{stack.width - 1};
  const std::vector<float> texel = texel::read_texels(stack, last, stack.height - 1);
  for (std::size_t k = 0; k < texel.size(); ++k) {
    const float value = pixels[pixels.size() - texel.size() + k];
    require(texel[k] == value || (std::isnan(texel[k]) && std::isnan(value)),
            "a texel is what its region says");
  }
}

const Registered photographs("photograph", [](std::string_view input) {
  const bool is_png = input.starts_with("\x89PNG");
  const std::string folder = is_png ? "png" : "exr";
  folder_with(folder, "lights.csv", "# transfer: srgb\ntheta_i,phi_i,theta_o,phi_o\n30,0,0,0\n");
  check_pixels(texel::open_stack(folder_with(folder, "image." + folder, input)));
});

const Registered lights("lights", [](std::string_view input) {
  for (const char* name : {"one.exr", "two.exr"}) {
    const std::filesystem::path path = folder_with("lights") / name;
    if (!exists(path)) texel::write_planes(path, {2, 1, {"Y"}, {{0.25f, 0.5f}}});
  }
  const texel::Stack stack = texel::open_stack(folder_with("lights", "lights.csv", input));
  check_samples(stack.lights, true);
  check_pixels(stack);
  for (const std::size_t x : {std::size_t(0), std::size_t(1)}) {
    const DirectionArrays<double> directions = texel::directions_at(stack, x, 0);
    for (std::size_t k = 0; k < directions.size(); ++k)
      for (const Vec3<double>& w : {directions.view().wi(k), directions.view().wo(k)})
        require(std::abs(dot(w, w) - 1) < 1e-9, "directions have length 1");
  }
});

}  // namespace
}  // namespace brdf::fuzz
