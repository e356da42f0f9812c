// Long work beside an interpreter that goes on: other threads run, Ctrl-C is heard, progress is told.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>

namespace brdf::python {

namespace py = pybind11;

// Ends work from inside: its progress throws it.
struct Stopped {};

// What a piece of work is asked to do from outside. A callback that returns False asks it to stop; one that
// raises too, and what it raised is raised at the end.
class Watch {
 public:
  explicit Watch(py::object callback) : callback_(std::move(callback)) {}

  const std::atomic<bool>& stop() const { return stop_; }
  void ask_to_stop() { stop_ = true; }

  // Called by the work, on any thread, without the interpreter's lock.
  template <class... Values>
  void tell(const Values&... values) {
    if (callback_.is_none() || stop_) return;
    const py::gil_scoped_acquire lock;
    try {
      if (const py::object answer = callback_(values...); answer.ptr() == Py_False) stop_ = true;
    } catch (const py::error_already_set&) {
      keep(std::current_exception());
    }
  }
  // The same for work that only an exception ends.
  template <class... Values>
  void tell_or_throw(const Values&... values) {
    tell(values...);
    if (stop_) throw Stopped{};
  }

  // Keeps what is to be raised and asks to stop.
  void keep(std::exception_ptr error);
  void rethrow() const;

 private:
  py::object callback_;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::exception_ptr error_;
};

// Runs the work without the interpreter's lock. In the main thread signals are heard meanwhile: Ctrl-C stops
// the work and is raised when it has ended. Then raises what the work or its callback threw.
void run_watched(Watch& watch, const std::function<void()>& work);

}  // namespace brdf::python
