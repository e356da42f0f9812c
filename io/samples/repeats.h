// Averages directions that were measured more than once.
#pragma once

#include "brdf/names.h"
#include "io/samples/samples.h"

namespace brdf::io {

enum class Repeats { keep, average };

// Replaces all rows with the same four angles (azimuths to full turns) by one row at the position of the
// first. The new value is the mean, and the new standard deviation is that of the mean. The changes are
// added to the warnings. If the table states standard deviations, they are propagated: sqrt(sum s^2)/n.
// Otherwise they are estimated from the scatter of the repeats, separately for each channel. The variance
// of a single value is (d v + 4 w)/(d + 4). v is the sample variance of the row's d + 1 values. w is the
// variance of the repeated rows with the most similar values, pooled over at least 20 degrees of freedom if
// the table has as many; for values beyond the largest repeated value, w scales with the square of the
// value. A row measured once thus has a standard deviation too, and a row measured twice does not get one
// that is tiny by chance. (This is a variance moderated by its neighbours', after Smyth 2004, Stat. Appl.
// Genet. Mol. Biol. 3, with his d0 fixed at 4.) Copies, which repeat the values exactly, carry no
// information on the scatter. If all repeats are copies, the result is means without standard deviations.
void average_repeats(SampleTable& table);

}  // namespace brdf::io

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 2> kNames<io::Repeats>{"keep", "average"};

}  // namespace brdf
