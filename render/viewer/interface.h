// Dear ImGui with its GLFW and Vulkan backends.
#pragma once

#include <vector>

#include "render/viewer/window.h"

namespace brdf::render {

class Interface {
 public:
  // `scale`: of text and panels; 1 is 96 dots per inch. The window's callbacks forward their events; the
  // backend installs no callbacks of its own.
  Interface(Device& device, const Window& window, const Swapchain& swapchain, float scale);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  // Forwards a key event. Dear ImGui samples the keys once per frame. If a key is released in the same
  // frame in which it was pressed, the release is delayed until the next frame, so that a short tap is not
  // missed.
  void key(int key, int scancode, int action, int mods);
  // Adds a letter. Letters are kept for later frames while keep_letters() is set, because no text field
  // accepts them yet.
  void letter(unsigned code);
  void keep_letters(bool keep) { keep_letters_ = keep; }
  void scroll(double x, double y);
  void button(int button, int action, int mods);
  void entered(int entered);
  void focused(int focused);
  void begin_frame();
  // Call inside the swapchain's render pass, after ImGui::Render.
  void record(VkCommandBuffer commands);
  // Returns whether events wait for the next frame.
  bool waiting() const { return !late_.empty() || !due_.empty() || (!letters_.empty() && keep_letters_); }

 private:
  struct KeyEvent {
    int key, scancode, mods;
  };
  GLFWwindow* window_;
  Owned<VkDescriptorPool> pool_;
  bool keep_letters_ = false;
  std::vector<unsigned> letters_;
  std::vector<int> pressed_;          // since the last frame
  std::vector<KeyEvent> late_, due_;  // releases; due_: for the next frame
};

}  // namespace brdf::render
