#include "cli/steps/shader_subject.h"

namespace brdf::cli {

validate::OutsideFacts facts_of(const LoadedShader& shader) {
  return {shader.words,   shader.oriented,     shader.may_turn,       shader.all_round,
          shader.explain, shader.explain_jump, shader.undefined,      shader.in_more_digits,
          shader.in_half, shader.half_unknown, shader.has_half_types, shader.sampler};
}

validate::Subject subject_of(const LoadedShader& shader, const std::string& file) {
  return validate::Subject::outside(file, shader.material, facts_of(shader));
}

}  // namespace brdf::cli
