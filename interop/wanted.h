// A material as programs of one lobe can take it.
#pragma once

#include <string_view>

#include "brdf/material.h"

namespace brdf::interop {

// At most a diffuse part and one lobe, of one channel or red, green and blue, whose wider axis lies along the tangent.
struct Wanted {
  Material material;  // as seen from the frame of the wider axis
  Angle tangent{};    // azimuth of that axis in the surface's frame
  int lobe = -1;      // the term that has one; -1: none has
};

// Throws InputError, with the reason, for what no program of one lobe carries: other channels, a second lobe, a shape per
// channel, a form that is not reciprocal or does not fade out at grazing light, weights above `most`. `program` is named
// in the message.
Wanted wanted(const Material& material, std::string_view program, double most);

// The widths of a term's lobe along and across the tangent, also of one with exponents (the slopes that scatter as much:
// alpha^2 = 2/(n + 2)); 0.3 where it has neither.
struct Widths {
  double along = 0.3, across = 0.3;
};
Widths widths_of(const Term& term);

// Whether a term's form has a weight of a lobe that is not 0 in every channel.
bool has_lobe(const Term& term);

}  // namespace brdf::interop
