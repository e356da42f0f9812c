// What the window says: the last thing that was done, or what went wrong.
#pragma once

#include <exception>
#include <functional>
#include <string>

#include "io/files/error.h"

namespace brdf::render {

class Messages {
 public:
  // `wake`: called with every message, so that it is drawn.
  explicit Messages(std::function<void()> wake) : wake_(std::move(wake)) {}

  void say(const std::string& message);
  // On the terminal, too.
  void complain(const std::exception& error);
  // An error that was said before stands there again.
  void keep(const std::string& error);
  // Runs what may fail for want of a good file or a good machine; complains where it does.
  template <class Action>
  bool attempt(Action action) {
    try {
      action();
      return true;
    } catch (const InputError& error) {
      complain(error);
    } catch (const EnvironmentError& error) {
      complain(error);
    }
    return false;
  }

  const std::string& last() const { return last_; }
  bool is_error() const { return is_error_; }

 private:
  std::function<void()> wake_;
  std::string last_;
  bool is_error_ = false;
};

}  // namespace brdf::render
