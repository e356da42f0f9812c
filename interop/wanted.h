// A material as programs of one lobe can take it.
#pragma once

#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "io/error.h"

namespace brdf::interop {

// What a program cannot carry, with the reason.
class Refused : public InputError {
 public:
  using InputError::InputError;
};

// At most a diffuse part and one lobe, of one channel or red, green and blue, whose wider axis lies along the tangent.
struct Wanted {
  Material material;  // as seen from the frame of the wider axis
  Angle tangent{};    // azimuth of that axis in the surface's frame
  int lobe = -1;      // the term that has one; -1: none has
};

// What a program's files can say, whichever of its targets is taken.
struct Limits {
  std::string_view program;          // as messages name it
  double most = 1, most_lobe = 1;    // a weight above, or one of the lobe, is clamped
  bool fresnel_per_channel = false;  // indices of refraction or reflectances along the normal for each colour
  std::vector<Reflectance> targets{};
};

// Throws Refused for what no program of one lobe carries: other channels, a second lobe, a shape per channel (but for
// what the limits allow), a form that is not reciprocal or does not fade out at grazing light and is none of the targets,
// weights above the most.
Wanted wanted(const Material& material, const Limits& limits);

// The widths of a term's lobe along and across the tangent, also of one with exponents (the slopes that scatter as much:
// alpha^2 = 2/(n + 2)); 0.3 where it has neither.
struct Widths {
  double along = 0.3, across = 0.3;
};
Widths widths_of(const Term& term);

// What tells the boundary's reflectance.
bool is_fresnel(Role role);

// Whether a term's form has a weight of a lobe that is not 0 in every channel.
bool has_lobe(const Term& term);

}  // namespace brdf::interop
