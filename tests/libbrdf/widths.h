// Lobes of a given width, for any form.
#pragma once

#include <algorithm>
#include <cmath>

#include "brdf/material.h"

namespace brdf {

// Sets the parameters of `term` to widths `along` and `across` the tangent, according to the roles of the
// form's parameters, and clamps each to its range. Returns false if the form has no such parameter.
inline bool set_width(Term& term, double along, double across) {
  bool set = false;
  const std::span<const ParameterInfo> table = term.form.info().shape;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const ParameterInfo& p = table[k];
    const bool second = p.role == Role::width_across || p.role == Role::exponent_across;
    const double width = second ? across : along;
    double value;
    if (p.map == Map::roughness)
      value = std::sqrt(width);
    else if (p.role == Role::width || p.role == Role::width_across)
      value = width;
    else if (p.role == Role::exponent || p.role == Role::exponent_across)
      value = 2 / (width * width) - 2;
    else
      continue;
    term.shape[0][k] = std::clamp(value, p.min, p.max);
    set = true;
  }
  return set;
}

}  // namespace brdf
