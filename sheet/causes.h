// The cause of the differences of reciprocal pairs, if a single cause explains most of them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sheet/pairs.h"

namespace brdf::sheet {

// cosine: the values are f_r times cos_i (size 1) or times cos_o (size -1). gain: the values under one
// light are too large by the factor exp(size). drift: the values grow by the factor exp(size) from the
// first row of the file to the last. dark_level: a constant of `size` times the median value was added
// before the values were divided by cos_o.
enum class Cause { cosine, gain, drift, dark_level };

struct Explanation {
  Cause cause;
  double size;            // the median over the pairs that have a lever
  double low, high;       // its quartiles
  double standard_error;  // of the median; each pair counts half, since a row belongs to several pairs
  std::size_t pairs;      // the number of pairs that have a lever
  double share;           // the share of the pairs' absolute differences that the cause removes; at most 1
  std::size_t scan = 0;   // for a gain: the index of the light in View::scans()
  double others = 0;  // for a gain: the largest share of the remaining differences that another light removes
};

struct Causes {
  std::size_t pairs = 0;
  std::optional<double> difference;  // median |log_ratio|; std::nullopt for fewer than kFewestPairs
  std::vector<Explanation> tried;    // by falling share; a cause without enough pairs is not tried
  // The first entry of `tried`, if it meets the rule of its cause: its quartiles agree with the size and
  // exclude 0, and no rival removes as much.
  std::optional<Explanation> found;
  // True if the rule was met by a wide margin.
  bool is_certain = false;
};

inline constexpr std::size_t kFewestPairs = 8;

// Tries every cause on the reciprocal pairs of the view.
Causes causes_of(const View& view, const std::vector<Pair>& pairs);

}  // namespace brdf::sheet
