// The pictures that the window shows: with fewer pixels during movements, with all pixels at rest.
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
  // Returns whether the last update drew fewer pixels.
  bool moving() const { return drawn_ == &coarse_; }
  bool unfinished() const { return !moving() && drawn_ && fine_.unfinished(); }
  const Pictures* drawn() const { return drawn_; }

  void prepare(VkCommandBuffer commands);
  void record(VkCommandBuffer commands, const ViewState& state, const VkRect2D& place);
  // Returns the picture at full size.
  BytePicture capture(const ViewState& state);
  // Probes the surface under a place of the window.
  PixelProbe probe(const Area& picture, const glm::vec2& place) const;

 private:
  Pictures fine_, coarse_;
  DisplayPass display_;
  Pictures* drawn_ = nullptr;
  std::optional<ViewState> last_;
  VkExtent2D size_{};
  std::chrono::steady_clock::time_point moved_{};
};

}  // namespace brdf::render
