#include "cli/options/progress.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "cli/options/terminal.h"
#include "io/files/text.h"

namespace brdf::cli {
namespace {

constexpr int kBar = 20;      // characters
constexpr double kShort = 2;  // seconds; shorter work needs no bar

std::string duration_text(double seconds) {
  const long long s = std::llround(std::ceil(seconds));
  if (s < 60) return std::to_string(s) + " s";
  if (s < 3600) return std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s";
  return std::to_string(s / 3600) + " h " + std::to_string(s % 3600 / 60) + " min";
}

std::atomic<bool> is_shown = false;

// Rewrites one line on stderr. The destructor erases the line.
class Line {
 public:
  Line() = default;
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  ~Line() { erase_progress(); }

  void show(const std::string& what, double fraction) const {
    if (fraction >= 1) return erase_progress();
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const int columns = columns_of(STDERR_FILENO);
    is_shown = true;
    std::cerr << '\r' + progress_text(what, fraction, seconds, columns ? columns : 80) + "\x1b[K"
              << std::flush;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

bool shows_progress() {
  return !is_quiet() && isatty(STDERR_FILENO) != 0;
}

void erase_progress() {
  if (is_shown.exchange(false)) std::cerr << "\r\x1b[K" << std::flush;
}

std::string progress_text(const std::string& what, double fraction, double seconds, int columns) {
  std::string text;
  if (seconds >= kShort && fraction > 0) {
    const int full = int(fraction * kBar);
    text = "[" + std::string(std::size_t(full), '#') + std::string(std::size_t(kBar - full), '.') + "] " +
           duration_text(seconds * (1 - fraction) / fraction) + " left  ";
  }
  text += io::printable(what);
  // A character in the last column would wrap.
  if (int(text.size()) >= columns) text.resize(std::size_t(columns - 1));
  return text;
}

std::function<void(int, int)> progress_line(std::string what) {
  if (!shows_progress()) return [](int, int) {};
  return [what = std::move(what), line = std::make_shared<Line>()](int done, int total) {
    line->show(what + ": " + std::to_string(done) + " of " + std::to_string(total), double(done) / total);
  };
}

std::function<void(double, const std::string&)> percent_line() {
  if (!shows_progress()) return [](double, const std::string&) {};
  return [line = std::make_shared<Line>()](double fraction, const std::string& what) {
    char percent[16];
    std::snprintf(percent, sizeof percent, "%3.0f %%  ", 100 * fraction);
    line->show(percent + what, fraction);
  };
}

std::function<void(const std::string&)> step_line(std::string before) {
  if (!shows_progress()) return [](const std::string&) {};
  return [before = std::move(before), line = std::make_shared<Line>()](const std::string& what) {
    line->show(before + ": " + what, 0);
  };
}

}  // namespace brdf::cli
