#if defined(BRDF_HAS_RENDER) && defined(BRDF_HAS_SHADER)
#include "cli/steps/shader_cost.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "io/material/glsl.h"
#include "render/gpu/held.h"
#include "render/proof/shader_proof.h"
#include "shader/function.h"

namespace brdf::cli {
namespace {

constexpr std::size_t kPairs = 4096;
constexpr int kRuns = 12;

double driver_time(render::Device& device, const Reflectance& timed) {
  const Reflectance form = render::with_room(timed);  // a form with many weights is timed with a few of them
  const auto configurations = render::random_configurations(form, kPairs, 1);
  render::ShaderBatch batch(device, form, configurations);
  double best = HUGE_VAL;
  for (int run = 0; run < kRuns; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    batch.run();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best / double(2 * kPairs) * 1e9;  // f_r and f_r cos_i are two evaluations
}

}  // namespace

std::vector<ShaderCost> shader_costs(render::Device& device, const Reflectance& shader,
                                     const std::string& name, std::size_t operations) {
  shader::Compiler compiler;
  std::vector<ShaderCost> costs;
  for (const Reflectance& form : catalogue()) {
    const std::string text = io::glsl_source(make_material(form), {.material = false});
    const shader::Function function =
        shader::make_function(shader::parse_source("exported.glsl", text), {}, compiler);
    costs.push_back({std::string(form.info().name), function.as_written.size(), driver_time(device, form)});
  }
  std::ranges::sort(costs,
                    [](const ShaderCost& a, const ShaderCost& b) { return a.operations < b.operations; });
  costs.insert(costs.begin(), {name, operations, driver_time(device, shader)});
  return costs;
}

}  // namespace brdf::cli
#endif
