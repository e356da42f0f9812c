#include "render/compare/standing.h"

#include <cmath>

#include "render/compare/supersample.h"

namespace brdf::render {
namespace {

constexpr VkImageUsageFlags kShown =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

Picture picture_of(const VkExtent2D& size, const std::vector<float>& rgba) {
  return picture_from(int(size.width), int(size.height), rgba);
}

}  // namespace

Standing::Standing(Device& device, Renderer& renderer)
    : device_(&device),
      renderer_(&renderer),
      mean_(device, renderer.color()),
      shown_(device, kColorFormat, renderer.color().extent(), kShown) {}

int Standing::wanted(int across, int samples, int run) {
  const int places = across * across, runs = (samples + run - 1) / run;
  return (std::max(runs, 1) + places - 1) / places * places;
}

void Standing::draw_next(const PreparedScene& scene, int across, Timestamps* times, int run) {
  const std::vector<glm::vec2> places = sample_places(across);
  PreparedScene moved = scene;
  moved.scene.camera.offset = places[std::size_t(mean_.count()) % places.size()];
  renderer_->update(moved);
  renderer_->draw_samples(0, times, run * mean_.count(), run);
  device_->run([&](VkCommandBuffer commands) {
    mean_.record_add(commands);
    mean_.record_mean(commands, shown_, RunningMean::Over::black);
  });
}

double Standing::noise() {
  const Picture last = picture_of(shown_.extent(), renderer_->read_color());
  Picture mean = picture_of(shown_.extent(), read_rgba(*device_, shown_));
  for (std::size_t k = 0; k < mean.pixels.size(); ++k) mean.pixels[k].a = last.pixels[k].a;
  return noise_of(mean_.standard_error(), mean);
}

double noise_of(const std::vector<float>& errors, const Picture& picture) {
  double squares = 0, sum = 0, count = 0;
  for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
    if (!is_surface(picture.pixels[k])) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      squares += double(errors[4 * k + c]) * double(errors[4 * k + c]);
      sum += double(picture.pixels[k][int(c)]);
      ++count;
    }
  }
  return sum > 0 ? std::sqrt(squares / count) / (sum / count) : 0;
}

}  // namespace brdf::render
