#include "render/vulkan/device.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

#include "io/files/error.h"

namespace brdf::render {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL count_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                             VkDebugUtilsMessageTypeFlagsEXT,
                                             const VkDebugUtilsMessengerCallbackDataEXT* data,
                                             void* counter) {
  ++*static_cast<unsigned*>(counter);
  std::fprintf(stderr, "vulkan: %s\n", data->pMessage);
  return VK_FALSE;
}

bool layer_installed(const char* name) {
  std::uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::ranges::any_of(
      layers, [&](const VkLayerProperties& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

bool has_needed_features(VkPhysicalDevice physical, bool doubles) {
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physical, &properties);
  if (properties.apiVersion < VK_API_VERSION_1_3 || properties.limits.maxColorAttachments < 7) return false;
  VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features13};
  vkGetPhysicalDeviceFeatures2(physical, &features);
  return features13.dynamicRendering && features13.synchronization2 && features13.maintenance4 &&
         (!doubles || features.features.shaderFloat64);
}

// Returns the first queue family with graphics, or -1 if there is none.
int graphics_family(VkPhysicalDevice physical) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  for (std::uint32_t i = 0; i < count; ++i)
    if (families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) return int(i);
  return -1;
}

std::string megabytes(std::uint64_t bytes) {
  return std::to_string((bytes + (1u << 20) - 1) >> 20) + " MiB";
}

}  // namespace

void check(VkResult result, const char* call) {
  if (result >= 0) return;
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY)
    throw EnvironmentError(std::string("the Vulkan device is out of memory (") + call + ")");
  throw EnvironmentError(std::string(call) + " failed with VkResult " + std::to_string(int(result)));
}

Device::Device(const DeviceOptions& options) : memory_limit_(options.memory_limit) {
  create_instance(options);
  pick_physical_device(options.doubles);
  create_device(options);
}

void Device::create_instance(const DeviceOptions& options) {
  const VkApplicationInfo application{
      VK_STRUCTURE_TYPE_APPLICATION_INFO, nullptr, "brdf", 1, "brdf", 1, VK_API_VERSION_1_3};
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  std::vector<const char*> extensions = options.instance_extensions;
  const std::array enabled{VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  VkDebugUtilsMessengerCreateInfoEXT messages{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  messages.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messages.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  messages.pfnUserCallback = count_message;
  messages.pUserData = &validation_messages_;
  const VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT, &messages,
                                         std::uint32_t(enabled.size()), enabled.data()};
  if (options.validation) {
    if (!layer_installed(kValidationLayer)) {
      throw EnvironmentError(
          "the Vulkan validation layer is not installed (Debian: vulkan-validationlayers)");
    }
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    info.pNext = &features;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &kValidationLayer;
  }
  info.enabledExtensionCount = std::uint32_t(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  VkInstance instance = VK_NULL_HANDLE;
  const VkResult result = vkCreateInstance(&info, nullptr, &instance);
  if (result != VK_SUCCESS) {
    throw EnvironmentError("no Vulkan driver: vkCreateInstance failed with VkResult " +
                           std::to_string(int(result)) + " (Debian: mesa-vulkan-drivers)");
  }
  instance_.reset(instance);
  if (!options.validation) return;
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance, "vkCreateDebugUtilsMessengerEXT"));
  const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"));
  VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
  check(create(instance, &messages, nullptr, &messenger), "vkCreateDebugUtilsMessengerEXT");
  messenger_ = {instance, messenger, destroy};
}

void Device::pick_physical_device(bool doubles) {
  std::uint32_t count = 0;
  vkEnumeratePhysicalDevices(instance_.get(), &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(instance_.get(), &count, devices.data());
  const auto usable = std::ranges::find_if(devices, [&](VkPhysicalDevice device) {
    return has_needed_features(device, doubles) && graphics_family(device) >= 0;
  });
  if (usable == devices.end()) {
    throw EnvironmentError(
        count == 0 ? "no Vulkan driver found (Debian: mesa-vulkan-drivers; VK_DRIVER_FILES chooses one)"
        : doubles  ? "no Vulkan device offers version 1.3 and numbers of 64 bits in shaders"
                   : "no Vulkan device offers version 1.3 with dynamic rendering and synchronization2");
  }
  physical_ = *usable;
  queue_family_ = std::uint32_t(graphics_family(physical_));
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physical_, &properties);
  name_ = properties.deviceName;
  timestamp_period_ = properties.limits.timestampPeriod;
  max_image_size_ = properties.limits.maxImageDimension2D;
}

void Device::create_device(const DeviceOptions& options) {
  const float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = queue_family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  features13.dynamicRendering = VK_TRUE;
  features13.synchronization2 = VK_TRUE;
  features13.maintenance4 = VK_TRUE;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features13};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  VkPhysicalDeviceFeatures features{};
  features.shaderFloat64 = options.doubles;
  info.pEnabledFeatures = &features;
  const char* swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  if (!options.instance_extensions.empty()) {
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &swapchain;
  }
  VkDevice device = VK_NULL_HANDLE;
  check(vkCreateDevice(physical_, &info, nullptr, &device), "vkCreateDevice");
  device_.reset(device);
  vkGetDeviceQueue(device, queue_family_, 0, &queue_);
  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool.queueFamilyIndex = queue_family_;
  pool_ = owned(device, vkCreateCommandPool, vkDestroyCommandPool, pool, "vkCreateCommandPool");
}

void Device::run(const std::function<void(VkCommandBuffer)>& record) const {
  VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = pool_.get();
  allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocate.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  check(vkAllocateCommandBuffers(device_.get(), &allocate, &commands), "vkAllocateCommandBuffers");
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
  record(commands);
  check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
  VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  buffer.commandBuffer = commands;
  VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  submit.commandBufferInfoCount = 1;
  submit.pCommandBufferInfos = &buffer;
  check(vkQueueSubmit2(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit2");
  check(vkQueueWaitIdle(queue_), "vkQueueWaitIdle");
  vkFreeCommandBuffers(device_.get(), pool_.get(), 1, &commands);
}

bool Device::has_memory(std::uint64_t bytes) const {
  return memory_limit_ == 0 || memory_used_ + bytes <= memory_limit_;
}

void Device::require_memory(std::uint64_t bytes, const std::string& what) const {
  if (has_memory(bytes)) return;
  throw InputError(what + " needs " + megabytes(memory_used_ + bytes) +
                   " of device memory, but the limit is " + megabytes(memory_limit_) + " (--memory-limit)");
}

VkDeviceMemory Device::allocate(const VkMemoryAllocateInfo& info) {
  require_memory(info.allocationSize, "the scene");
  VkDeviceMemory memory = VK_NULL_HANDLE;
  check(vkAllocateMemory(device_.get(), &info, nullptr, &memory), "vkAllocateMemory");
  memory_used_ += info.allocationSize;
  return memory;
}

void Device::release(VkDeviceMemory memory, std::uint64_t bytes) {
  vkFreeMemory(device_.get(), memory, nullptr);
  memory_used_ -= bytes;
}

std::uint32_t Device::memory_type(std::uint32_t allowed, VkMemoryPropertyFlags flags) const {
  VkPhysicalDeviceMemoryProperties properties;
  vkGetPhysicalDeviceMemoryProperties(physical_, &properties);
  for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i)
    if ((allowed >> i & 1) && (properties.memoryTypes[i].propertyFlags & flags) == flags) return i;
  throw EnvironmentError("the Vulkan device has no memory of the required kind");
}

}  // namespace brdf::render
