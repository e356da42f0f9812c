// Divides the drawing of a window's pictures into frames of limited time, to keep the window responsive.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>
#include <vector>

namespace brdf::render {

// Times in milliseconds that the parts of a picture took when they were last drawn.
class PartTimes {
 public:
  double of(int part) const {
    return std::size_t(part) < times_.size() && times_[std::size_t(part)] >= 0 ? times_[std::size_t(part)]
                                                                               : kGuess;
  }
  void set(int part, double ms) {
    if (std::size_t(part) >= times_.size()) times_.resize(std::size_t(part) + 1, -1);
    times_[std::size_t(part)] = ms;
  }

 private:
  static constexpr double kGuess = 6;  // for a part that was never drawn
  std::vector<double> times_;          // negative: not known
};

class Pace {
 public:
  using Clock = std::function<double()>;  // returns milliseconds
  static double steady_clock() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
  }
  // A frame of 40 ms, less 15 ms for panels and presentation (at 1280 x 720 up to 37 ms of processor
  // time, which two cores share).
  static constexpr double kPatience = 25;

  explicit Pace(Clock clock = steady_clock) : clock_(std::move(clock)) {}

  void begin_frame() {
    begun_ = clock_();
    has_drawn_ = false;
  }
  // Returns how many of the parts from `first` to `parts` fit into the rest of the frame's time; 0 if none
  // fits. The first call of a frame returns at least 1, so that every frame makes progress.
  int next(const PartTimes& times, int first, int parts) {
    started_ = clock_();
    const double left = kPatience - (started_ - begun_);
    double sum = 0;
    int count = 0;
    while (first + count < parts) {
      sum += times.of(first + count);
      if (sum > left && (has_drawn_ || count > 0)) break;
      ++count;
    }
    has_drawn_ |= count > 0;
    return count;
  }
  // Records that the parts of the last next() are drawn.
  void took(PartTimes& times, int first, int count) const {
    const double each = (clock_() - started_) / std::max(count, 1);
    for (int part = first; part < first + count; ++part) times.set(part, each);
  }

 private:
  Clock clock_;
  double begun_ = 0, started_ = 0;
  bool has_drawn_ = false;
};

// Chooses how many pixels of the window lie across one drawn pixel during movements.
class Coarseness {
 public:
  int across() const { return across_; }
  // Records the time of a picture in milliseconds. If a frame has no time for it, the next pictures are
  // coarser. They do not become finer again, because each change costs a new renderer.
  void took(double ms) {
    if (across_ == kMost || ++pictures_ <= kSettling || ms <= Pace::kPatience) return;
    across_ = std::min(kMost, across_ + (ms > kFar * Pace::kPatience ? 2 : 1));
    pictures_ = 0;
  }

 private:
  // kSettling: the first pictures include the compilation of shaders.
  static constexpr int kMost = 4, kSettling = 3;
  static constexpr double kFar = 2.5;

  int across_ = 2, pictures_ = 0;
};

}  // namespace brdf::render
