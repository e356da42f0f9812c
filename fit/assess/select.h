// Choosing between models.
#pragma once

#include "fit/assess/result.h"

namespace brdf::fit {

// Times the least left-out value: what lies above is never as good, however few the groups that tell them
// apart.
inline constexpr double kAsGood = 1.1;

// Sorts best first by the left-out value (where none was asked for, by the median error); equal values (three
// digits) by whether they are usable, then by number of parameters; forms without a finite cost last. A
// usable form below one that is a misfit by the share of its light becomes one, too: the rule may not reverse
// the order. Sets `recommended`: the usable form with the fewest parameters whose left-out value is at most a
// tenth above the first one's and that the paired test does not find worse; where that one breaks energy, the
// first that is usable. Returns where each stood before.
std::vector<std::size_t> rank(FitResult& result);

}  // namespace brdf::fit
