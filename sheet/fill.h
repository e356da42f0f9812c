// Values that stand for "not measured": what an instrument writes where its detector saw nothing.
#pragma once

#include <vector>

#include "sheet/view.h"

namespace brdf::sheet {

// A number that several rows of a channel hold although the rows around them hold another.
struct FillValue {
  std::size_t channel;
  double value;  // 1/sr
  std::vector<Row> rows;
};

// Sought are the values that occur most often in a channel, its least and its largest one and 0. A value is a
// fill value where three rows or more hold it, and where nearly all of them contradict the rows beside them:
// these agree on another value, by more than a factor of two. Zeros among noise of their own size, below the
// resolution of the digits, or at the foot of a lobe that vanishes are values like others. The rows are those
// of view.table().
std::vector<FillValue> fill_values(const View& view);

}  // namespace brdf::sheet
