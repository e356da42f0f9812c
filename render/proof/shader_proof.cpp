#include "render/proof/shader_proof.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "io/files/error.h"
#include "render/gpu/fragment_code.h"
#include "render/gpu/held.h"
#include "render/gpu/reflectance_glsl.h"
#include "render/gpu/shader_code.h"
#include "render/vulkan/resource.h"

namespace brdf::render {
namespace {

constexpr std::size_t kBatch = ShaderBatch::kMost;  // configurations per dispatch
constexpr VkDescriptorType kStorage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Returns the distance in representable numbers, using the order of the bits of floats within a sign.
double ulps(float a, float b) {
  const auto ordered = [](float x) {
    const auto bits = std::bit_cast<std::int32_t>(x);
    return bits < 0 ? -std::int64_t(bits & 0x7fffffff) : std::int64_t(bits);
  };
  if (std::isnan(a) != std::isnan(b)) return HUGE_VAL;
  return std::abs(double(ordered(a) - ordered(b)));
}

}  // namespace

// The compute pipelines of one shader, one for each form, and the buffers that they share.
class ProofMachine {
 public:
  ProofMachine(Device& device, Spirv of_catalogue) : device_(device), of_catalogue_(of_catalogue) {
    constexpr std::array kBindings{Binding{kStorage}, Binding{kStorage}};
    set_layout_ = make_set_layout(device, kBindings, VK_SHADER_STAGE_COMPUTE_BIT);
    const std::array sets{set_layout_.get()};
    layout_ = make_pipeline_layout(device, sets, sizeof(std::uint32_t), VK_SHADER_STAGE_COMPUTE_BIT);
    pool_ = make_descriptor_pool(device, kBindings, 1);
    set_ = allocate_set(device, pool_.get(), set_layout_.get());
    input_ = Buffer(device, kBatch * sizeof(ProofConfiguration), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    output_ = Buffer(device, kBatch * sizeof(Result), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    write_buffer(device, set_, 0, kStorage, input_.get());
    write_buffer(device, set_, 1, kStorage, output_.get());
  }

  Owned<VkPipeline> pipeline(const Reflectance& form) const {
    require_shader(form);
    const auto index = std::int32_t(catalogue_index(form));
    const VkSpecializationMapEntry entry{0, 0, sizeof index};
    const VkSpecializationInfo constants{1, &entry, sizeof index, &index};
    std::vector<std::uint32_t> own;
    if (index < 0) {
      const NumberedReflectance only{index, form};
      own = compiled(proof_glsl({&only, 1}), Stage::compute, info(form).name);
    }
    return make_compute_pipeline(device_, layout_.get(), index < 0 ? Spirv(own) : of_catalogue_, &constants);
  }

  // Takes at most kBatch configurations; calls visit(configuration, values).
  template <class Visit>
  void evaluate(VkPipeline pipeline, std::span<const ProofConfiguration> configurations, Visit&& visit) {
    load(configurations);
    dispatch(pipeline, configurations.size());
    for (std::size_t i = 0; i < configurations.size(); ++i) visit(configurations[i], values(i));
  }

  void load(std::span<const ProofConfiguration> configurations) {
    std::copy(configurations.begin(), configurations.end(),
              reinterpret_cast<ProofConfiguration*>(input_.data()));
  }
  // Evaluates the first `configurations` configurations and waits.
  void dispatch(VkPipeline pipeline, std::size_t configurations) {
    const auto count = std::uint32_t(configurations);
    device_.run([&](VkCommandBuffer commands) {
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &set_, 0,
                              nullptr);
      vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof count, &count);
      vkCmdDispatch(commands, (count + kProofGroup - 1) / kProofGroup, 1, 1);
      make_visible_to_host(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                           VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    });
  }
  ProofValues values(std::size_t i) const {
    const auto& r = reinterpret_cast<const Result*>(output_.data())[i];
    return {r.f[0], r.f[1], r.f[2], r.f_cos[0], r.f_cos[1], r.f_cos[2]};
  }

 private:
  struct Result {
    std::array<float, 4> f, f_cos;
  };
  Device& device_;
  Spirv of_catalogue_;
  Owned<VkDescriptorSetLayout> set_layout_;
  Owned<VkPipelineLayout> layout_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  Buffer input_, output_;
};

namespace {

void compare(ProofRow& row, const ProofConfiguration& at, const ProofValues& device,
             const ProofValues& library) {
  ++row.count;
  for (std::size_t k = 0; k < device.size(); ++k) {
    const float a = device[k], b = library[k];
    if (std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b)) continue;
    if (std::isnan(a) && std::isnan(b)) continue;
    ++row.differing;
    row.max_ulp = std::max(row.max_ulp, ulps(a, b));
    const double distance = std::abs(double(a) - double(b)),
                 tolerances = distance / (kProofRelative * std::abs(double(b)) + kProofAbsolute);
    const double far = tolerances == tolerances ? tolerances : HUGE_VAL;
    if (far > 1) ++row.beyond_tolerance;
    if (far > row.worst.tolerances) row.worst = {at, k, a, b, far};
  }
}

ProofRow proof_of(ProofMachine& machine, const Reflectance& form, const ProofOptions& options) {
  ProofRow row{.form = std::string(info(form).name)};
  const double start = now();
  const Owned<VkPipeline> pipeline = machine.pipeline(form);
  row.seconds_to_compile = now() - start;
  const auto run = [&](std::span<const ProofConfiguration> configurations) {
    machine.evaluate(pipeline.get(), configurations,
                     [&](const ProofConfiguration& c, const ProofValues& values) {
                       compare(row, c, values, library_values(form, c));
                     });
  };
  const auto extremes = extreme_configurations(form);
  for (std::size_t at = 0; at < extremes.size(); at += kBatch)
    run(std::span(extremes).subspan(at, std::min(kBatch, extremes.size() - at)));
  for (std::uint64_t done = 0; done < options.random; done += kBatch)
    run(random_configurations(form, std::min<std::uint64_t>(kBatch, options.random - done),
                              options.seed + done));
  row.seconds = now() - start;
  return row;
}

}  // namespace

ProofValues library_values(const Reflectance& form, const ProofConfiguration& c) {
  const Vec3<float> wi{c.wi[0], c.wi[1], c.wi[2]}, wo{c.wo[0], c.wo[1], c.wo[2]};
  const auto weights_of = [&](std::size_t channel) {
    return std::array{c.weights[0][channel], c.weights[1][channel], c.weights[2][channel]};
  };
  const std::array first = weights_of(0);
  ProofValues values;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::array own = weights_of(channel);
    const ParameterValues<float> p{own, first, c.shape, channel};
    form->eval(p, one_pair(wi, wo), &values[channel]);
    form->eval_cos(p, one_pair(wi, wo), &values[3 + channel]);
  }
  return values;
}

