// Names of surfaces and directions in the comparisons' rows.
#pragma once

#include <string>
#include <vector>

#include "io/files/numbers.h"
#include "micro/theory.h"

namespace brdf::micro {

inline std::string gaussian_name(double alpha) {
  return "gaussian alpha " + io::short_number(alpha);
}

// Gives every row whose model is an approximation its cause.
void explain(std::vector<TheoryRow>& rows, const std::string& cause);

}  // namespace brdf::micro
