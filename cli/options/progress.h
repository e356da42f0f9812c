#pragma once

#include <functional>
#include <string>

namespace brdf::cli {

// Whether somebody watches stderr: progress is for a terminal only.
bool shows_progress();

// What a line of progress says after so many seconds: from two on with a bar and the time that is left, as if
// the rest went as the part before. At most `columns` characters.
std::string progress_text(const std::string& what, double fraction, double seconds, int columns);

// A line on a terminal that counts finished parts ("brdf synth: 3 of 16"), rewritten in place and removed
// after the last; nothing where stderr is no terminal.
std::function<void(int done, int total)> progress_line(std::string what);

// The same for long work of parts that differ: " 18 %  albedo of GGX"; nothing where stderr is no terminal.
std::function<void(double fraction, const std::string& what)> percent_line();

}  // namespace brdf::cli
