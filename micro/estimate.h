// Means over independent surfaces.
#pragma once

#include <cmath>

namespace brdf::micro {

struct Estimate {
  double mean = 0;
  double standard_error = 0;  // of the mean, from the variation between surfaces
};

// Collects one value per surface (Welford's update, which avoids cancellation).
class Collector {
 public:
  void add(double value) {
    ++count_;
    const double difference = value - mean_;
    mean_ += difference / count_;
    squares_ += difference * (value - mean_);
  }
  // Returns the estimate. Requires at least two values; the standard error of a single value is NaN.
  Estimate estimate() const { return {mean_, std::sqrt(squares_ / (count_ * (count_ - 1)))}; }

 private:
  double count_ = 0, mean_ = 0, squares_ = 0;
};

}  // namespace brdf::micro
