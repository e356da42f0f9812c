// Directions that were measured more than once.
#pragma once

#include "brdf/names.h"
#include "io/samples/samples.h"

namespace brdf::io {

enum class Repeats { keep, average };

// Makes one row, in the place of the first, of all rows with the same four angles (azimuths to full turns):
// the mean of their values. Its standard deviation is that of the mean. Where the table states standard
// deviations they are propagated, sqrt(sum s^2)/n. Otherwise they are told by the scatter, a column for each
// channel: the variance of one value is (d v + 4 w)/(d + 4), v the sample variance of the row's d + 1 values
// and w what the rows of values nearest in size scatter by, pooled over 20 degrees of freedom or more; beyond
// the largest of these relative to the value. So a row measured once has a standard deviation, too, and one
// measured twice has none that chance made tiny (a variance moderated by its neighbours', after Smyth 2004,
// Stat. Appl. Genet. Mol. Biol. 3, with his d0 at 4). Copies, which repeat the values, tell nothing of
// scatter. Where nothing else is repeated there are means without standard deviations. What was done stands
// in the warnings.
void average_repeats(SampleTable& table);

}  // namespace brdf::io

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 2> kNames<io::Repeats>{"keep", "average"};

}  // namespace brdf
