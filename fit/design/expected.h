// The known errors of a reading and of a model, and the expected standard errors of parameters.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "brdf/names.h"

namespace brdf::fit {

enum class NoiseFrom {
  option,    // stated by the caller
  stated,    // the columns of standard deviations
  table,     // the table itself: repeats, symmetry, neighbours
  residuals  // the residuals of the fit
};
enum class ErrorFrom {
  option,      // stated by the caller
  residuals,   // neighbouring residuals agree more than noise does
  undetected,  // the residuals look like noise: the error is taken as 0
  assumed      // too few values to see an error: a multiple of the noise
};

}  // namespace brdf::fit

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 4> kNames<fit::NoiseFrom>{"option", "stated", "table",
                                                                        "residuals"};
template <>
inline constexpr std::array<std::string_view, 4> kNames<fit::ErrorFrom>{"option", "residuals", "undetected",
                                                                        "assumed"};

}  // namespace brdf

namespace brdf::fit {

// Values per parameter below which residuals cannot show an error of the model, and the error that is then
// assumed, in units of the noise.
inline constexpr double kFewValues = 4, kAssumedError = 2;

struct NoiseAndError {
  double noise = 0;  // relative standard deviation of a reading
  double error = 0;  // standard deviation of ln f - ln(model), correlated between directions
  NoiseFrom noise_from = NoiseFrom::residuals;
  ErrorFrom error_from = ErrorFrom::undetected;
  double freedom = 0;  // number of values less the number of parameters that they determine
};

// The expected standard error of a parameter.
struct ExpectedWidth {
  std::string name, channel;  // as options name it; channel: empty if the name says it, or if all share it
  double value = 0, error = 0;
  bool determined = true;  // false if the rows do not determine the parameter
};

}  // namespace brdf::fit
