#include "render/viewer/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "io/files/error.h"

// GLFW declares this function only if it includes Vulkan itself.
extern "C" VkResult glfwCreateWindowSurface(VkInstance, GLFWwindow*, const VkAllocationCallbacks*,
                                            VkSurfaceKHR*);

namespace brdf::render {
namespace {

std::string glfw_message() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "unknown reason";
}

Listener& listener_of(GLFWwindow* window) {
  return *static_cast<Listener*>(glfwGetWindowUserPointer(window));
}

Owned<VkRenderPass> make_render_pass(const Device& device, VkFormat format) {
  VkAttachmentDescription color{};
  color.format = format;
  color.samples = VK_SAMPLE_COUNT_1_BIT;
  color.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  color.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  color.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  color.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
  const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &reference;
  const VkSubpassDependency dependency{VK_SUBPASS_EXTERNAL,
                                       0,
                                       VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                       VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                       0,
                                       VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                                       0};
  VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
  info.attachmentCount = 1;
  info.pAttachments = &color;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  info.dependencyCount = 1;
  info.pDependencies = &dependency;
  return owned(device.get(), vkCreateRenderPass, vkDestroyRenderPass, info, "vkCreateRenderPass");
}

Owned<VkSemaphore> make_semaphore(const Device& device) {
  const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
  return owned(device.get(), vkCreateSemaphore, vkDestroySemaphore, info, "vkCreateSemaphore");
}

VkSurfaceFormatKHR pick_format(VkPhysicalDevice physical, VkSurfaceKHR surface) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, nullptr);
  std::vector<VkSurfaceFormatKHR> formats(count);
  vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, formats.data());
  for (const VkSurfaceFormatKHR& format : formats)
    if (format.format == VK_FORMAT_B8G8R8A8_UNORM || format.format == VK_FORMAT_R8G8B8A8_UNORM) return format;
  throw EnvironmentError("the window offers no 8-bit UNORM format");
}

}  // namespace

Window::Window(int width, int height, const std::string& title) {
  if (!glfwInit())
    throw EnvironmentError("a window cannot be opened, because there is no display (" + glfw_message() + ")");
  if (!glfwVulkanSupported()) {
    glfwTerminate();
    throw EnvironmentError("no Vulkan driver that can draw into windows");
  }
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string message = glfw_message();
    glfwTerminate();
    throw EnvironmentError("a window cannot be opened (" + message + ")");
  }
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::listen(Listener& listener) {
  glfwSetWindowUserPointer(window_, &listener);
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int code, int action, int mods) {
    listener_of(w).key(key, code, action, mods);
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned letter) { listener_of(w).letter(letter); });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) { listener_of(w).scroll(x, y); });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) { listener_of(w).cursor(x, y); });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
    listener_of(w).button(button, action, mods);
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** files) {
    listener_of(w).drop({files, files + count});
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) { listener_of(w).entered(entered); });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) { listener_of(w).focused(focused); });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { listener_of(w).refresh(); });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) {
    glfwSetWindowShouldClose(w, GLFW_FALSE);
    listener_of(w).close();
  });
}

std::vector<const char*> Window::instance_extensions() const {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names) throw EnvironmentError("no Vulkan driver that can draw into this display");
  return {names, names + count};
}

VkExtent2D Window::framebuffer_size() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {std::uint32_t(width), std::uint32_t(height)};
}

Swapchain::Swapchain(Device& device, const Window& window) : device_(&device), window_(&window) {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  check(glfwCreateWindowSurface(device.instance(), window.get(), nullptr, &surface),
        "glfwCreateWindowSurface");
  surface_ = {device.instance(), surface, vkDestroySurfaceKHR};
  VkBool32 supported = VK_FALSE;
  vkGetPhysicalDeviceSurfaceSupportKHR(device.physical(), device.queue_family(), surface, &supported);
  if (!supported) throw EnvironmentError("the Vulkan device cannot draw into this display");
  format_ = pick_format(device.physical(), surface);
  render_pass_ = make_render_pass(device, format_.format);
  acquired_ = make_semaphore(device);
  VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = device.command_pool();
  allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocate.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(device.get(), &allocate, &commands_), "vkAllocateCommandBuffers");
  create();
}

Swapchain::~Swapchain() {
  vkDeviceWaitIdle(device_->get());
}

