// The Vulkan instance and device: headless by default, with a surface if the viewer passes its instance
// extensions.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/vulkan/handle.h"

namespace brdf::render {

struct DeviceOptions {
  std::vector<const char*> instance_extensions;  // of the window system; empty: headless
  std::uint64_t memory_limit = 0;                // bytes of device memory, 0: no limit
  bool validation = false;  // validation and synchronisation layers; counts their messages
  bool doubles = false;     // shaders compute in double
};

class Device {
 public:
  // Takes the first device with Vulkan 1.3, dynamic rendering, synchronization2, maintenance4 and at least
  // seven colour attachments (VK_DRIVER_FILES chooses the driver). Throws EnvironmentError if there is no
  // such device (one that also computes in double, if requested), or if validation is requested and the layer
  // is not installed.
  explicit Device(const DeviceOptions& options = {});
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkInstance instance() const { return instance_.get(); }
  VkPhysicalDevice physical() const { return physical_; }
  VkDevice get() const { return device_.get(); }
  VkQueue queue() const { return queue_; }
  std::uint32_t queue_family() const { return queue_family_; }
  VkCommandPool command_pool() const { return pool_.get(); }
  const std::string& name() const { return name_; }
  double timestamp_period_ns() const { return timestamp_period_; }
  std::uint32_t max_image_size() const { return max_image_size_; }
  // Returns the number of messages of the validation layers so far; always 0 without validation.
  unsigned validation_messages() const { return validation_messages_; }

  // Records commands, submits them and waits until they have run.
  void run(const std::function<void(VkCommandBuffer)>& record) const;

  // Throws InputError if `bytes` more would exceed the memory limit. All allocations of this program use
  // this function.
  VkDeviceMemory allocate(const VkMemoryAllocateInfo& info);
  void release(VkDeviceMemory memory, std::uint64_t bytes);
  std::uint64_t memory_used() const { return memory_used_; }
  // Check only the limit, in advance, before anything is allocated.
  bool has_memory(std::uint64_t bytes) const;
  void require_memory(std::uint64_t bytes, const std::string& what) const;
  std::uint32_t memory_type(std::uint32_t allowed, VkMemoryPropertyFlags flags) const;

 private:
  void create_instance(const DeviceOptions& options);
  void pick_physical_device(bool doubles);
  void create_device(const DeviceOptions& options);

  struct Destroy {
    void operator()(VkInstance instance) const { vkDestroyInstance(instance, nullptr); }
    void operator()(VkDevice device) const { vkDestroyDevice(device, nullptr); }
  };
  // Members are destroyed before the objects from which they were created, also if the constructor throws.
  std::unique_ptr<VkInstance_T, Destroy> instance_;
  OwnedByInstance<VkDebugUtilsMessengerEXT> messenger_;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  std::unique_ptr<VkDevice_T, Destroy> device_;
  VkQueue queue_ = VK_NULL_HANDLE;
  Owned<VkCommandPool> pool_;
  std::uint32_t queue_family_ = 0;
  std::uint32_t max_image_size_ = 0;
  double timestamp_period_ = 1;
  std::string name_;
  std::uint64_t memory_limit_ = 0, memory_used_ = 0;
  unsigned validation_messages_ = 0;
};

}  // namespace brdf::render
