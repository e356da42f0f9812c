// Limits how long the searches of a check may run.
#pragma once

#include <atomic>
#include <chrono>

namespace brdf::validate {

class Budget {
 public:
  // `seconds`: the limit; 0 means no limit. The time starts at construction.
  explicit Budget(double seconds) : seconds_(seconds) {}

  // Counts one point and returns whether a search may evaluate it. The first points of a check are always
  // permitted, so that its finding names a point.
  bool take() {
    const bool may = left_out_ == 0 && (seconds_ <= 0 || looked_at_ < kAlways || elapsed() < seconds_);
    ++(may ? looked_at_ : left_out_);
    return may;
  }

  long looked_at() const { return looked_at_; }
  // Number of points that take() refused. Without the limit a search may request more points than these.
  long left_out() const { return left_out_; }
  double seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr long kAlways = 32;

  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  Clock::time_point start_ = Clock::now();
  double seconds_;
  std::atomic<long> looked_at_ = 0, left_out_ = 0;
};

}  // namespace brdf::validate
