// The weights of draws: the moments of their mean, and the draws with a weight that is not finite.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "validate/joint/pointwise.h"

namespace brdf::validate {

// The moments of one channel's weights.
class Moments {
 public:
  void add(double weight);

  long count() const { return count_; }
  double smallest() const { return smallest_; }
  double largest() const { return largest_; }
  double mean() const { return first_ + shifted(); }
  double variance() const;
  double error() const;  // standard error of the mean
  double skewness() const;

 private:
  double shifted() const { return sum_ / double(count_); }

  // Of the differences from the first weight, so that equal weights have no variance from rounding.
  double first_ = 0, sum_ = 0, sum2_ = 0, sum3_ = 0, smallest_ = 0, largest_ = 0;
  long count_ = 0;
};

// The weight of a draw is the value that the sampler returns as f cos_i / pdf, or else f cos_i of the
// reflectance over the density. A draw that is lost has the weight 0. Without a density and without such a
// value there are no weights.
class Weights {
 public:
  explicit Weights(std::size_t channels) : of_(channels) {}

  void add(const Trio& trio, const Quantities& quantities, std::span<const double> u,
           std::span<const Draw> draws);

  const std::vector<Moments>& of() const { return of_; }  // of each channel, of the finite weights
  const ComparedDraws& not_finite() const { return not_finite_; }
  const std::string& reason() const { return reason_; }  // of the first draw that is not finite

 private:
  std::vector<Moments> of_;
  ComparedDraws not_finite_;
  std::string reason_;
};

}  // namespace brdf::validate
