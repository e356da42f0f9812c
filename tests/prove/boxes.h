// Random boxes of a form's domain, small and large, and random points inside them.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <utility>

#include "brdf/reflectance.h"
#include "prove/scalar/enclosed.h"

namespace brdf::prove {

using Box = std::vector<Bounds>;
using Engine = std::mt19937_64;

inline double uniform(Engine& e, double low, double high) {
  return std::clamp(low + (high - low) * std::generate_canonical<double, 53>(e), low, high);
}

// Returns a value anywhere in `range`, with additional probability at its ends and near them.
inline double anywhere(Engine& e, const Variable& v, Bounds range) {
  const double kind = uniform(e, 0, 1);
  if (kind < 0.1) return range.lo;
  if (kind < 0.2) return range.hi;
  if (kind < 0.5 && v.cut != Variable::Cut::middle) {
    const double low = std::log(std::max(range.lo, 1e-13)), high = std::log(std::max(range.hi, 1e-13));
    return std::clamp(std::exp(uniform(e, low, high)), range.lo, range.hi);
  }
  return uniform(e, range.lo, range.hi);
}

inline Box random_box(Engine& e, const Domain& domain) {
  Box box;
  for (const Variable& v : domain.variables) {
    const Bounds all{v.low, v.high};
    const double a = anywhere(e, v, all), b = anywhere(e, v, all), share = std::pow(10, uniform(e, -8, 0));
    const double kind = uniform(e, 0, 1);
    const double other = kind < 0.3 ? a : kind < 0.8 ? std::clamp(a + (b - a) * share, v.low, v.high) : b;
    box.push_back({std::min(a, other), std::max(a, other)});
  }
  return box;
}

// Returns a direction with this cosine and turn, rounded to T. A component that is not 0 is sometimes moved
// by one unit in the last place.
template <class T>
Vec3<T> direction_of(Engine& e, double cosine, double turn) {
  const long double t = turn, z = cosine;
  const long double x = 1 - std::fabs(t), y = std::fabs(t) <= 1 ? t : (t > 0 ? 2 - t : -2 - t);
  const long double s = std::sqrt((1 - z) * (1 + z)) / std::hypot(x, y);
  const auto stored = [&](long double c) {
    T r = T(c);
    const double kind = uniform(e, 0, 1);
    if (kind < 0.1 && r != 0) r = std::nextafter(r, T(2));
    if (kind > 0.9 && r > 0) r = std::nextafter(r, T(0));
    return r;
  };
  return {stored(s * x), stored(s * y), stored(z)};
}

// The position of each group of variables in a box.
struct Parts {
  std::size_t shape, weights, first, directions;
};
inline Parts parts_of(const ReflectanceInfo& form, const Domain& domain) {
  const std::size_t shape = form.shape.size(), weights = form.weights.size();
  const bool own = domain.variables.size() == shape + 2 * weights + 4;
  return {0, shape, own ? shape + weights : shape,
          domain.variables.size() - (domain.variables.back().name == "cos_dphi" ? 3 : 4)};
}

// Returns the directions at a point of value_domain_of(form): cosines and turns or, for a basis, r_i, r_o and
// the cosine of the difference of the azimuths.
template <class T>
std::pair<Vec3<T>, Vec3<T>> pair_in(Engine& e, const ReflectanceInfo& form, std::span<const double> at) {
  if (!form.basis) return {direction_of<T>(e, at[0], at[1]), direction_of<T>(e, at[2], at[3])};
  const double cosine = at[2], sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
  const double turn = cosine >= 0 ? sine / (sine + cosine) : 1 - cosine / (sine - cosine);
  return {direction_of<T>(e, 1 - at[0] * at[0], 0), direction_of<T>(e, 1 - at[1] * at[1], turn)};
}

}  // namespace brdf::prove
