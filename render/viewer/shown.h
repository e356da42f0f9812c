// The pictures that the window shows: of fewer pixels while something moves, of all when it rests.
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

  // Draws what the state needs at this size; `held`: somebody moves something. Throws InputError as
  // Pictures::update.
  void update(const ViewState& state, VkExtent2D size, bool held);
  // Something was moved by a step of its own: more may come.
  void touch();
  // Whether the last update drew fewer pixels.
  bool moving() const { return drawn_ == &coarse_; }
  bool unfinished() const { return !moving() && drawn_ && fine_.unfinished(); }
  const Pictures* drawn() const { return drawn_; }

  void prepare(VkCommandBuffer commands);
  void record(VkCommandBuffer commands, const ViewState& state, const VkRect2D& place);
  // At full size.
  BytePicture capture(const ViewState& state);
  // Under a place of the window.
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
