// Points that fill the unit cube evenly for any number of points: the additive recurrence with the
// generalised golden ratio (Roberts 2018).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace brdf {

// Returns the root above 1 of x^(d+1) = x + 1, computed by Newton's method.
constexpr double generalised_golden_ratio(std::size_t dimensions) {
  long double x = 2, previous = 0;
  for (int step = 0; step < 60 && x != previous; ++step) {
    long double power = 1;
    for (std::size_t k = 0; k < dimensions; ++k) power *= x;
    previous = x;
    x -= (power * x - x - 1) / (static_cast<long double>(dimensions + 1) * power - 1);
  }
  return double(x);
}

namespace detail {
constexpr void fill_recurrence_steps(std::span<double> steps) {
  if (steps.empty()) return;
  const double ratio = generalised_golden_ratio(steps.size());
  double power = 1;
  for (double& step : steps) step = power /= ratio;
}
}  // namespace detail

// Returns the step of each coordinate from one point to the next. The steps are the powers of 1 / ratio.
template <std::size_t N>
constexpr std::array<double, N> additive_recurrence_steps() {
  std::array<double, N> steps{};
  detail::fill_recurrence_steps(steps);
  return steps;
}
inline std::vector<double> additive_recurrence_steps(std::size_t dimensions) {
  std::vector<double> steps(dimensions);
  detail::fill_recurrence_steps(steps);
  return steps;
}

// Returns a coordinate of the k-th point, in [0, 1): the fractional part of start + k step. start and step
// must not be negative.
inline double additive_recurrence(double start, double step, std::uint64_t k) {
  double whole;
  return std::modf(start + step * double(k), &whole);
}

}  // namespace brdf
