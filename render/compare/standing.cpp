#include "render/compare/standing.h"

#include <algorithm>
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

StandingPlan standing_plan(int across, int samples) {
  const int places = across * across, of_a_place = std::max((samples + places - 1) / places, 1);
  const int rounds = (of_a_place + kRun - 1) / kRun;
  return {rounds * places, across, (of_a_place + rounds - 1) / rounds};
}

PlaceRun run_of(const StandingPlan& plan, int k, int first) {
  const int places = plan.across * plan.across, place = k % places, round = k / places;
  PlaceRun run{plan.run, first + round * places * plan.run + place, places, 1};
  // The halves of an odd run are unequal. Every other run has its larger half in the second half of the sum,
  // and of an odd number of places, the last one is left out.
  if (run.samples % 2 == 1)
    run.sign = place % 2 == 1 ? -1.0f : place + 1 == places && places > 1 ? 0.0f : 1.0f;
  return run;
}

Standing::Standing(Device& device, Renderer& renderer, const StandingPlan& plan)
    : device_(&device),
      renderer_(&renderer),
      plan_(plan),
      mean_(device, renderer.color()),
      smooth_(device, kColorFormat, renderer.color().extent(), kShown),
      shown_(device, kColorFormat, renderer.color().extent(), kShown) {}

void Standing::reset() {
  mean_.reset();
  smooth_done_ = false;
  part_ = 0;
}

void Standing::begin_picture(const PreparedScene& scene) {
  PreparedScene moved = scene;
  if (smooth_done_) {
    const std::vector<glm::vec2> places = sample_places(plan_.across);
    moved.scene.camera.offset = places[std::size_t(mean_.count()) % places.size()];
  }
  renderer_->update(moved);
  if (smooth_done_)
    renderer_->begin_run(run_of(plan_, mean_.count()));
  else
    renderer_->begin_smooth();
}

void Standing::end_picture() {
  device_->run([&](VkCommandBuffer commands) {
    if (!smooth_done_) {
      for (Image* image : {&smooth_, &shown_}) mean_.record_copy(commands, *image);
      return;
    }
    mean_.record_add(commands);
    mean_.record_mean(commands, shown_, RunningMean::Over::black, float(share()));
    if (share() < 1) mean_.record_share(commands, smooth_, shown_, float(1 - share()));
  });
  smooth_done_ = true;
  part_ = 0;
}

bool Standing::go_on(const PreparedScene& scene, Pace& pace, Timestamps* times) {
  while (!finished()) {
    if (part_ == 0) begin_picture(scene);
    PartTimes& known = smooth_done_ ? run_times_ : smooth_times_;
    const int parts = renderer_->parts(), count = pace.next(known, part_, parts);
    if (count == 0) return false;
    renderer_->draw_parts(part_, count, times);
    pace.took(known, part_, count);
    part_ += count;
    if (part_ < parts) continue;
    end_picture();
    return true;
  }
  return false;
}

Picture Standing::picture() {
  const Picture last = picture_of(shown_.extent(), renderer_->read_color());
  Picture shown = picture_of(shown_.extent(), read_rgba(*device_, shown_));
  for (std::size_t k = 0; k < shown.pixels.size(); ++k) shown.pixels[k].a = last.pixels[k].a;
  return shown;
}

double Standing::noise() {
  return share() * noise_of(mean_.standard_error(), picture());
}

std::uint64_t standing_bytes(std::uint64_t pixels) {
  constexpr std::uint64_t kImages = 4;  // two sums, the smooth picture, the shown one
  return kImages * pixels * std::uint64_t(texel_size(kColorFormat));
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
