// Dear ImGui with its GLFW and Vulkan backends.
#pragma once

#include "render/viewer/window.h"

namespace brdf::render {

class Interface {
 public:
  // After the window's own callbacks are set: the backend chains to those that are there.
  Interface(Device& device, const Window& window, const Swapchain& swapchain);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  void begin_frame();
  // Inside the swapchain's render pass, after ImGui::Render.
  void record(VkCommandBuffer commands);

 private:
  Owned<VkDescriptorPool> pool_;
};

}  // namespace brdf::render