bool is_software(const Device& device) {
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(device.physical(), &properties);
  return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
}

bool passes(const ProofRow& row, bool software) {
  return (software ? row.differing : row.beyond_tolerance) == 0;
}

struct ShaderBatch::State {
  ProofMachine machine;
  Owned<VkPipeline> pipeline;
};

ShaderBatch::ShaderBatch(Device& device, const Reflectance& form,
                         std::span<const ProofConfiguration> configurations)
    : state_(new State{ProofMachine(device, shader_code::proof), {}}), count_(configurations.size()) {
  if (count_ > kMost)
    throw InputError("a shader batch holds at most " + std::to_string(kMost) + " directions");
  state_->pipeline = state_->machine.pipeline(form);
  state_->machine.load(configurations);
}
ShaderBatch::~ShaderBatch() = default;

void ShaderBatch::run() {
  state_->machine.dispatch(state_->pipeline.get(), count_);
}

std::vector<ProofValues> ShaderBatch::values() const {
  std::vector<ProofValues> values;
  for (std::size_t k = 0; k < count_; ++k) values.push_back(state_->machine.values(k));
  return values;
}

std::vector<ProofRow> shader_proof(Device& device, std::span<const Reflectance> forms,
                                   const ProofOptions& options,
                                   const std::function<void(const ProofRow&)>& report) {
  ProofMachine machine(device, options.shader.empty() ? shader_code::proof : options.shader);
  std::vector<ProofRow> rows;
  for (const Reflectance& form : forms) {
    rows.push_back(proof_of(machine, with_room(form), options));
    if (report) report(rows.back());
  }
  return rows;
}

}  // namespace brdf::render
