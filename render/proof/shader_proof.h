// The proof that shader and library are one formula: a compute shader evaluates the traced forms on many
// configurations, and every bit is compared with the float library's.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "render/vulkan/pipeline.h"

namespace brdf::render {

// One evaluation of an RGB material, as the shader reads it: rows of four floats.
struct ProofConfiguration {
  std::array<float, 4> wi{}, wo{};                // local frame; the fourth is unused
  std::array<float, 4> shape{};                   // in table order
  std::array<std::array<float, 4>, 3> weights{};  // [parameter][channel]
};

// f_r and f_r cos_i of the three channels.
using ProofValues = std::array<float, 6>;
ProofValues library_values(const Reflectance& form, const ProofConfiguration& configuration);

// Random configurations over all of the form's parameters, a fifth of them grazing, half of them near the
// mirror direction; reproducible from the seed.
std::vector<ProofConfiguration> random_configurations(const Reflectance& form, std::size_t count,
                                                      std::uint64_t seed);
// Every pair of awkward directions (normal, exact grazing, subnormal components, below the horizon, wi = wo,
// wi = -wo, ...) with the parameters at the corners of their tables.
std::vector<ProofConfiguration> extreme_configurations(const Reflectance& form);

struct ProofOptions {
  std::uint64_t random = std::uint64_t(1) << 20;  // configurations per form, beside the extremes
  std::uint64_t seed = 1;
  Spirv shader;  // of the catalogue; empty: the library's; tests give their negative controls
};

// Where a device's value is furthest from the library's, in tolerances; first where only one of both is a
// number.
struct ProofWorst {
  ProofConfiguration at;
  std::size_t value = 0;  // of ProofValues
  float device = 0, library = 0;
  double tolerances = 0;
};

struct ProofRow {
  std::string form;
  std::uint64_t count = 0;             // configurations, six values each
  std::uint64_t differing = 0;         // values with any differing bit (NaN equals NaN)
  double max_ulp = 0;                  // largest distance in units of the last place
  std::uint64_t beyond_tolerance = 0;  // values further apart than kProofRelative |f| + kProofAbsolute
  ProofWorst worst;                    // of the differing ones
  double seconds_to_compile = 0;       // the driver's time for this form's pipeline
  double seconds = 0;                  // all of it
};

// What Vulkan's division (2.5 ulp), square root and contraction may cost a hardware device: the exponential
// tails multiply a relative error by up to 80.
inline constexpr double kProofRelative = 2e-4, kProofAbsolute = 1e-6;

// True where the device is a processor: there the promise is 0 differing bits, elsewhere the tolerance.
bool is_software(const Device& device);
bool passes(const ProofRow& row, bool software);

// The shader on the same configurations of one form again and again: for its values and its time.
class ShaderBatch {
 public:
  static constexpr std::size_t kMost = std::size_t(1) << 16;
  // Throws InputError for more than kMost configurations.
  ShaderBatch(Device& device, const Reflectance& form, std::span<const ProofConfiguration> configurations);
  ~ShaderBatch();
  void run();                               // evaluates all of them and waits
  std::vector<ProofValues> values() const;  // of the last run, in the configurations' order

 private:
  struct State;
  std::unique_ptr<State> state_;
  std::size_t count_;
};

// The reflectances may be any that have GLSL: those that are not in the catalogue are compiled here. Throws
// InputError for one that shaders cannot have.
std::vector<ProofRow> shader_proof(Device& device, std::span<const Reflectance> forms,
                                   const ProofOptions& options = {},
                                   const std::function<void(const ProofRow&)>& report = {});

}  // namespace brdf::render
