// Times of the passes of a frame, measured by timestamp queries.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/vulkan/device.h"

namespace brdf::render {

class Timestamps {
 public:
  explicit Timestamps(const Device& device, std::uint32_t most = 32);
  // Call first in a frame's commands.
  void begin(VkCommandBuffer commands);
  // Names the work since the last mark (or begin) `name`.
  void mark(VkCommandBuffer commands, const char* name);
  // Returns milliseconds in order, after the commands have run; times with equal names are added up.
  std::vector<std::pair<std::string, double>> read() const;

 private:
  void write(VkCommandBuffer commands);

  const Device* device_;
  Owned<VkQueryPool> pool_;
  std::uint32_t most_, used_ = 0;
  std::vector<const char*> names_;
};

}  // namespace brdf::render
