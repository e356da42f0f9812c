#include "cli/progress.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace brdf::cli {

bool shows_progress() {
  return isatty(STDERR_FILENO) != 0;
}

std::function<void(int, int)> progress_line(std::string what) {
  if (!shows_progress()) return [](int, int) {};
  return [what = std::move(what)](int done, int total) {
    std::cerr << '\r' << what << ": " << done << " of " << total << "\x1b[K";
    if (done == total) std::cerr << "\r\x1b[K";
    std::cerr.flush();
  };
}

std::function<void(double, const std::string&)> percent_line() {
  if (!shows_progress()) return [](double, const std::string&) {};
  return [](double fraction, const std::string& what) {
    std::fprintf(stderr, "\r\x1b[K%3.0f %%  %s", 100 * fraction, what.c_str());
    if (fraction >= 1) std::fprintf(stderr, "\r\x1b[K");
  };
}

}  // namespace brdf::cli
