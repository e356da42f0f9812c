// Evaluates the forms with 50 digits, as the truth against which float and double are measured.
//
// The same templates run in all scalars, so this measures rounding only.
// tests/libbrdf/exact/textbook_test.cpp checks the templates against plain transcriptions of the published
// equations.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <span>
#include <type_traits>
#include <vector>

#include "brdf/geometry.h"
#include "brdf/reflectance.h"

namespace brdf::validate {

using Exact =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

// Returns the unit direction that the rounded vector `w` represents.
template <class Truth = Exact, class T>
Vec3<Truth> exact_direction(const Vec3<T>& w) {
  using std::sqrt;
  const Vec3<Truth> v{Truth(w.x), Truth(w.y), Truth(w.z)};
  return v * (Truth(1) / sqrt(dot(v, v)));
}

// Returns f_r of one channel in 1/sr for each set of weights. Parameters are in table order. Cosines below
// `min_cosine` are raised to it; pass the minimum of the scalar under test. Available for Truth = Exact,
// Extended and double (double is the truth for float).
template <class Truth>
std::vector<Truth> exact_eval(const Reflectance& form,
                              std::type_identity_t<std::span<const std::vector<Truth>>> weights,
                              std::type_identity_t<std::span<const Truth>> shape, const Vec3<Truth>& wi,
                              const Vec3<Truth>& wo, double min_cosine);

}  // namespace brdf::validate

namespace boost::multiprecision {
// Returns exp(x^2) erfc(x) for x >= 0. The forms find this overload through argument-dependent lookup.
brdf::validate::Exact erfcx(const brdf::validate::Exact& x);
}  // namespace boost::multiprecision
