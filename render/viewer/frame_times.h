// Times of frames: the last one, and the median of all.
#pragma once

#include <chrono>
#include <vector>

#include "io/files/numbers.h"

namespace brdf::render {

class FrameTimes {
 public:
  // `all`: each frame's time is kept for the median.
  explicit FrameTimes(bool all) : all_(all) {}

  void begin() { begun_ = Clock::now(); }
  void end() {
    last_ms_ = std::chrono::duration<double, std::milli>(Clock::now() - begun_).count();
    if (all_ && ++frames_ > kWarming) kept_.push_back(last_ms_);
  }
  double last_ms() const { return last_ms_; }
  // Returns 0 if no times were kept.
  double median_ms() const { return kept_.empty() ? 0 : io::median(kept_); }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kWarming = 5;  // frames that are not counted

  bool all_;
  Clock::time_point begun_;
  double last_ms_ = 0;
  std::size_t frames_ = 0;
  std::vector<double> kept_;
};

}  // namespace brdf::render
