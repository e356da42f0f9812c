// Move-only owners of Vulkan objects, and the check that turns a failed call into an exception.
#pragma once

#include <vulkan/vulkan.h>

#include <utility>

namespace brdf::render {

// Throws EnvironmentError naming the call if the result is an error code.
void check(VkResult result, const char* call);

// A child of a device (or an instance), destroyed by the vkDestroy... function that matches its creation.
template <class T, class Parent = VkDevice>
class Owned {
 public:
  using Destroy = void(VKAPI_PTR*)(Parent, T, const VkAllocationCallbacks*);

  Owned() = default;
  Owned(Parent parent, T handle, Destroy destroy) : parent_(parent), handle_(handle), destroy_(destroy) {}
  Owned(Owned&& other) noexcept { swap(other); }
  Owned& operator=(Owned&& other) noexcept {
    Owned taken(std::move(other));
    swap(taken);
    return *this;
  }
  ~Owned() {
    if (handle_ != VK_NULL_HANDLE) destroy_(parent_, handle_, nullptr);
  }
  T get() const { return handle_; }
  explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }

 private:
  void swap(Owned& other) noexcept {
    std::swap(parent_, other.parent_);
    std::swap(handle_, other.handle_);
    std::swap(destroy_, other.destroy_);
  }
  Parent parent_ = VK_NULL_HANDLE;
  T handle_ = VK_NULL_HANDLE;
  Destroy destroy_ = nullptr;
};

template <class T>
using OwnedByInstance = Owned<T, VkInstance>;

// Creates and owns an object: owned(device, vkCreateSampler, vkDestroySampler, info, "vkCreateSampler").
template <class T, class Info>
Owned<T> owned(VkDevice device,
               VkResult(VKAPI_PTR* create)(VkDevice, const Info*, const VkAllocationCallbacks*, T*),
               void(VKAPI_PTR* destroy)(VkDevice, T, const VkAllocationCallbacks*), const Info& info,
               const char* call) {
  T handle = VK_NULL_HANDLE;
  check(create(device, &info, nullptr, &handle), call);
  return Owned<T>(device, handle, destroy);
}

}  // namespace brdf::render
