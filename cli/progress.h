#pragma once

#include <functional>
#include <string>

namespace brdf::cli {

// A line on a terminal that counts finished parts ("brdf synth: 3 of 16"), rewritten in place and removed
// after the last; nothing where stderr is no terminal.
std::function<void(int done, int total)> progress_line(std::string what);

}  // namespace brdf::cli
