// The values at a sampled direction and at directions that differ from it by rounding.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "validate/joint/trio.h"

namespace brdf::validate {

// A sampler and a density function get the same direction by different operations, so that both may differ
// where the values change steeply: at a narrow lobe, at an edge, or where light and viewer cancel.
class RoundedDirection {
 public:
  // `wi`: a unit direction above the horizon.
  RoundedDirection(const Trio& trio, const Vec3<double>& wi);

  // Direction 0 is `wi` itself.
  std::size_t count() const { return wi_.size(); }
  const Vec3<double>& wi(std::size_t n) const { return wi_[n]; }
  double f(std::size_t channel, std::size_t n) const { return f_[channel * wi_.size() + n]; }    // 1/sr
  double density(std::size_t n) const { return density_.empty() ? std::nan("") : density_[n]; }  // 1/sr

  // Returns whether `returned` differs from value_at(*this, 0) by at most the largest change of value_at by
  // rounding. False if a number is not finite.
  template <class ValueAt>
  bool explains(double returned, const ValueAt& value_at) const {
    const double here = value_at(*this, 0);
    double change = 0;
    for (std::size_t n = 1; n < count(); ++n) {
      const double there = std::abs(value_at(*this, n) - here);
      if (std::isfinite(there)) change = std::max(change, there);
    }
    return std::abs(returned - here) <= change;
  }

 private:
  std::vector<Vec3<double>> wi_;
  std::vector<double> f_, density_;
};

}  // namespace brdf::validate
