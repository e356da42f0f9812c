// Lobes of a given width, whatever the form.
#pragma once

#include <algorithm>
#include <cmath>

#include "brdf/material.h"

namespace brdf {

// What makes a lobe this wide, by the roles of the form's parameters; false where it has no such parameter.
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