void Swapchain::create() {
  vkDeviceWaitIdle(device_->get());
  frames_.clear();
  VkSurfaceCapabilitiesKHR capabilities;
  check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_->physical(), surface_.get(), &capabilities),
        "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
  extent_ = capabilities.currentExtent.width == 0xffffffffu ? window_->framebuffer_size()
                                                            : capabilities.currentExtent;
  VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = surface_.get();
  info.minImageCount = std::max(2u, capabilities.minImageCount);
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = extent_;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  info.preTransform = capabilities.currentTransform;
  info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
  info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
  info.clipped = VK_TRUE;
  info.oldSwapchain = swapchain_.get();
  swapchain_ =
      owned(device_->get(), vkCreateSwapchainKHR, vkDestroySwapchainKHR, info, "vkCreateSwapchainKHR");
  std::uint32_t count = 0;
  vkGetSwapchainImagesKHR(device_->get(), swapchain_.get(), &count, nullptr);
  std::vector<VkImage> images(count);
  vkGetSwapchainImagesKHR(device_->get(), swapchain_.get(), &count, images.data());
  for (const VkImage image : images) {
    Frame frame;
    VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = image;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format_.format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    frame.view = owned(device_->get(), vkCreateImageView, vkDestroyImageView, view, "vkCreateImageView");
    const VkImageView attachment = frame.view.get();
    VkFramebufferCreateInfo buffer{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    buffer.renderPass = render_pass_.get();
    buffer.attachmentCount = 1;
    buffer.pAttachments = &attachment;
    buffer.width = extent_.width;
    buffer.height = extent_.height;
    buffer.layers = 1;
    frame.framebuffer =
        owned(device_->get(), vkCreateFramebuffer, vkDestroyFramebuffer, buffer, "vkCreateFramebuffer");
    frame.finished = make_semaphore(*device_);
    frames_.push_back(std::move(frame));
  }
}

void Swapchain::record(VkCommandBuffer commands, const Frame& frame,
                       const std::function<void(VkCommandBuffer)>& before,
                       const std::function<void(VkCommandBuffer)>& inside) {
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
  before(commands);
  const VkClearValue clear{};
  VkRenderPassBeginInfo pass{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
  pass.renderPass = render_pass_.get();
  pass.framebuffer = frame.framebuffer.get();
  pass.renderArea.extent = extent_;
  pass.clearValueCount = 1;
  pass.pClearValues = &clear;
  vkCmdBeginRenderPass(commands, &pass, VK_SUBPASS_CONTENTS_INLINE);
  inside(commands);
  vkCmdEndRenderPass(commands);
  check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
}

void Swapchain::frame(const std::function<void(VkCommandBuffer)>& before,
                      const std::function<void(VkCommandBuffer)>& inside) {
  // Some drivers report neither OUT_OF_DATE nor SUBOPTIMAL. The sizes are therefore compared; the reports
  // of other drivers are used too.
  const VkExtent2D size = window_->framebuffer_size();
  if (size.width == 0 || size.height == 0) return;  // minimised
  if (size.width != extent_.width || size.height != extent_.height) create();
  std::uint32_t index = 0;
  VkResult result =
      vkAcquireNextImageKHR(device_->get(), swapchain_.get(), ~0ull, acquired_.get(), VK_NULL_HANDLE, &index);
  if (result == VK_ERROR_OUT_OF_DATE_KHR) {
    create();
    return;
  }
  check(result, "vkAcquireNextImageKHR");
  record(commands_, frames_[index], before, inside);
  VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  buffer.commandBuffer = commands_;
  VkSemaphoreSubmitInfo wait{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
  wait.semaphore = acquired_.get();
  wait.stageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
  VkSemaphoreSubmitInfo signal{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
  signal.semaphore = frames_[index].finished.get();
  signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  submit.waitSemaphoreInfoCount = submit.signalSemaphoreInfoCount = submit.commandBufferInfoCount = 1;
  submit.pWaitSemaphoreInfos = &wait;
  submit.pSignalSemaphoreInfos = &signal;
  submit.pCommandBufferInfos = &buffer;
  check(vkQueueSubmit2(device_->queue(), 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit2");
  const VkSwapchainKHR swapchain = swapchain_.get();
  const VkSemaphore finished = frames_[index].finished.get();
  VkPresentInfoKHR present{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  present.waitSemaphoreCount = 1;
  present.pWaitSemaphores = &finished;
  present.swapchainCount = 1;
  present.pSwapchains = &swapchain;
  present.pImageIndices = &index;
  result = vkQueuePresentKHR(device_->queue(), &present);
  if (result != VK_ERROR_OUT_OF_DATE_KHR) check(result, "vkQueuePresentKHR");
  check(vkQueueWaitIdle(device_->queue()), "vkQueueWaitIdle");
}

}  // namespace brdf::render
