#include "cli/progress.h"

#include <unistd.h>

#include <iostream>

namespace brdf::cli {

std::function<void(int, int)> progress_line(std::string what) {
  if (isatty(STDERR_FILENO) == 0) return [](int, int) {};
  return [what = std::move(what)](int done, int total) {
    std::cerr << '\r' << what << ": " << done << " of " << total << "\x1b[K";
    if (done == total) std::cerr << "\r\x1b[K";
    std::cerr.flush();
  };
}

}  // namespace brdf::cli
