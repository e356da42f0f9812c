// Points that fill the unit cube evenly however many there are: the additive
// recurrence with the generalised golden ratio (Roberts 2018).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace brdf {

// The root above 1 of x^(d+1) = x + 1, by Newton's iteration.
constexpr double generalised_golden_ratio(std::size_t dimensions) {
  long double x = 2;
  for (int step = 0; step < 60; ++step) {
    long double power = 1;
    for (std::size_t k = 0; k < dimensions; ++k) power *= x;
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

// How far each coordinate moves from one point to the next: the powers of 1 / ratio.
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

// A coordinate of the k-th point, in [0, 1): the fraction of start + k step, for start and step from 0 on.
inline double additive_recurrence(double start, double step, std::uint64_t k) {
  double whole;
  return std::modf(start + step * double(k), &whole);
}

}  // namespace brdf
