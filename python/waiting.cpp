#include "python/waiting.h"

#include <chrono>
#include <condition_variable>
#include <thread>

namespace brdf::python {
namespace {

constexpr std::chrono::milliseconds kListening{50};  // interval between two checks for a signal

bool in_main_thread() {
  const py::module_ threading = py::module_::import("threading");
  return threading.attr("get_ident")().equal(threading.attr("main_thread")().attr("ident"));
}

// Runs work on a thread of its own.
class Running {
 public:
  explicit Running(const std::function<void()>& work) : thread_([this, &work] { run(work); }) {}

  bool ended_within(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, time, [this] { return ended_; });
  }
  // Joins the thread and rethrows its exception. Precondition: the work has ended.
  void rethrow() {
    thread_.join();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void run(const std::function<void()>& work) {
    try {
      work();
    } catch (...) {
      error_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::exception_ptr error_;
  std::jthread thread_;  // last, since the thread uses the other members
};

void run_listening(Watch& watch, const std::function<void()>& work) {
  Running running(work);
  while (!running.ended_within(kListening)) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() == 0) continue;
    try {
      throw py::error_already_set();
    } catch (...) {
      watch.keep(std::current_exception());
    }
  }
  running.rethrow();
}

}  // namespace

void Watch::keep(std::exception_ptr error) {
  const std::lock_guard lock(mutex_);
  if (!error_) error_ = std::move(error);
  stop_ = true;
}

void Watch::rethrow() const {
  if (error_) std::rethrow_exception(error_);
}

void run_watched(Watch& watch, const std::function<void()>& work) {
  const bool listens = in_main_thread();
  try {
    const py::gil_scoped_release unlocked;
    if (listens)
      run_listening(watch, work);
    else
      work();
  } catch (const Stopped&) {
    watch.rethrow();
    throw;
  }
  watch.rethrow();
}

}  // namespace brdf::python
