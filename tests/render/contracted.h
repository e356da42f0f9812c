// The negative control of the proof: the library's formula compiled with floating-point contraction.
#pragma once

#include "render/proof/shader_proof.h"

namespace brdf::render {

// Returns the values of ward, cook_torrance or oren_nayar. Needs a processor with fused multiply-add.
ProofValues contracted_values(const Reflectance& form, const ProofConfiguration& configuration);

}  // namespace brdf::render
