// The message of the window: the last action or the last error.
#pragma once

#include <exception>
#include <functional>
#include <string>

#include "io/files/error.h"

namespace brdf::render {

class Messages {
 public:
  // `wake`: called with each message, so that the message is drawn.
  explicit Messages(std::function<void()> wake) : wake_(std::move(wake)) {}

  void say(const std::string& message);
  // Shows the error and prints it on the terminal, too.
  void complain(const std::exception& error);
  // Removes an error, because the user has done something else since. Other messages stay.
  void forget_error();
  // Shows an earlier error again.
  void keep(const std::string& error);
  // Runs an action that may fail because of invalid files or the machine. Shows the error and returns false
  // if the action throws InputError or EnvironmentError.
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
