#include "study/spheres.h"

#include <mutex>
#include <optional>

#include "io/error.h"
#include "io/html_report.h"
#include "render/compare/pictures.h"
#include "render/compare/state.h"
#include "render/job.h"

namespace brdf::study {
namespace {

constexpr std::uint32_t kPixels = 360;  // of a side
constexpr int kReduction = 3;           // of the small ones

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

std::string png_file(const render::BytePicture& picture) {
  std::vector<unsigned char> rgb;
  rgb.reserve(3 * picture.pixels.size());
  for (const auto& pixel : picture.pixels) rgb.insert(rgb.end(), pixel.begin(), pixel.end());
  return io::png_of_pixels(std::size_t(picture.width), std::size_t(picture.height), rgb);
}

// Why this material and these samples have no picture; empty: nothing is known against one.
std::string not_drawn(const std::filesystem::path& samples, const std::string& name,
                      const Material& material) {
  if (!std::filesystem::is_regular_file(samples)) return name + ": is no file that can be read again";
  try {
    render::require_colours(material.channels, name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The sphere under the light of a material's own scene, the samples beside it.
render::ViewState state_of(const std::filesystem::path& samples, const std::string& name,
                           const Material& material) {
  render::ViewState state;
  state.scene = render::material_scene({{name, material}});
  state.other = render::Other::samples;
  state.samples = samples;
  return state;
}

}  // namespace

// The device, made when the first picture is wanted and kept for the others.
class Painter::Studio {
 public:
  Spheres draw(const std::filesystem::path& samples, const std::string& name, const Material& material) {
    if (const std::string reason = not_drawn(samples, name, material); !reason.empty())
      return {.missing = reason};
    const std::lock_guard lock(mutex_);
    if (!has_device()) return {.missing = refusal_};
    return drawn(state_of(samples, name, material));
  }

  bool can_draw() {
    const std::lock_guard lock(mutex_);
    return has_device();
  }

 private:
  bool has_device() {
    if (!device_ && refusal_.empty()) try {
        device_.emplace();
      } catch (const EnvironmentError& error) {
        refusal_ = std::string("no renderer here: ") + error.what();
      }
    return device_.has_value();
  }

  Spheres drawn(render::ViewState state) {
    render::Pictures pictures(*device_, {});
    state.display = render::Display::difference;
    pictures.update(state, {kPixels, kPixels});
    Spheres out;
    out.difference = png_file(pictures.capture(state, true));
    state.display = render::Display::flip;
    const render::BytePicture measured = pictures.capture(state);
    state.display = render::Display::picture;
    const render::BytePicture fitted = pictures.capture(state);
    out.measured = png_file(measured);
    out.fitted = png_file(fitted);
    out.small_measured = png_file(reduced(measured));
    out.small_fitted = png_file(reduced(fitted));
    out.notes = render::colour_notes(state);
    return out;
  }

  std::mutex mutex_;
  std::optional<render::Device> device_;
  std::string refusal_;  // why nothing can be drawn
};

Painter::Painter() : studio_(std::make_unique<Studio>()) {}
Painter::~Painter() = default;

bool Painter::can_draw() {
  return studio_->can_draw();
}

Spheres Painter::draw(const std::filesystem::path& samples, const std::string& name,
                      const Material& material) {
  return studio_->draw(samples, name, material);
}

}  // namespace brdf::study
