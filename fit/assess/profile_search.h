// The profile of one reported parameter: the least cost at each of its values, minimised over all other
// parameters within their bounds.
#pragma once

#include <atomic>
#include <mutex>
#include <span>
#include <vector>

#include "fit/assess/curvature.h"
#include "fit/assess/profile_point.h"

namespace brdf::fit {

// The crossing of the profile and its level on one side.
struct ProfileEnd {
  // On the level to 2 % of its root. At the limit of the range if the profile stays below the level.
  ProfilePoint at;
  // True if the profile stays below the level up to the limit of the range. Also true if the profile does
  // not keep rising beyond the crossing: to five times the level (about five standard errors), or up to the
  // limit at half the rate of a parabola.
  bool open = false;
  // The profile reaches the limit of the range before it reaches five times the level.
  bool limit_is_near = false;
};

// A point with known cost, given as the rise above the minimum cost.
struct CostedPoint {
  std::vector<double> p;  // the solver's parameters
  double rise = 0;
};

struct ProfileSides {
  ProfileEnd low, high;
  // At each end, and at 2.5 times its distance, the root of the rise is within 15 % of the parabola's.
  bool quadratic = true;
  std::vector<CostedPoint> near;  // every point below five times the level that the search evaluated
};

// The level, and its distance from the minimum according to the curvature: t standard errors on the scale
// of the interval. `of_lobes` is the highest level of the parameters of lobes, set for a parameter of a
// lobe: a valley is as long for a weight as for the width that changes with it.
struct ProfileLevel {
  double rise = 0, error = 0, of_lobes = 0;
};

// Points other than the minimum with a cost that may be close to the minimum: the other minima, and the
// shapes of the grid with their best weights. The grid's points are computed on the first request. points()
// may be called from several threads.
class ProfileSeeds {
 public:
  ProfileSeeds(const SampleStream& stream, std::vector<std::vector<double>> minima)
      : stream_(stream), points_(std::move(minima)), any_(!points_.empty()) {}
  // Returns the points, and computes them on the first call.
  const std::vector<std::vector<double>>& points();
  bool any() const { return any_; }  // other minima exist

 private:
  const SampleStream& stream_;
  std::vector<std::vector<double>> points_;
  bool any_;
  std::once_flag filled_;
};

// The inputs of the search.
struct ProfileStart {
  const SampleStream& stream;
  const Minimum& minimum;
  const Curvature& curvature;
  ProfileSeeds& seeds;
  const std::atomic<bool>* interrupted = nullptr;
};

// Finds the ends of the profile of `r`, number `index` of the reported parameters, on both sides of the
// minimum. The points are exact even if the search is interrupted: each cost and each parameter value was
// evaluated.
ProfileSides find_ends(const ProfileStart& start, const Reported& r, std::size_t index, ProfileLevel level);

// Moves the ends outwards to points that the search from the minimum did not reach. It uses the `known`
// points below five times the level, and other shapes, over their grids, in case a valley bends away.
void extend_ends(const ProfileStart& start, const Reported& r, std::size_t index, ProfileLevel level,
                 std::span<const CostedPoint> known, ProfileSides& sides);

}  // namespace brdf::fit
