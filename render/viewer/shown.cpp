#include "render/viewer/shown.h"

#include <algorithm>

#include "render/viewer/history.h"

namespace brdf::render {
namespace {

constexpr std::chrono::milliseconds kRest{150};  // without movement, until all pixels are drawn
constexpr std::uint32_t kCoarse = 2;             // pixels of the window across one drawn pixel

// Preparing a measured B takes long and would be needed for both sizes; such a picture is never coarse.
bool can_be_coarse(const ViewState& state) {
  return state.other != Other::samples || state.display == Display::picture ||
         state.display == Display::gbuffer;
}

}  // namespace

Shown::Shown(Device& device, VkRenderPass render_pass, int gbuffer_bits, int samples)
    : fine_(device, {.gbuffer_bits = gbuffer_bits}, samples, {}, true),
      coarse_(device, {.gbuffer_bits = gbuffer_bits}, samples, {.supersample = 1}, true),
      display_(device, render_pass) {}

void Shown::touch() {
  moved_ = std::chrono::steady_clock::now();
}

void Shown::update(const ViewState& state, VkExtent2D size, bool held) {
  if (held && last_ && !(last_->scene == state.scene)) touch();
  const bool coarse = drawn_ && can_be_coarse(state) && std::chrono::steady_clock::now() - moved_ < kRest;
  Pictures& wanted = coarse ? coarse_ : fine_;
  size_ = size;
  if (coarse) size = {std::max(size.width / kCoarse, 1u), std::max(size.height / kCoarse, 1u)};
  wanted.update(state, size);
  last_ = state;
  const bool other = drawn_ != &wanted;
  drawn_ = &wanted;
  if (wanted.images_changed() || other)
    display_.show(wanted.a_image(), wanted.b_image(), wanted.has_targets() ? &wanted.a() : nullptr);
}

void Shown::prepare(VkCommandBuffer commands) {
  if (drawn_) drawn_->prepare_to_sample(commands);
}

void Shown::record(VkCommandBuffer commands, const ViewState& state, const VkRect2D& place) {
  if (!drawn_) return;
  ViewState shown = state;
  if (shown.display == Display::gbuffer && !drawn_->has_targets()) shown.display = Display::picture;
  display_.record(commands, shown, place, drawn_->a().color().extent(), drawn_->extent(), drawn_->bits());
}

BytePicture Shown::capture(const ViewState& state) {
  moved_ = {};
  update(state, size_, false);
  return fine_.capture(state);
}

PixelProbe Shown::probe(const Area& picture, const glm::vec2& place) const {
  if (!drawn_) return {};
  const PreparedScene& scene = drawn_->prepared();
  const Camera& camera = scene.scene.camera;
  const int x = int((place.x - picture.x) / picture.width * float(camera.width)),
            y = int((place.y - picture.y) / picture.height * float(camera.height));
  if (x < 0 || y < 0 || x >= camera.width || y >= camera.height) return {};
  return pixel_probe(scene, x, y);
}

}  // namespace brdf::render
