// Names of surfaces and directions in the comparisons' rows.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "micro/theory.h"

namespace brdf::micro {

/// At most four significant digits.
inline std::string text(double number) {
  std::ostringstream out;
  out.precision(4);
  out << number;
  return out.str();
}

inline std::string gaussian_name(double alpha) {
  return "gaussian alpha " + text(alpha);
}

/// Gives every row whose model is an approximation its cause.
void explain(std::vector<TheoryRow>& rows, const std::string& cause);

}  // namespace brdf::micro
