// A material's parameters as people copy them into another program.
#pragma once

#include "interop/wanted.h"

namespace brdf::interop {

// What a program's scene files can say of a target's lobe.
struct CopyRules {
  bool grey_lobe = false;        // its weight is one for all colours, at most 1
  std::vector<Role> coloured{};  // shape parameters that have a value for each colour
  double most_lobe = 1;  // a lobe above it gets a lower weight and a higher reflectance along the normal
};

// A shape parameter that another one makes superfluous: the index where a tint by colour moves the same
// reflectance, else the tint; -1: the target has no tint.
int superfluous(const Term& of_target);

// The target's parameters from the roles of the material's: widths and weights as they are; the reflectance
// along the normal as an index of refraction where the target takes one (complex: eta 1, as pbrt's
// "reflectance"); of a target of one colour the lobe's where nothing is diffuse (a metal), else the diffuse
// one. What is out of the target's range is brought to its end.
Material copied(const Wanted& wanted, const Reflectance& target, const CopyRules& rules);

}  // namespace brdf::interop
