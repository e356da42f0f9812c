// Proofs about a user's shader.
#pragma once

#include <string>
#include <vector>

#include "prove/proof.h"
#include "shader/shader.h"

namespace brdf::prove {

// Proves properties of a shader over the ranges of its parameters, for light and viewers at cosines from
// kLeastShaderCosine to 1 (energy: all viewers). finite and non_negative are proved in float and in double.
// energy compares the largest directional albedo with 1, by sums of enclosed cells. `words`: the words of a
// command line, for witnesses.
inline constexpr double kLeastShaderCosine = 1e-3;
std::vector<Proof> prove(const shader::ShaderReflectance& model, const Material& material,
                         const std::string& words, const Options& options);

}  // namespace brdf::prove
