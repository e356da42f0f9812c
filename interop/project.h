// Projects a part of a material onto another program's formula: exact, refitted or copied, each with its
// loss.
#pragma once

#include <vector>

#include "fit/model/options.h"
#include "interop/copied.h"
#include "interop/loss.h"

namespace brdf::interop {

// A target within the limits of a program's files.
struct TargetRules {
  Reflectance target;
  CopyRules copy{};
  bool sum_to_one = false;  // the weights of a refit add up to at most 1
  bool mixes = false;       // the file mixes shaders by shares, hence all weights add up to at most 1
  // Ranges of the program's controls, in addition to the target's own ranges.
  std::vector<fit::NamedRange> bounds{};
  // Maps a material of one target term to the material that the program renders. Null if the program renders
  // the form itself, channel by channel.
  Material (*shown)(const Material&) = nullptr;
};

// Returns the material as the program renders it.
Material shown_by(const TargetRules& rules, const Material& of_target);

// The result of project().
struct Projection {
  Material material;  // one term, in the frame of the wanted material
  bool refitted = false;
};

// Projects `wanted` onto the target. Returns the copied parameters if they are exact or if `naive` is true.
// Otherwise returns the parameters with the smallest rms that are not worse than the copy in any stated
// figure. Candidates come from fits to the wanted values and from points between these fits and the copy.
Projection project(const Wanted& wanted, const TargetRules& rules, bool naive);

}  // namespace brdf::interop
