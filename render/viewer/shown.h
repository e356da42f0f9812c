// The pictures that the window shows: with fewer pixels during movements, and until the first picture with
// all pixels is complete.
#pragma once

#include <chrono>

#include "render/compare/pictures.h"
#include "render/reference/reference.h"
#include "render/viewer/display_pass.h"
#include "render/viewer/layout.h"

namespace brdf::render {

class Shown {
 public:
  Shown(Device& device, VkRenderPass render_pass, int gbuffer_bits, int samples);

  // Draws the pictures of the state at this size, in pixels. `held`: the user or an animation is changing
  // the state. Throws InputError as Pictures::update does.
  void update(const ViewState& state, VkExtent2D size, bool held);
  // Call after a single movement, such as a turn of the wheel: further movements may follow.
  void touch();
  // Returns whether the view moved a moment ago, so that only coarse pictures are drawn.
  bool moving() const { return drawn_ && !resting_; }
  // Returns whether the shown picture has fewer pixels than the window.
  bool coarse() const { return drawn_ == &coarse_; }
  bool unfinished() const { return drawn_ && resting_ && (postponed_ || fine_.unfinished()); }
  const Pictures* drawn() const { return drawn_; }

  // Both for the same place in the window, in pixels; prepare() before the window's own pass.
  void prepare(VkCommandBuffer commands, const ViewState& state, VkExtent2D place);
  void record(VkCommandBuffer commands, const ViewState& state, const VkRect2D& place);
  // Returns the picture at full size.
  BytePicture capture(const ViewState& state);
  // Probes the surface of A under a place of the window, and f_r of B there if B is shown.
  struct Probe {
    PixelProbe a;
    std::optional<Pictures::ProbedValue> b;
  };
  Probe probe(const ViewState& state, const Area& picture, const glm::vec2& place) const;

 private:
  DisplayPass::Look look(const ViewState& state) const;
  void draw_coarse(const ViewState& state, VkExtent2D size);

  Pictures fine_, coarse_;
  Coarseness coarseness_;
  DisplayPass display_;
  Pictures* drawn_ = nullptr;
  std::optional<ViewState> last_;
  bool resting_ = true;
  bool slow_ = false;       // the first fine picture of the last change took more than a frame
  bool postponed_ = false;  // the fine picture begins with the next frame
  VkExtent2D size_{};
  std::chrono::steady_clock::time_point moved_{};
};

}  // namespace brdf::render
