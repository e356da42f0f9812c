// A fit that goes on beside the window.
#pragma once

#include <chrono>
#include <future>
#include <optional>

#include "render/viewer/by_hand.h"

namespace brdf::render {

class FitTask {
 public:
  ~FitTask();
  // One at a time.
  void start(const Solver& solver, const Material& from, const io::SampleTable& samples);
  bool running() const { return found_.valid(); }
  void stop() { stop_ = true; }
  double seconds() const;
  // Once, when it has ended. Throws what the fit threw.
  std::optional<Fitted> take();

 private:
  std::atomic<bool> stop_ = false;
  std::chrono::steady_clock::time_point begun_;
  std::future<Fitted> found_;
};

}  // namespace brdf::render
