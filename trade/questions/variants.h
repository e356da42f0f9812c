// Cheaper variants of the GGX model: the ledger's approximations inside a whole model, fitted like one.
#pragma once

#include "trade/measure/question.h"
#include "trade/recommend/scene_fit.h"

namespace brdf::trade {

inline constexpr const char* kVariantQuestion = "cheaper inside cook_torrance";

// The whole model with one factor replaced, against the model itself: costs and errors.
std::vector<Question> variant_questions();

// Names of the variants, as the question's choices.
std::vector<std::string> variant_names();

struct FittedVariant {
  std::string name;
  double alpha = 0.3;
  std::array<std::array<double, 3>, 3> weights{};  // [channel][lobe]: 1/pi, D V, D V s
  RgbFunction reflectance;
};
// Least squares of E (f - g) cos_i over the table's rows, weights not negative, alpha by golden section.
FittedVariant fit_variant(const std::string& name, const io::SampleTable& table);

}  // namespace brdf::trade
