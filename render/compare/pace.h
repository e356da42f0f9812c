// Chooses the number of samples of an environment's light for each picture of a window, to keep the window
// responsive.
#pragma once

#include <algorithm>

#include "render/light/points.h"

namespace brdf::render {

class Pace {
 public:
  // `adapts`: false always draws whole runs of kRun samples.
  explicit Pace(bool adapts) : adapts_(adapts), run_(adapts ? kFirst : kRun) {}

  int run() const { return run_; }
  // Starts a new picture, with as many samples as the last measured time permits.
  void begin() {
    if (of_one_ > 0) run_ = std::clamp(int(kPatience / of_one_), 1, kRun);
  }
  // Records the time of the last picture's samples, in milliseconds.
  void took(double ms) {
    if (adapts_ && ms > 0) of_one_ = ms / run_;
  }
  // Returns whether starting anew with a shorter run is better than continuing the present picture.
  bool too_slow() const { return run_ > 1 && of_one_ * run_ > kTooMuch * kPatience; }

 private:
  static constexpr int kFirst = 4;
  static constexpr double kPatience = 40, kTooMuch = 4;  // kPatience in milliseconds; kTooMuch is a factor

  bool adapts_;
  int run_;
  double of_one_ = 0;  // milliseconds per sample; 0: not yet measured
};

}  // namespace brdf::render
