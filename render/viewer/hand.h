// The mouse on the picture: what is held, and what moving it does.
#pragma once

#include "render/viewer/layout.h"
#include "render/viewer/session.h"

namespace brdf::render {

class Hand {
 public:
  enum class Holds { nothing, camera, place, light, split_line };
  // What the release of the button is: a click where nothing was moved.
  enum class Release { nothing, click };

  // A button of GLFW's at a place of the window, in pixels.
  void press(const ViewState& state, const Area& picture, int button, int mods);
  Release release();
  // To another place.
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
