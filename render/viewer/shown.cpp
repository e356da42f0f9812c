#include "render/viewer/shown.h"

#include <algorithm>

#include "render/viewer/history.h"

namespace brdf::render {
namespace {

constexpr std::chrono::milliseconds kRest{150};  // without movement, until all pixels are drawn

// Returns whether the objects have the same meshes, so that their pictures take similar times.
bool same_meshes(const Scene& a, const Scene& b) {
  return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                    [](const Object& x, const Object& y) { return x.mesh == y.mesh; });
}

// Preparing a measured B takes long and would be needed for both sizes; such a picture is never coarse.
bool can_be_coarse(const ViewState& state) {
  return state.other != Other::samples || state.display == Display::picture ||
         state.display == Display::gbuffer;
}

}  // namespace

Shown::Shown(Device& device, VkRenderPass render_pass, int gbuffer_bits, int samples)
    : fine_(device, {.gbuffer_bits = gbuffer_bits}, samples, {}, Effort::refining),
      coarse_(device, {.gbuffer_bits = gbuffer_bits, .coarse = true}, samples, {.supersample = 1},
              Effort::quick),
      display_(device, render_pass) {}

void Shown::touch() {
  moved_ = std::chrono::steady_clock::now();
}

void Shown::draw_coarse(const ViewState& state, VkExtent2D size) {
  const auto across = std::uint32_t(coarseness_.across());
  const double begun = Pace::steady_clock();
  coarse_.update(state, {std::max(size.width / across, 1u), std::max(size.height / across, 1u)});
  if (!last_ || !(last_->scene == state.scene)) coarseness_.took(Pace::steady_clock() - begun);
}

void Shown::update(const ViewState& state, VkExtent2D size, bool held) {
  const bool changed = last_ && !(last_->scene == state.scene);
  if (held && changed) touch();
  if (changed && !same_meshes(last_->scene, state.scene)) coarseness_ = {};
  const bool may_be_coarse = can_be_coarse(state);
  resting_ = !drawn_ || !may_be_coarse || std::chrono::steady_clock::now() - moved_ >= kRest;
  postponed_ = resting_ && changed && slow_ && may_be_coarse;
  size_ = size;
  if (resting_ && !postponed_) {
    fine_.update(state, size);
    if (changed || !last_) slow_ = !fine_.ready();
  }
  const bool coarse = may_be_coarse && (!resting_ || postponed_ || !fine_.ready());
  if (coarse) draw_coarse(state, size);
  last_ = state;
  Pictures& wanted = coarse ? coarse_ : fine_;
  const bool other = drawn_ != &wanted;
  drawn_ = &wanted;
  if (wanted.images_changed() || other)
    display_.show(wanted.a_image(), wanted.b_image(), wanted.has_targets() ? &wanted.a() : nullptr);
}

DisplayPass::Look Shown::look(const ViewState& state) const {
  const bool without_targets = state.display == Display::gbuffer && !drawn_->has_targets();
  return {.display = without_targets ? Display::picture : state.display,
          .tone_map = state.scene.tone_map,
          .exposure = state.scene.exposure,
          .split = state.split,
          .plus_minus = state.other == Other::samples,
          .pictures = drawn_->a().color().extent(),
          .object_extent = drawn_->extent(),
          .bits = drawn_->bits()};
}

void Shown::prepare(VkCommandBuffer commands, const ViewState& state, VkExtent2D place) {
  if (!drawn_) return;
  drawn_->prepare_to_sample(commands);
  display_.prepare(commands, look(state), place);
}

void Shown::record(VkCommandBuffer commands, const ViewState& state, const VkRect2D& place) {
  if (drawn_) display_.record(commands, look(state), place);
}

BytePicture Shown::capture(const ViewState& state) {
  moved_ = {};
  update(state, size_, false);
  if (postponed_) update(state, size_, false);
  return fine_.capture(state);
}

Shown::Probe Shown::probe(const ViewState& state, const Area& picture, const glm::vec2& place) const {
  if (!drawn_) return {};
  const PreparedScene& scene = drawn_->prepared();
  const Camera& camera = scene.scene.camera;
  const int x = int((place.x - picture.x) / picture.width * float(camera.width)),
            y = int((place.y - picture.y) / picture.height * float(camera.height));
  if (x < 0 || y < 0 || x >= camera.width || y >= camera.height) return {};
  Probe probe{pixel_probe(scene, x, y), {}};
  probe.b = drawn_->value_of_b(state, probe.a, x, y);
  return probe;
}

}  // namespace brdf::render
