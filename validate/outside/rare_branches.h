// Branches of outside code that the searches of the checks hardly meet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "validate/search/finding.h"
#include "validate/search/options.h"
#include "validate/search/pair_search.h"
#include "validate/search/subject.h"

namespace brdf::validate {

// A comparison with an outcome at few or none of the directions that are spread evenly, and a pair of
// directions at which a search for this outcome found it. Values of f are in 1/sr.
struct RareBranch {
  std::uint32_t line = 0;  // of the source; 0: unknown
  bool holds = false;      // the rare outcome
  long met = 0, looked = 0;
  Material at;
  Pair pair;                      // with the rare outcome
  double least = 0;               // f there, of the channel with the least value; NaN: not finite
  double beside = 0, inside = 0;  // f directly beside the boundary, of the channel that grows most
  bool leads_to_unseen = false;   // the branch leads to comparisons that were executed nowhere else
  // Returns whether quadrature and searches that did not meet the branch may report too little.
  bool may_matter() const;
};

// Finds rare branches of a shader. Empty for subjects with unknown comparisons. The search has no
// random part other than options.seed.
std::vector<RareBranch> rare_branches(const Subject& subject, const CheckOptions& options);

// Findings that passed become undecided if a rare branch may matter; a value below 0 that is met there fails
// non_negative, and a value that is not finite fails finite.
void apply_rare_branches(const Subject& subject, const CheckOptions& options, std::span<Finding> findings);

}  // namespace brdf::validate
