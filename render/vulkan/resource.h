// Buffers and images, each with its own allocation, and the commands that fill, transfer and read them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/vulkan/device.h"

namespace brdf::render {

// Device memory bound to one buffer or image.
class Memory {
 public:
  Memory() = default;
  Memory(Device& device, const VkMemoryRequirements& needs, VkMemoryPropertyFlags flags,
         const VkMemoryDedicatedAllocateInfo& dedicated);
  Memory(Memory&& other) noexcept;
  Memory& operator=(Memory&& other) noexcept;
  ~Memory();
  VkDeviceMemory get() const { return memory_; }

 private:
  Device* device_ = nullptr;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  VkDeviceSize size_ = 0;
};

// A host-visible, permanently mapped buffer for geometry, parameters and read-back; the device of this
// renderer is usually the CPU.
class Buffer {
 public:
  Buffer() = default;
  Buffer(Device& device, VkDeviceSize size, VkBufferUsageFlags usage);
  VkBuffer get() const { return buffer_.get(); }
  VkDeviceSize size() const { return size_; }
  std::byte* data() const { return mapped_; }
  explicit operator bool() const { return bool(buffer_); }

 private:
  // Declared first: the buffer is destroyed before its memory.
  Memory memory_;
  Owned<VkBuffer> buffer_;
  VkDeviceSize size_ = 0;
  std::byte* mapped_ = nullptr;
};

template <class T>
Buffer make_buffer(Device& device, std::span<const T> values, VkBufferUsageFlags usage) {
  Buffer buffer(device, values.size_bytes() > 0 ? values.size_bytes() : sizeof(T), usage);
  std::copy(values.begin(), values.end(), reinterpret_cast<T*>(buffer.data()));
  return buffer;
}

// The use of an image by a command, which determines layout, stages and access.
enum class Use {
  undefined,
  color_attachment,
  depth_attachment,
  sampled,
  transfer_source,
  transfer_destination,
  present
};

// A two-dimensional image with one mip level and a view of the whole image.
class Image {
 public:
  Image() = default;
  Image(Device& device, VkFormat format, VkExtent2D extent, VkImageUsageFlags usage);
  VkImage get() const { return image_.get(); }
  VkImageView view() const { return view_.get(); }
  VkFormat format() const { return format_; }
  VkExtent2D extent() const { return extent_; }
  explicit operator bool() const { return bool(image_); }
  // Records the barrier between the last recorded use and the next; contents are kept unless discard is
  // set.
  void transition(VkCommandBuffer commands, Use next, bool discard = false);

 private:
  Memory memory_;
  Owned<VkImage> image_;
  Owned<VkImageView> view_;
  VkFormat format_ = VK_FORMAT_UNDEFINED;
  VkExtent2D extent_{};
  Use use_ = Use::undefined;
};

// Records only the barrier, for images owned by others (a swapchain's).
void transition(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, Use before, Use next,
                bool discard);

// Makes the output of a stage readable through mapped memory after the commands have run.
void make_visible_to_host(VkCommandBuffer commands, VkPipelineStageFlags2 stage, VkAccessFlags2 access);

int texel_size(VkFormat format);  // bytes
// Copies texels, row by row from the top, into the image, which can then be sampled.
void upload(Device& device, Image& image, std::span<const std::byte> texels);
// Reads a four-channel image (16F, 32F or 8-bit) back as floats, row by row from the top.
std::vector<float> read_rgba(Device& device, Image& image);

}  // namespace brdf::render
