// The proof that shader and library evaluate the same formula. A compute shader evaluates the traced forms
// for many configurations, and each bit is compared with the float evaluation of the library.
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

// One evaluation of an RGB material in the layout that the shader reads: rows of four floats.
struct ProofConfiguration {
  std::array<float, 4> wi{}, wo{};                // local frame; the fourth is unused
  std::array<float, 4> shape{};                   // in the order of the form's table
  std::array<std::array<float, 4>, 3> weights{};  // [parameter][channel]
};

// f_r and f_r cos_i of the three channels.
using ProofValues = std::array<float, 6>;
// Returns the values of the float library.
ProofValues library_values(const Reflectance& form, const ProofConfiguration& configuration);

// Returns random configurations over all parameters of the form. A fifth of them are at grazing angles,
// half of them near the mirror direction. The seed makes them reproducible.
std::vector<ProofConfiguration> random_configurations(const Reflectance& form, std::size_t count,
                                                      std::uint64_t seed);
// Returns each pair of difficult directions (normal, exactly grazing, subnormal components, below the
// horizon, wi = wo, wi = -wo, ...) with the parameters at the corners of their ranges.
std::vector<ProofConfiguration> extreme_configurations(const Reflectance& form);

struct ProofOptions {
  // Random configurations per form, in addition to the extreme ones.
  std::uint64_t random = std::uint64_t(1) << 20;
  std::uint64_t seed = 1;
  // SPIR-V for the catalogue; empty: the shader of the library. Tests pass their negative controls here.
  Spirv shader;
};

// The largest deviation of a device's value from the library's, in tolerances. A value that is a number on
// only one side comes first.
struct ProofWorst {
  ProofConfiguration at;
  std::size_t value = 0;  // index in ProofValues
  float device = 0, library = 0;
  double tolerances = 0;
};

struct ProofRow {
  std::string form;
  std::uint64_t count = 0;      // configurations, six values each
  std::uint64_t differing = 0;  // values with any differing bit (NaN equals NaN)
  double max_ulp = 0;           // largest distance in units in the last place
  // Values that differ by more than kProofRelative |f| + kProofAbsolute.
  std::uint64_t beyond_tolerance = 0;
  ProofWorst worst;               // among the differing values
  double seconds_to_compile = 0;  // the driver's time for this form's pipeline
  double seconds = 0;             // total time
};

// Tolerance for the errors of Vulkan's division (2.5 ulp), square root and contraction on a hardware
// device: the exponential tails multiply a relative error by up to 80.
inline constexpr double kProofRelative = 2e-4, kProofAbsolute = 1e-6;

// Returns whether the device is a CPU. The requirement is 0 differing bits on a CPU, the tolerance on other
// devices.
bool is_software(const Device& device);
// Returns whether no value differs (software) or no value is beyond the tolerance (hardware).
bool passes(const ProofRow& row, bool software);

// Runs the shader repeatedly on the same configurations of one form, to obtain its values and its time.
class ShaderBatch {
 public:
  static constexpr std::size_t kMost = std::size_t(1) << 16;
  // Throws InputError if there are more than kMost configurations.
  ShaderBatch(Device& device, const Reflectance& form, std::span<const ProofConfiguration> configurations);
  ~ShaderBatch();
  void run();                               // evaluates all configurations and waits
  std::vector<ProofValues> values() const;  // of the last run, in the order of the configurations

 private:
  struct State;
  std::unique_ptr<State> state_;
  std::size_t count_;
};

// Runs the proof for any reflectances that have GLSL; those outside the catalogue are compiled here. Throws
// InputError for a reflectance that shaders cannot evaluate.
std::vector<ProofRow> shader_proof(Device& device, std::span<const Reflectance> forms,
                                   const ProofOptions& options = {},
                                   const std::function<void(const ProofRow&)>& report = {});

}  // namespace brdf::render
