// A fit that runs in the background while the window stays responsive.
#pragma once

#include <chrono>
#include <future>
#include <optional>

#include "render/viewer/by_hand.h"

namespace brdf::render {

class FitTask {
 public:
  ~FitTask();
  // Starts a fit. Only one fit can run at a time.
  void start(const Solver& solver, const Material& from, const io::SampleTable& samples);
  bool running() const { return found_.valid(); }
  void stop() { stop_ = true; }
  double seconds() const;
  // Returns the result once, when the fit has ended. Throws the exception of the fit.
  std::optional<Fitted> take();

 private:
  std::atomic<bool> stop_ = false;
  std::chrono::steady_clock::time_point begun_;
  std::future<Fitted> found_;
};

}  // namespace brdf::render
