// Names of surfaces and directions in the comparisons' rows.
#pragma once

#include <sstream>
#include <string>

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

}  // namespace brdf::micro
