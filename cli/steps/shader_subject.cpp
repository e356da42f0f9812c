#include "cli/steps/shader_subject.h"

namespace brdf::cli {

validate::OutsideFacts facts_of(const LoadedShader& shader) {
  return {shader.words,
          shader.oriented,
          shader.may_turn,
          shader.all_round,
          shader.explain,
          shader.explain_jump,
          shader.undefined,
          shader.in_more_digits,
          shader.in_half,
          shader.half_unknown,
          shader.has_half_types,
          shader.sampler,
          shader.for_each_comparison,
          shader.text_of_line};
}

validate::Subject subject_of(const LoadedShader& shader, const std::string& file) {
  return validate::Subject::outside(file, shader.material, facts_of(shader));
}

}  // namespace brdf::cli
