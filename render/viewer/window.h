// The window and its swapchain.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "render/vulkan/pipeline.h"
#include "render/vulkan/resource.h"

struct GLFWwindow;

namespace brdf::render {

// Receives the events of a window; numbers are those of GLFW.
class Listener {
 public:
  virtual void key(int key, int scancode, int action, int mods) = 0;
  virtual void letter(unsigned code) = 0;
  virtual void scroll(double x, double y) = 0;
  virtual void cursor(double x, double y) = 0;
  virtual void button(int button, int action, int mods) = 0;
  virtual void drop(const std::vector<std::filesystem::path>& files) = 0;
  virtual void entered(int entered) = 0;
  virtual void focused(int focused) = 0;
  virtual void refresh() = 0;
  virtual void close() = 0;  // closing was requested; the window stays open

 protected:
  ~Listener() = default;
};

class Window {
 public:
  // Throws EnvironmentError if there is no display.
  Window(int width, int height, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // Sets the listener, which must outlive the window.
  void listen(Listener& listener);

  GLFWwindow* get() const { return window_; }
  std::vector<const char*> instance_extensions() const;
  VkExtent2D framebuffer_size() const;

 private:
  GLFWwindow* window_ = nullptr;
};

// Images to draw into, with one classic render pass (required by this version of Dear ImGui's backend).
// Formats are UNORM: shaders encode.
class Swapchain {
 public:
  Swapchain(Device& device, const Window& window);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  VkRenderPass render_pass() const { return render_pass_.get(); }
  VkExtent2D extent() const { return extent_; }
  std::uint32_t image_count() const { return std::uint32_t(frames_.size()); }
  // Records into a fresh command buffer, submits, presents, and waits for the device. `before` runs outside
  // the render pass, `inside` within it. Remakes the swapchain first if the window's size has changed.
  void frame(const std::function<void(VkCommandBuffer)>& before,
             const std::function<void(VkCommandBuffer)>& inside);

 private:
  struct Frame {
    Owned<VkImageView> view;
    Owned<VkFramebuffer> framebuffer;
    Owned<VkSemaphore> finished;
  };
  void create();
  void record(VkCommandBuffer commands, const Frame& frame,
              const std::function<void(VkCommandBuffer)>& before,
              const std::function<void(VkCommandBuffer)>& inside);

  Device* device_;
  const Window* window_;
  OwnedByInstance<VkSurfaceKHR> surface_;
  VkSurfaceFormatKHR format_{};
  VkExtent2D extent_{};
  Owned<VkRenderPass> render_pass_;
  Owned<VkSwapchainKHR> swapchain_;
  std::vector<Frame> frames_;
  Owned<VkSemaphore> acquired_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

}  // namespace brdf::render
