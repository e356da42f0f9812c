// Text for terminals: folded to the width of the terminal, and coloured on request.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

namespace brdf::cli {

// Returns the number of characters in a line of the terminal, clamped to 60 to 200. The environment variable
// COLUMNS overrides the size of the terminal. Returns 0 if neither is available; lines are then not folded.
int columns_of(int descriptor);

// Returns true for a terminal that is not "dumb" and if NO_COLOR is not set (no-color.org).
bool colours_on(int descriptor);

// Breaks lines longer than `columns` at blanks; 0 disables folding. Continuation lines are indented to the
// last cell that begins in the first half of the line (cells are separated by two blanks or more), otherwise
// by two more than the line itself. Escape sequences of colours have no width. A word longer than the line
// is broken after a comma, or left whole if it has no comma.
std::string folded(std::string_view text, int columns);

// A line of text that the destructor prints on stderr. The text passes through io::printable(), which
// prevents names of files and messages of libraries from controlling the terminal.
class Note : public std::ostringstream {
 public:
  Note() = default;
  Note(const Note&) = delete;
  Note& operator=(const Note&) = delete;
  ~Note() override;
};

// Text that the destructor prints on stdout, folded to the width of the terminal.
class PlainText : public std::ostringstream {
 public:
  PlainText() = default;
  PlainText(const PlainText&) = delete;
  PlainText& operator=(const PlainText&) = delete;
  ~PlainText() override;
};

}  // namespace brdf::cli
