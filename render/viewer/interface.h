// Dear ImGui with its GLFW and Vulkan backends.
#pragma once

#include <vector>

#include "render/viewer/window.h"

namespace brdf::render {

class Interface {
 public:
  // `scale`: of text and panels; 1 is 96 dots per inch. The window's callbacks hand over what they hear: the
  // backend installs none of its own.
  Interface(Device& device, const Window& window, const Swapchain& swapchain, float scale);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  // A key's event. Dear ImGui looks at the keys once a frame: the release of one that was pressed since the
  // last frame waits for the next, so that a short tap is not missed.
  void key(int key, int scancode, int action, int mods);
  // A letter; where nobody takes it yet it is kept for the next frames.
  void letter(unsigned code);
  void keep_letters(bool keep) { keep_letters_ = keep; }
  void scroll(double x, double y);
  void button(int button, int action, int mods);
  void entered(int entered);
  void focused(int focused);
  void begin_frame();
  // Inside the swapchain's render pass, after ImGui::Render.
  void record(VkCommandBuffer commands);
  // Whether something waits for the next frame.
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
  std::vector<KeyEvent> late_, due_;  // releases; due: with the next frame
};

}  // namespace brdf::render
