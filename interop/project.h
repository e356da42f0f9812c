// A part of a material in another program's formula: exact, refitted or copied, each with its loss.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fit/model/options.h"
#include "interop/copied.h"
#include "interop/loss.h"

namespace brdf::interop {

// A target as a program's files can hold it.
struct TargetRules {
  Reflectance target;
  CopyRules copy{};
  bool sum_to_one = false;  // a refit's weights are at most 1 together
  bool mixes = false;       // all weights are: the file mixes shaders by shares
  std::vector<fit::NamedRange>
      bounds{};  // of what the program's controls reach, besides the target's own ranges
  // What the program shows of a material of one such term, where it is not the form channel by channel; null:
  // it is.
  Material (*shown)(const Material&) = nullptr;
};

// As the program shows it.
Material shown_by(const TargetRules& rules, const Material& of_target);

struct Projection {
  Material material;  // of one term, in the frame of the wanted one
  bool refitted = false;
};

// Copied parameters where they are exact or `naive` asks for them; else the target's parameters of the least
// rms that are worse than the copy in no stated figure, sought from fits to the wanted values and between
// those and the copy.
Projection project(const Wanted& wanted, const TargetRules& rules, bool naive);

}  // namespace brdf::interop
