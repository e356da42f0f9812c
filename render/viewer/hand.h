// The mouse on the picture: the target of a drag, and the effect of moving the mouse.
#pragma once

#include "render/viewer/layout.h"
#include "render/viewer/session.h"

namespace brdf::render {

class Hand {
 public:
  enum class Holds { nothing, camera, place, light, split_line };
  // Result of releasing the button: a click if the mouse was not moved.
  enum class Release { nothing, click };

  // Presses a button (GLFW's number) at the present place of the mouse.
  void press(const ViewState& state, const Area& picture, int button, int mods);
  Release release();
  // Moves the mouse to another place of the window, in pixels.
  void move(ViewState& state, const Area& picture, double x, double y);

  Holds holds() const { return holds_; }
  glm::vec2 place() const { return place_; }
  bool on(const Area& area) const;

 private:
  Holds holds_ = Holds::nothing;
  glm::vec2 place_{0}, pressed_at_{0};
  bool moved_ = false;
};

}  // namespace brdf::render
