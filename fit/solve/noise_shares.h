// The distribution of a parameter's variance over the values: whether many values or a few contribute.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace brdf::fit {

// The parts of a variance, one for each value: their sum, the sum of their squares, and the largest parts.
class NoiseShares {
 public:
  static constexpr std::size_t kLargest = 8;

  // Adds the part of one value.
  void add(double variance) {
    sum_ += variance;
    squares_ += variance * variance;
    if (!(variance > largest_[least_])) return;
    largest_[least_] = variance;
    least_ = std::size_t(std::ranges::min_element(largest_) - largest_.begin());
  }

  // Adds the parts of several values.
  void add(std::span<const double> variances) {
    NoiseShares all = *this;  // a local copy stays in registers
    for (const double variance : variances) all.add(variance);
    *this = all;
  }

  // Returns whether there is any noise.
  bool any() const { return squares_ > 0; }
  // Returns the degrees of freedom of the variance that is estimated from these values (Satterthwaite
  // 1946).
  double freedom() const { return sum_ * sum_ / squares_; }
  // Return the largest parts as shares of the whole, and the total share of the other parts with their
  // degrees of freedom.
  std::array<double, kLargest> largest() const {
    std::array<double, kLargest> out = largest_;
    for (double& share : out) share /= sum_;
    return out;
  }
  struct Others {
    double share = 0, freedom = 0;
  };
  Others others() const {
    double sum = sum_, squares = squares_;
    for (const double variance : largest_) sum -= variance, squares -= variance * variance;
    if (!(sum > 1e-9 * sum_) || !(squares > 0)) return {};
    return {sum / sum_, sum * sum / squares};
  }

 private:
  double sum_ = 0, squares_ = 0;
  std::array<double, kLargest> largest_{};
  std::size_t least_ = 0;  // index of the smallest of the largest parts
};

}  // namespace brdf::fit
