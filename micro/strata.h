// Evenly distributed random points of a period.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "micro/random.h"

namespace brdf::micro {

inline int strata_side(std::int64_t points) {
  return std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(points)))));
}

// Returns the number of points that for_each_stratum generates for `points`: the nearest square.
inline std::int64_t strata_count(std::int64_t points) {
  const std::int64_t side = strata_side(points);
  return side * side;
}

// Calls visit(u, v) with one random point in each of side x side equal parts of [0, 1)^2, row by row. This
// covers the plane evenly, and neighbouring rays meet neighbouring triangles while these are still in the
// cache.
template <class Visit>
void for_each_stratum(std::int64_t points, Random& random, const Visit& visit) {
  const int side = strata_side(points);
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const double u = (i + random.uniform()) / side, v = (j + random.uniform()) / side;
      visit(u, v);
    }
  }
}

}  // namespace brdf::micro
