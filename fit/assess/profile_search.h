// The profile of one reported parameter: the least cost at each of its values, all others free within their
// bounds.
#pragma once

#include <atomic>
#include <mutex>
#include <span>
#include <vector>

#include "fit/assess/curvature.h"
#include "fit/assess/profile_point.h"

namespace brdf::fit {

// Where the profile crosses its level on one side.
struct ProfileEnd {
  // On the level to 2 % of its root; at the limit of the range where the profile stays below the level.
  ProfilePoint at;
  // The profile stays below the level up to the limit of the range, or beyond the crossing it does not go on
  // rising: to five times the level (some five standard errors), or at half the pace of a parabola up to the
  // limit.
  bool open = false;
  // The profile reaches the limit of the range before it reaches five times the level.
  bool limit_is_near = false;
};

// A point whose cost is known, by what it is above the minimum's.
struct CostedPoint {
  std::vector<double> p;  // the solver's parameters
  double rise = 0;
};

struct ProfileSides {
  ProfileEnd low, high;
  // At each end, and at 2.5 times its distance, the root of the rise is within 15 % of the parabola's.
  bool quadratic = true;
  std::vector<CostedPoint> near;  // every point below five times the level that the search met
};

// The level, and how far from the minimum the curvature expects it: t standard errors on the scale of the
// interval. `of_lobes`: the highest level of the parameters of lobes, of a parameter that is one: a valley is
// as long for a weight as it is for the width that goes along it.
struct ProfileLevel {
  double rise = 0, error = 0, of_lobes = 0;
};

// Points besides the minimum whose cost may be within reach of it: the other minima, and the shapes of the
// grid with the best weights for them. The latter are found when they are first asked for; several threads
// may ask.
class ProfileSeeds {
 public:
  ProfileSeeds(const SampleStream& stream, std::vector<std::vector<double>> minima)
      : stream_(stream), points_(std::move(minima)), any_(!points_.empty()) {}
  const std::vector<std::vector<double>>& points();
  bool any() const { return any_; }  // other minima

 private:
  const SampleStream& stream_;
  std::vector<std::vector<double>> points_;
  bool any_;
  std::once_flag filled_;
};

// What the search starts from.
struct ProfileStart {
  const SampleStream& stream;
  const Minimum& minimum;
  const Curvature& curvature;
  ProfileSeeds& seeds;
  const std::atomic<bool>* interrupted = nullptr;
};

// Where the profile of `r`, number `index` of the reported parameters, crosses the level on the way out from
// the minimum. The points are exact whatever stops the search: their costs are costs, and their values the
// parameter's.
ProfileSides find_ends(const ProfileStart& start, const Reported& r, std::size_t index, ProfileLevel level);

// Moves the ends out to points that the way there did not see: `known` ones below five times the level, and
// other shapes, over their grids, for a valley that bends away.
void extend_ends(const ProfileStart& start, const Reported& r, std::size_t index, ProfileLevel level,
                 std::span<const CostedPoint> known, ProfileSides& sides);

}  // namespace brdf::fit
