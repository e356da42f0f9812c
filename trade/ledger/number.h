// Numbers as the trade's sentences and tables show them.
#pragma once

#include <string>

#include "io/files/numbers.h"

namespace brdf::trade {

inline std::string number(double x) {
  return io::short_number(x, 3);
}

}  // namespace brdf::trade
