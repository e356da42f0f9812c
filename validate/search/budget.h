// How long the searches of a check may go on.
#pragma once

#include <chrono>

namespace brdf::validate {

class Budget {
 public:
  // 0 seconds are no limit. Time runs from here.
  explicit Budget(double seconds) : seconds_(seconds) {}

  // Whether a search may look at one more point. The first points of a check are always looked at, so that
  // its finding names one.
  bool take() {
    const bool may = left_out_ == 0 && (seconds_ <= 0 || looked_at_ < kAlways || elapsed() < seconds_);
    ++(may ? looked_at_ : left_out_);
    return may;
  }

  long looked_at() const { return looked_at_; }
  // Points that the searches asked for in vain. A search that is not cut short may ask for more.
  long left_out() const { return left_out_; }
  double seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr long kAlways = 32;

  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  Clock::time_point start_ = Clock::now();
  double seconds_;
  long looked_at_ = 0, left_out_ = 0;
};

}  // namespace brdf::validate
