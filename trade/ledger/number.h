// Formatting of numbers in the sentences and tables of `brdf trade`.
#pragma once

#include <string>

#include "io/files/numbers.h"

namespace brdf::trade {

inline std::string number(double x) {
  return io::short_number(x, 3);
}

}  // namespace brdf::trade
