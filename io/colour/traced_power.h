// The power function that io/colour/srgb.h requires of a scalar, for the scalar that generates shaders.
#pragma once

#include "brdf/trace.h"

namespace brdf {

inline Traced to_power(Traced x, Traced exponent) {
  return Traced::from_node(
      Trace::current().add({Trace::Type::float_type, "pow", {x.node(), exponent.node()}}));
}

}  // namespace brdf
