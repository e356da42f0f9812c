// A material in another program's formula: exact, refitted or copied, each with its loss.
#pragma once

#include <optional>
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
  bool sum_to_one = false;  // a refit's weights are at most 1 together: shaders are mixed
  std::vector<fit::NamedRange>
      bounds{};  // of what the program's controls reach, besides the target's own ranges
};

struct Projection {
  Material material;  // of one term, in the frame of the wanted one
  Loss loss, copied;  // of `material`, and of copied parameters
  bool refitted = false;

  bool exact() const { return loss.exact(); }
};

// Copied parameters where they are exact or `naive` asks for them; else the target fitted to the wanted values, from the
// copy and from the fitter's own starts, unless the copy is nearer.
Projection project(const Wanted& wanted, const TargetRules& rules, bool naive);

// "exact", or "refitted: largest ...; copied parameters: largest ...".
std::string in_words(const Projection& projection);

}  // namespace brdf::interop
