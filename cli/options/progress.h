// Progress of long work, shown on a terminal.
#pragma once

#include <functional>
#include <string>

namespace brdf::cli {

// Returns true if stderr is a terminal; progress is shown on terminals only.
bool shows_progress();

// Returns the text of a progress line after `seconds`. From two seconds on, the text has a bar and the
// remaining time, extrapolated from the completed fraction. The text has at most `columns` characters.
std::string progress_text(const std::string& what, double fraction, double seconds, int columns);

// Returns a function that shows a line on the terminal with the number of finished parts ("brdf synth: 3 of
// 16"). The line is rewritten in place and removed after the last part. If stderr is not a terminal, the
// function does nothing.
std::function<void(int done, int total)> progress_line(std::string what);

// The same for long work with different parts: " 18 %  albedo of GGX".
std::function<void(double fraction, const std::string& what)> percent_line();

}  // namespace brdf::cli
