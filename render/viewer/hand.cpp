#include "render/viewer/hand.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace brdf::render {
namespace {

constexpr float kNearLine = 8, kStill = 4;  // pixels
constexpr float kTurnPerPixel = 0.008f;     // radians per pixel

}  // namespace

bool Hand::on(const Area& a) const {
  return place_.x >= a.x && place_.y >= a.y && place_.x < a.x + a.width && place_.y < a.y + a.height;
}

void Hand::press(const ViewState& state, const Area& picture, int button, int mods) {
  pressed_at_ = place_;
  moved_ = false;
  const float line = picture.x + state.split * picture.width;
  if (button == GLFW_MOUSE_BUTTON_RIGHT)
    holds_ = Holds::place;
  else if (button != GLFW_MOUSE_BUTTON_LEFT)
    holds_ = Holds::nothing;
  else if (mods & GLFW_MOD_CONTROL)
    holds_ = Holds::light;
  else if (state.display == Display::split && std::abs(place_.x - line) <= kNearLine)
    holds_ = Holds::split_line;
  else
    holds_ = Holds::camera;
}

Hand::Release Hand::release() {
  const bool click = holds_ == Holds::camera && !moved_;
  holds_ = Holds::nothing;
  return click ? Release::click : Release::nothing;
}

void Hand::move(ViewState& state, const Area& picture, double x, double y) {
  const glm::vec2 before = place_;
  place_ = {float(x), float(y)};
  if (holds_ == Holds::nothing) return;
  // Until the mouse has moved by kStill pixels, the movement counts as the trembling of a click.
  if (!moved_ && glm::length(place_ - pressed_at_) < kStill) return;
  const glm::vec2 by = place_ - (std::exchange(moved_, true) ? before : pressed_at_);
  Camera& camera = state.scene.camera;
  if (holds_ == Holds::split_line)
    state.split = glm::clamp((place_.x - picture.x) / std::max(picture.width, 1.0f), 0.0f, 1.0f);
  if (holds_ == Holds::camera) orbit(camera, -by.x * kTurnPerPixel, by.y * kTurnPerPixel);
  if (holds_ == Holds::light) turn_light(state.scene, by.x * kTurnPerPixel, by.y * kTurnPerPixel);
  if (holds_ == Holds::place)
    pan(camera, by / glm::vec2(std::max(picture.width, 1.0f), std::max(picture.height, 1.0f)));
}

}  // namespace brdf::render
