#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>
#include <utility>

#include "render/viewer/controller.h"

namespace brdf::render {

void Controller::key(int key, int scancode, int action, int mods) {
  interface_->key(key, scancode, action, mods);
  if (action != GLFW_RELEASE) pressed(key, mods);
}

void Controller::pressed(int key, int mods) {
  wake();
  // A question was answered or closed, but Dear ImGui still requests text. Keys that arrive now are not
  // meant for the question.
  if (late_keys_.waiting() || prompts_.answered()) {
    late_keys_.add({key, mods});
    return;
  }
  if (prompts_.asking()) {
    prompts_.key(key);
    if (!prompts_.asking()) late_keys_.wait(2);
    return;
  }
  if (ImGui::GetIO().WantTextInput) {
    if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER || key == GLFW_KEY_ESCAPE) late_keys_.wait(3);
    return;
  }
  const Command* asked = command_of(key, mods);
  if (!asked) return;
  messages_.forget_error();
  settle();
  if (asked->edit) asked->edit(session_, whereabouts());
  follow();
  if (asked->request != Request::none) request(asked->request);
  opened_by_letter_ = prompts_.asking() && !(mods & GLFW_MOD_CONTROL);
}

void Controller::letter(unsigned code) {
  wake();
  if (!std::exchange(opened_by_letter_, false)) interface_->letter(code);
}

void Controller::scroll(double x, double y) {
  interface_->scroll(x, y);
  wake();
  if (ImGui::GetIO().WantCaptureMouse || !hand_.on(layout_.picture)) return;
  zoom(camera(), float(std::pow(0.9, y)));
  shown_.touch();
}

void Controller::button(int button, int action, int mods) {
  interface_->button(button, action, mods);
  wake();
  double x = 0, y = 0;
  glfwGetCursorPos(window_.get(), &x, &y);
  if (action == GLFW_RELEASE) {
    if (hand_.release() == Hand::Release::click) click();
    return;
  }
  messages_.forget_error();
  hand_.move(state(), layout_.picture, x, y);
  if (ImGui::GetIO().WantCaptureMouse || !hand_.on(layout_.picture)) return;
  probe_.reset();
  if (button == GLFW_MOUSE_BUTTON_MIDDLE || mods & GLFW_MOD_SHIFT) {
    probe_ = shown_.probe(state(), layout_.picture, hand_.place());
    probe_at_ = hand_.place();
    return;
  }
  settle();
  hand_.press(state(), layout_.picture, button, mods);
}

void Controller::click() {
  const PixelProbe probe = shown_.probe(state(), layout_.picture, hand_.place()).a;
  if (!probe.hit || probe.object == state().selected) return;
  state().selected = probe.object;
  messages_.say("selected " + object_name(state().scene.objects[probe.object], probe.object));
}

void Controller::cursor(double x, double y) {
  wake();
  hand_.move(state(), layout_.picture, x, y);
}

}  // namespace brdf::render
