// Why reciprocal pairs differ: one cause that explains most of it, if there is one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sheet/pairs.h"

namespace brdf::sheet {

// cosine: the values are f_r times cos_i (size 1) or times cos_o (size -1). gain: the values under one light
// are exp(size) times too large. drift: the values grow by exp(size) from the first row of the file to the
// last. dark_level: a constant of `size` relative to the median value was added before the values were
// divided by cos_o.
enum class Cause { cosine, gain, drift, dark_level };

struct Explanation {
  Cause cause;
  double size;            // the median over the pairs that have a lever
  double low, high;       // its quartiles
  double standard_error;  // of the median; pairs count half, since a row belongs to several
  std::size_t pairs;      // that have a lever
  double share;           // of the pairs' absolute differences that the cause removes, 0 to 1
  std::size_t scan = 0;   // of a gain: the light, of View::scans()
  double others = 0;      // of a gain: the largest share that another light removes of what is left
};

struct Causes {
  std::size_t pairs = 0;
  std::optional<double> difference;  // median |log_ratio|; none of fewer than kFewestPairs
  std::vector<Explanation> tried;    // by falling share; a cause without enough pairs is not tried
  // The first of them where it holds by its own rule: its quartiles agree with it and exclude 0, and no rival
  // removes as much.
  std::optional<Explanation> found;
  // Whether the rule was met by a wide margin.
  bool is_certain = false;
  bool was_tried(Cause cause) const;
};

inline constexpr std::size_t kFewestPairs = 8;

Causes causes_of(const View& view, const std::vector<Pair>& pairs);

}  // namespace brdf::sheet
