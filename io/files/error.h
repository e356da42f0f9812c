#pragma once

#include <stdexcept>

namespace brdf {

// Bad input or usage: one message that names the file, the
// line or JSON path, the value and the rule. Exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A table whose polar angles and azimuths stand in each other's columns, as far as their ranges tell.
class ExchangedColumns : public InputError {
 public:
  using InputError::InputError;
};

// The machine lacks something (a driver, a display, space on the disk). Exit code 3.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace brdf
