// Runs long work while the interpreter continues: other threads run, Ctrl-C is handled, and progress is
// reported.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>

namespace brdf::python {

namespace py = pybind11;

// Thrown by the progress function of a piece of work to end the work from inside.
struct Stopped {};

// The requests to a piece of work from outside. A callback that returns False requests a stop. A callback
// that raises an exception also requests a stop, and the exception is raised at the end.
class Watch {
 public:
  explicit Watch(py::object callback) : callback_(std::move(callback)) {}

  const std::atomic<bool>& stop() const { return stop_; }

  // Calls the callback. The work calls this function on any thread, without the interpreter's lock.
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
  // Does the same for work that can be ended only by an exception.
  template <class... Values>
  void tell_or_throw(const Values&... values) {
    tell(values...);
    if (stop_) throw Stopped{};
  }

  // Stores an exception that is to be raised later, and requests a stop.
  void keep(std::exception_ptr error);
  void rethrow() const;

 private:
  py::object callback_;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::exception_ptr error_;
};

// Runs the work without the interpreter's lock. In the main thread, signals are checked meanwhile: Ctrl-C
// stops the work and is raised after the work has ended. Then raises the exception of the work or of its
// callback.
void run_watched(Watch& watch, const std::function<void()>& work);

}  // namespace brdf::python
