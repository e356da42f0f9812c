#include "render/viewer/fit_task.h"

namespace brdf::render {

FitTask::~FitTask() {
  stop();
  if (running()) found_.wait();
}

void FitTask::start(const Solver& solver, const Material& from, const io::SampleTable& samples) {
  stop_ = false;
  begun_ = std::chrono::steady_clock::now();
  found_ = std::async(std::launch::async,
                      [this, fit = solver.fit, from, samples] { return fit(from, samples, stop_); });
}

double FitTask::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
}

std::optional<Fitted> FitTask::take() {
  if (!running() || found_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  return found_.get();
}

}  // namespace brdf::render
