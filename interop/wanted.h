// A material as other programs can take it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "io/files/error.h"

namespace brdf::interop {

// What a program cannot carry, with the reason.
class Refused : public InputError {
 public:
  using InputError::InputError;
};

// At most a diffuse part and one lobe, of one channel or red, green and blue, whose wider axis lies along the
// tangent.
struct Wanted {
  Material material;  // as seen from the frame of the wider axis
  Angle tangent{};    // azimuth of that axis in the surface's frame
  Angle given{};      // azimuth of the axis of alpha_x, as the material has it
  int lobe = -1;      // the term that has one; -1: no term has
};

// What a program's files can say, whichever of its targets is taken.
struct Limits {
  std::string_view program;        // as messages name it
  double most = 1, most_lobe = 1;  // a weight above, or one of the lobe, is clamped
  bool adds = false;               // sums of any number of lobes
  std::vector<Reflectance> targets{};
};

// The material in red, green and blue, or of its one channel, cut into parts of one lobe each whose sum it
// is: the first has all terms without a lobe. Throws Refused for what no file of the program carries: other
// channels, a second lobe where the program adds none, a shape per channel (but for what tells the boundary's
// reflectance, which every program takes by colour in some way), a form that is not reciprocal or does not
// fade out at grazing light and is none of the targets, weights above the most.
std::vector<Wanted> wanted(const Material& material, const Limits& limits);

// The channels as red, green and blue; nothing where their names do not say which they are.
std::optional<Material> in_colours(const Material& material);

// The sum of the parts, in the surface's frame.
Material sum_of(const std::vector<Wanted>& parts);

// What a target's lobe has for each colour.
struct Holds {
  bool coloured_lobe = true;     // a weight
  bool coloured_fresnel = true;  // the boundary's reflectance
};
// What it has no place for of the part: a sentence each.
std::vector<std::string> not_held(const Wanted& part, const Holds& target);

// The widths of a term's lobe along and across the tangent, also of one with exponents (the slopes that
// scatter as much: alpha^2 = 2/(n + 2)); 0.3 where it has neither.
struct Widths {
  double along = 0.3, across = 0.3;
};
Widths widths_of(const Term& term);

// Whether a term's form has a weight of a lobe that is not 0 in every channel.
bool has_lobe(const Term& term);

}  // namespace brdf::interop
