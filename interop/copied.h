// Copies the parameters of a material into the form of another program, as users do by hand.
#pragma once

#include "interop/wanted.h"

namespace brdf::interop {

// Limits of a program's scene files for the lobe of a target form.
struct CopyRules {
  bool grey_lobe = false;        // one lobe weight for all colours, at most 1
  std::vector<Role> coloured{};  // shape parameters with one value per colour
  // A lobe weight above this limit is lowered, and the reflectance along the normal is raised in return.
  double most_lobe = 1;
};

// Returns the index of the shape parameter that another one makes superfluous: the index of refraction if
// the shape is given per colour and that index exceeds 1, since a tint per colour then scales the same
// reflectance; otherwise the tint. Returns -1 if the target has no tint or no index of refraction.
int superfluous(const Term& of_target);

// Returns the target's parameters, derived from the roles of the material's parameters.
// - Widths and weights are copied unchanged.
// - The reflectance along the normal becomes an index of refraction if the target has one. For a complex
//   index, eta is 1, as for pbrt's "reflectance".
// - A target with a single colour gets the lobe's colour if no part is diffuse (a metal), otherwise the
//   diffuse colour.
// Values outside the target's range are clamped.
Material copied(const Wanted& wanted, const Reflectance& target, const CopyRules& rules);

}  // namespace brdf::interop
