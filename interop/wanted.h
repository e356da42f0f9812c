// A material in the form that other programs accept.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "io/files/error.h"

namespace brdf::interop {

// Thrown if a program cannot carry the material. The message gives the reason.
class Refused : public InputError {
 public:
  using InputError::InputError;
};

// At most a diffuse part and one lobe, with one channel or with red, green and blue. The wider axis of the
// lobe lies along the tangent.
struct Wanted {
  Material material;  // in the frame of the wider axis
  Angle tangent{};    // azimuth of the wider axis in the surface's frame
  Angle given{};      // azimuth of the material's alpha_x axis
  int lobe = -1;      // index of the term with a lobe, or -1
};

// Limits of a program's files, whichever of its targets is chosen.
struct Limits {
  std::string_view program;  // name for messages
  // Upper limits of weights, and of the lobe's weight: the program clamps larger ones.
  double most = 1, most_lobe = 1;
  bool adds = false;  // the files hold sums of any number of lobes
  std::vector<Reflectance> targets{};
};

// Splits the material into parts of one lobe each that add up to the material. The channels are red, green
// and blue, or a single channel. The first part has all terms without a lobe.
// Throws Refused for a material that no file of the program carries:
// - other channels;
// - a second lobe, if the program does not add lobes;
// - a shape per channel, except for the Fresnel reflectance, which every program accepts by colour in some
//   way;
// - a form that is no target and is not reciprocal or does not vanish at grazing incidence, unless it is a
//   program's model and a target has the same violation;
// - weights above the limits.
std::vector<Wanted> wanted(const Material& material, const Limits& limits);

// Returns the channels as red, green and blue, or std::nullopt if their names do not identify the colours.
std::optional<Material> in_colours(const Material& material);

// Returns the sum of the parts, in the surface's frame.
Material sum_of(const std::vector<Wanted>& parts);

// Facts about a target: whether its lobe has one value per colour.
struct Holds {
  bool coloured_lobe = true;     // of the weight
  bool coloured_fresnel = true;  // of the Fresnel reflectance
};
// Returns a sentence for each property of the part that the target cannot hold.
std::vector<std::string> not_held(const Wanted& part, const Holds& target);

// The widths of a term's lobe along and across the tangent. Exponents n are converted to the slopes that
// scatter equally, alpha^2 = 2/(n + 2). The widths are 0.3 if the term has neither widths nor exponents.
struct Widths {
  double along = 0.3, across = 0.3;
};
// Returns the widths of a term's lobe.
Widths widths_of(const Term& term);

// Returns true if the term's form has a lobe weight and this weight is not 0 in every channel.
bool has_lobe(const Term& term);

}  // namespace brdf::interop
