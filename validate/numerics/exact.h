// The forms in 50 digits: the truth that float and double are measured against.
//
// The same templates run, so this measures rounding; that the templates are the published equations is tested
// against plain transcriptions (tests/libbrdf/exact/textbook_test.cpp).
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

// The unit direction that a rounded one stands for.
template <class Truth = Exact, class T>
Vec3<Truth> exact_direction(const Vec3<T>& w) {
  using std::sqrt;
  const Vec3<Truth> v{Truth(w.x), Truth(w.y), Truth(w.z)};
  return v * (Truth(1) / sqrt(dot(v, v)));
}

// f_r of one channel in 1/sr for each set of weights, parameters in table order; cosines below `min_cosine`
// are evaluated there (it is the one of the scalar under test). For Truth = Exact, and double, which is the
// truth that float is measured against.
template <class Truth>
std::vector<Truth> exact_eval(const Reflectance& form,
                              std::type_identity_t<std::span<const std::vector<Truth>>> weights,
                              std::type_identity_t<std::span<const Truth>> shape, const Vec3<Truth>& wi,
                              const Vec3<Truth>& wo, double min_cosine);

}  // namespace brdf::validate

namespace boost::multiprecision {
// exp(x^2) erfc(x) for x >= 0, found by the forms through argument-dependent lookup.
brdf::validate::Exact erfcx(const brdf::validate::Exact& x);
}  // namespace boost::multiprecision
