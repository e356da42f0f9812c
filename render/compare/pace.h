// How many samples of an environment's light each picture of a window brings in: no more than it can wait
// for.
#pragma once

#include <algorithm>

#include "render/light/points.h"

namespace brdf::render {

class Pace {
 public:
  // One that does not adapt always brings a whole run.
  explicit Pace(bool adapts) : adapts_(adapts), run_(adapts ? kFirst : kRun) {}

  int run() const { return run_; }
  // A picture begins anew: with as many samples as the last ones' time allows.
  void begin() {
    if (of_one_ > 0) run_ = std::clamp(int(kPatience / of_one_), 1, kRun);
  }
  // The last picture's samples took so many milliseconds.
  void took(double ms) {
    if (adapts_ && ms > 0) of_one_ = ms / run_;
  }
  // Whether what has been drawn so far is better begun anew than gone on with.
  bool too_slow() const { return run_ > 1 && of_one_ * run_ > kTooMuch * kPatience; }

 private:
  static constexpr int kFirst = 4;
  static constexpr double kPatience = 40, kTooMuch = 4;  // milliseconds, times that

  bool adapts_;
  int run_;
  double of_one_ = 0;  // milliseconds; 0: not known
};

}  // namespace brdf::render
