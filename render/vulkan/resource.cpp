#include "render/vulkan/resource.h"

#include <Imath/half.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace brdf::render {
namespace {

struct UseInfo {
  VkImageLayout layout;
  VkPipelineStageFlags2 stages;
  VkAccessFlags2 access;
};

UseInfo use_info(Use use) {
  constexpr VkPipelineStageFlags2 kDepthStages =
      VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
  switch (use) {
    case Use::color_attachment:
      return {VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
              VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT};
    case Use::depth_attachment:
      return {VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, kDepthStages,
              VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
    case Use::sampled:
      return {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
              VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
    case Use::transfer_source:
      return {VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
              VK_ACCESS_2_TRANSFER_READ_BIT};
    case Use::transfer_destination:
      return {VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
              VK_ACCESS_2_TRANSFER_WRITE_BIT};
    case Use::present:
      return {VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE};
    case Use::undefined:
      break;
  }
  return {VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE};
}

VkBufferImageCopy whole_image(VkExtent2D extent) {
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {extent.width, extent.height, 1};
  return region;
}

VkImageAspectFlags aspect_of(VkFormat format) {
  return format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

template <class T, class Convert>
std::vector<float> converted(const std::byte* data, std::size_t count, Convert convert) {
  std::vector<float> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, data + i * sizeof(T), sizeof(T));
    out[i] = convert(value);
  }
  return out;
}

}  // namespace

Memory::Memory(Device& device, const VkMemoryRequirements& needs, VkMemoryPropertyFlags flags,
               const VkMemoryDedicatedAllocateInfo& dedicated)
    : device_(&device), size_(needs.size) {
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, &dedicated};
  info.allocationSize = needs.size;
  info.memoryTypeIndex = device.memory_type(needs.memoryTypeBits, flags);
  memory_ = device.allocate(info);
}

Memory::Memory(Memory&& other) noexcept
    : device_(std::exchange(other.device_, nullptr)), memory_(other.memory_), size_(other.size_) {}

Memory& Memory::operator=(Memory&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(memory_, other.memory_);
  std::swap(size_, other.size_);
  return *this;
}

Memory::~Memory() {
  if (device_) device_->release(memory_, size_);
}

Buffer::Buffer(Device& device, VkDeviceSize size, VkBufferUsageFlags usage) : size_(size) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = size;
  info.usage = usage;
  buffer_ = owned(device.get(), vkCreateBuffer, vkDestroyBuffer, info, "vkCreateBuffer");
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device.get(), buffer_.get(), &needs);
  VkMemoryDedicatedAllocateInfo dedicated{VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO};
  dedicated.buffer = buffer_.get();
  memory_ = Memory(device, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                   dedicated);
  check(vkBindBufferMemory(device.get(), buffer_.get(), memory_.get(), 0), "vkBindBufferMemory");
  void* mapped = nullptr;
  check(vkMapMemory(device.get(), memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
  mapped_ = static_cast<std::byte*>(mapped);
}

Image::Image(Device& device, VkFormat format, VkExtent2D extent, VkImageUsageFlags usage)
    : format_(format), extent_(extent) {
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {extent.width, extent.height, 1};
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = usage;
  image_ = owned(device.get(), vkCreateImage, vkDestroyImage, info, "vkCreateImage");
  VkMemoryRequirements needs;
  vkGetImageMemoryRequirements(device.get(), image_.get(), &needs);
  VkMemoryDedicatedAllocateInfo dedicated{VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO};
  dedicated.image = image_.get();
  memory_ = Memory(device, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, dedicated);
  check(vkBindImageMemory(device.get(), image_.get(), memory_.get(), 0), "vkBindImageMemory");
  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = image_.get();
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = format;
  view.subresourceRange = {aspect_of(format), 0, 1, 0, 1};
  view_ = owned(device.get(), vkCreateImageView, vkDestroyImageView, view, "vkCreateImageView");
}

void transition(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, Use before, Use next,
                bool discard) {
  const UseInfo from = use_info(before), to = use_info(next);
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = from.stages;
  barrier.srcAccessMask = from.access;
  barrier.dstStageMask = to.stages;
  barrier.dstAccessMask = to.access;
  barrier.oldLayout = discard ? VK_IMAGE_LAYOUT_UNDEFINED : from.layout;
  barrier.newLayout = to.layout;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {aspect, 0, 1, 0, 1};
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

void Image::transition(VkCommandBuffer commands, Use next, bool discard) {
  render::transition(commands, get(), aspect_of(format_), use_, next, discard);
  use_ = next;
}

int texel_size(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R16G16B16A16_SFLOAT:
      return 8;
    case VK_FORMAT_R32G32B32A32_SFLOAT:
      return 16;
    case VK_FORMAT_R8_UNORM:
      return 1;
    default:
      return 4;
  }
}

void make_visible_to_host(VkCommandBuffer commands, VkPipelineStageFlags2 stage, VkAccessFlags2 access) {
  VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  barrier.srcStageMask = stage;
  barrier.srcAccessMask = access;
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = 1;
  dependency.pMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

void upload(Device& device, Image& image, std::span<const std::byte> texels) {
  const Buffer staging = make_buffer(device, texels, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  device.run([&](VkCommandBuffer commands) {
    image.transition(commands, Use::transfer_destination, true);
    const VkBufferImageCopy region = whole_image(image.extent());
    vkCmdCopyBufferToImage(commands, staging.get(), image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                           &region);
    image.transition(commands, Use::sampled);
  });
}

std::vector<float> read_rgba(Device& device, Image& image) {
  const std::size_t pixels = std::size_t(image.extent().width) * image.extent().height;
  const Buffer staging(device, pixels * std::size_t(texel_size(image.format())),
                       VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  device.run([&](VkCommandBuffer commands) {
    image.transition(commands, Use::transfer_source);
    const VkBufferImageCopy region = whole_image(image.extent());
    vkCmdCopyImageToBuffer(commands, image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, staging.get(), 1,
                           &region);
    make_visible_to_host(commands, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
  });
  switch (image.format()) {
    case VK_FORMAT_R16G16B16A16_SFLOAT:
      return converted<Imath::half>(staging.data(), pixels * 4, [](Imath::half h) { return float(h); });
    case VK_FORMAT_R32G32B32A32_SFLOAT:
      return converted<float>(staging.data(), pixels * 4, [](float f) { return f; });
    default:
      return converted<std::uint8_t>(staging.data(), pixels * 4,
                                     [](std::uint8_t b) { return float(b) / 255; });
  }
}

}  // namespace brdf::render
