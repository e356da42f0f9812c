// Names of surfaces and directions in the rows of the comparisons.
#pragma once

#include <string>
#include <vector>

#include "io/files/numbers.h"
#include "micro/theory.h"

namespace brdf::micro {

inline std::string gaussian_name(double alpha) {
  return "gaussian alpha " + io::short_number(alpha);
}

// Sets the cause of every row with an approximate model.
void explain(std::vector<TheoryRow>& rows, const std::string& cause);

}  // namespace brdf::micro
