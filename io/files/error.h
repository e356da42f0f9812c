// Exceptions for bad input and for failures of the machine, with the exit codes of the programs.
#pragma once

#include <stdexcept>

namespace brdf {

// Bad input or usage. The message names the file, the line or JSON path, the value and the rule. Exit code
// 2.
// Example:
//     // #include "brdf/io/formats/read.h"
//     try {
//       brdf::io::read_samples("no such file.csv");
//     } catch (const brdf::InputError& error) {
//       std::printf("%s\n", error.what());
//     }
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A table in which the columns of polar angles and of azimuths are exchanged, judged by the ranges of their
// values.
class ExchangedColumns : public InputError {
 public:
  using InputError::InputError;
};

// The machine lacks something, for example a driver, a display or disk space. Exit code 3.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace brdf
