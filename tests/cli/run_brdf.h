// Runs the built executable for tests.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "io/files/temporary.h"

namespace brdf {

struct Outcome {
  int exit_code;
  std::string out, err;
};

inline std::string file_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

// Sets an environment variable for the programs that are run, and restores it on destruction.
class Setting {
 public:
  Setting(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    value ? setenv(name, value, 1) : unsetenv(name);
  }
  ~Setting() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

// Runs this command of the shell in this folder.
inline Outcome run_shell(const std::string& command, const std::filesystem::path& folder) {
  const std::filesystem::path out = folder / ".out", err = folder / ".err";
  const int status = std::system(("cd '" + folder.string() + "' && { " + command + "; } >'" + out.string() +
                                  "' 2>'" + err.string() + "'")
                                     .c_str());
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), file_text(out),
                  file_text(err)};
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return outcome;
}

// Runs the built executable in this folder with these arguments, in the syntax of a shell.
inline Outcome run_brdf(const std::string& arguments, const std::filesystem::path& folder) {
  return run_shell("'" BRDF_EXECUTABLE "' " + arguments, folder);
}

// Does the same, and interrupts as Ctrl-C does. The run must last much longer than its start: an interruption
// before the work has begun ends the program by the signal (130), so a busy machine gets a longer delay.
inline Outcome run_interrupted(const std::string& arguments, const std::filesystem::path& folder) {
  Outcome outcome;
  for (double delay = 0.25; delay < 60; delay *= 2) {
    outcome = run_shell("env --default-signal=INT timeout --preserve-status -s INT " + std::to_string(delay) +
                            " '" BRDF_EXECUTABLE "' " + arguments,
                        folder);
    if (outcome.exit_code != 130) break;
  }
  return outcome;
}

// A temporary folder in which a test writes files and runs the executable.
class InFolder : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& content) {
    std::ofstream(folder_.path() / name) << content;
  }
  std::string text(const std::string& name) { return file_text(folder_.path() / name); }
  bool exists(const std::string& name) { return std::filesystem::exists(folder_.path() / name); }
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }

  const io::TemporaryFolder folder_;
};

}  // namespace brdf
