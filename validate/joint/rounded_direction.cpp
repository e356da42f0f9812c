#include "validate/joint/rounded_direction.h"

#include <cfloat>

namespace brdf::validate {
namespace {

// A reflection at a half vector has a few dozen roundings, each of half a unit in the last place.
constexpr double kRoundings = 64 * DBL_EPSILON;

}  // namespace

RoundedDirection::RoundedDirection(const Trio& trio, const Vec3<double>& wi) : wi_{wi} {
  for (const double step : {-kRoundings, kRoundings}) {
    wi_.push_back({wi.x + step, wi.y, wi.z});
    wi_.push_back({wi.x, wi.y + step, wi.z});
    wi_.push_back({wi.x, wi.y, wi.z + step});
  }
  f_ = trio.f(wi_, false);
  if (trio.facts().has_density) density_ = trio.density(wi_);
}

}  // namespace brdf::validate
