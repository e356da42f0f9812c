#include "render/vulkan/timestamps.h"

#include <algorithm>

namespace brdf::render {

Timestamps::Timestamps(const Device& device, std::uint32_t most) : device_(&device), most_(most) {
  VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = most;
  pool_ = owned(device.get(), vkCreateQueryPool, vkDestroyQueryPool, info, "vkCreateQueryPool");
}

void Timestamps::begin(VkCommandBuffer commands) {
  vkCmdResetQueryPool(commands, pool_.get(), 0, most_);
  used_ = 0;
  names_.clear();
  write(commands);
}

void Timestamps::mark(VkCommandBuffer commands, const char* name) {
  if (used_ == 0 || used_ == most_) return;  // not begun, or full: later passes are not measured
  names_.push_back(name);
  write(commands);
}

void Timestamps::write(VkCommandBuffer commands) {
  vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_.get(), used_++);
}

std::vector<std::pair<std::string, double>> Timestamps::read() const {
  std::vector<std::pair<std::string, double>> out;
  if (used_ == 0) return out;
  std::vector<std::uint64_t> ticks(used_);
  check(vkGetQueryPoolResults(device_->get(), pool_.get(), 0, used_, ticks.size() * sizeof(std::uint64_t),
                              ticks.data(), sizeof(std::uint64_t),
                              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "vkGetQueryPoolResults");
  for (std::size_t k = 0; k + 1 < ticks.size(); ++k) {
    const double ms = double(ticks[k + 1] - ticks[k]) * device_->timestamp_period_ns() * 1e-6;
    const auto same = std::ranges::find_if(out, [&](const auto& entry) { return entry.first == names_[k]; });
    if (same != out.end()) {
      same->second += ms;
    } else {
      out.emplace_back(names_[k], ms);
    }
  }
  return out;
}

}  // namespace brdf::render
