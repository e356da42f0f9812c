// Progress of long work, shown on a terminal.
#pragma once

#include <functional>
#include <string>

namespace brdf::cli {

// Returns true if stderr is a terminal and --quiet is not given; otherwise no progress is shown.
bool shows_progress();

// Erases the line of progress, if one is shown. Call this function before text is printed on the terminal.
void erase_progress();

// Returns the text of a progress line after `seconds`. From two seconds on, the text has a bar and the
// remaining time, extrapolated from the completed fraction. The text has at most `columns` characters.
std::string progress_text(const std::string& what, double fraction, double seconds, int columns);

// Returns a function that shows a line on the terminal with the number of finished parts ("brdf synth: 3 of
// 16"). The line is rewritten in place. It is erased after the last part, and with the last copy of the
// function. The function does nothing unless shows_progress().
std::function<void(int done, int total)> progress_line(std::string what);

// Does the same for long work with different parts: " 18 %  albedo of GGX".
std::function<void(double fraction, const std::string& what)> percent_line();

// Does the same for work with an unknown number of parts: "brdf fit: lambert".
std::function<void(const std::string& what)> step_line(std::string before);

}  // namespace brdf::cli
