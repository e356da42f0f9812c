// Fill values: numbers that an instrument writes for directions that were not measured.
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

// Finds the fill values of each channel. Candidates are the values that occur most often, the least and the
// largest value, and 0. A candidate is a fill value if at least three rows hold it and nearly all of them
// contradict the rows around them: these agree on another value, which differs by more than a factor of
// two. Zeros among noise of their own size, below the resolution of the digits, or at the foot of a lobe
// that vanishes are ordinary values. The largest value is a fill value also if two rows hold it, it is far
// above all others, and it is a number that programs write for a missing measurement: nines or a power of
// ten, as f_r or before the division by pi or 100 pi. The rows are rows of view.table().
std::vector<FillValue> fill_values(const View& view);

}  // namespace brdf::sheet
