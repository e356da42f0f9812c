#include "micro/device_paths.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <mutex>
#include <vector>

#include "render/gpu/shader_code.h"
#include "render/proof/shader_proof.h"
#include "render/vulkan/pipeline.h"
#include "render/vulkan/resource.h"

namespace brdf::micro {
namespace {

using namespace render;

constexpr std::size_t kMost = std::size_t(1) << 16;  // paths of one dispatch
constexpr std::uint32_t kGroup = 64;                 // local_size_x of the shader
constexpr VkDescriptorType kStorage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;

// The blocks of paths.comp.
struct Push {
  double dx, dy, z_max, eta;
  Vec wi;
  std::int32_t nx, ny, columns_per_frame, limit;
  std::uint32_t count;
};
struct End {
  Vec travel;
  double weight, absorbed;
  std::int32_t order, fate;
};
static_assert(sizeof(End) == 48 && sizeof(Turn) == 16 && sizeof(Start) == 16);

}  // namespace

struct DevicePaths::State {
  Device device{DeviceOptions{.doubles = true}};
  Owned<VkDescriptorSetLayout> set_layout;
  Owned<VkPipelineLayout> layout;
  Owned<VkDescriptorPool> pool;
  VkDescriptorSet set = VK_NULL_HANDLE;
  Owned<VkPipeline> pipeline;
  Buffer heights, tops, turns, starts, ends;
  std::mutex in_use;

  explicit State(Spirv shader) {
    constexpr std::array kBindings{Binding{kStorage}, Binding{kStorage}, Binding{kStorage}, Binding{kStorage},
                                   Binding{kStorage}};
    set_layout = make_set_layout(device, kBindings, VK_SHADER_STAGE_COMPUTE_BIT);
    const std::array sets{set_layout.get()};
    layout = make_pipeline_layout(device, sets, sizeof(Push), VK_SHADER_STAGE_COMPUTE_BIT);
    pool = make_descriptor_pool(device, kBindings, 1);
    set = allocate_set(device, pool.get(), set_layout.get());
    pipeline = make_compute_pipeline(device, layout.get(), shader);
    bind(3, starts, kMost * sizeof(Start));
    bind(4, ends, kMost * sizeof(End));
  }

  void bind(std::uint32_t binding, Buffer& buffer, std::size_t bytes) {
    if (buffer && buffer.size() >= bytes) return;
    buffer = Buffer(device, bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    write_buffer(device, set, binding, kStorage, buffer.get());
  }

  template <class T>
  void load(std::uint32_t binding, Buffer& buffer, std::span<const T> values) {
    bind(binding, buffer, values.size_bytes());
    std::ranges::copy(values, reinterpret_cast<T*>(buffer.data()));
  }

  void dispatch(const Push& push) {
    device.run([&](VkCommandBuffer commands) {
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout.get(), 0, 1, &set, 0, nullptr);
      vkCmdPushConstants(commands, layout.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof push, &push);
      vkCmdDispatch(commands, (push.count + kGroup - 1) / kGroup, 1, 1);
      make_visible_to_host(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                           VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    });
  }
};

DevicePaths::DevicePaths(std::span<const std::uint32_t> shader)
    : state_(std::make_unique<State>(shader.empty() ? shader_code::paths : shader)) {}
DevicePaths::~DevicePaths() = default;

const std::string& DevicePaths::device() const {
  return state_->device.name();
}

bool DevicePaths::is_software() const {
  return render::is_software(state_->device);
}

void DevicePaths::follow(const Surface& surface, const Vec& wi, double eta, int limit,
                         std::span<const Start> starts, const std::function<void(const Path&)>& visit) {
  const std::scoped_lock lock(state_->in_use);
  state_->load<float>(0, state_->heights, surface.heights);
  state_->load<float>(1, state_->tops, surface.tops);
  state_->load<Turn>(2, state_->turns, surface.turns);
  for (std::size_t at = 0; at < starts.size(); at += kMost) {
    const std::span<const Start> some = starts.subspan(at, std::min(kMost, starts.size() - at));
    state_->load(3, state_->starts, some);
    state_->dispatch({surface.dx, surface.dy, surface.z_max, eta, wi, surface.nx, surface.ny,
                      surface.columns_per_frame, limit, std::uint32_t(some.size())});
    const auto* ends = reinterpret_cast<const End*>(state_->ends.data());
    for (const End& end : std::span(ends, some.size()))
      visit({end.travel, end.weight, end.absorbed, end.order, end.fate});
  }
}

}  // namespace brdf::micro
