// How text for people reaches a terminal: as wide as it is, coloured where that is wanted.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

namespace brdf::cli {

// Characters in a line of the terminal, 60 to 200, also where COLUMNS says so; 0: no terminal, lines are as
// long as they are.
int columns_of(int descriptor);

// A terminal whose user has not set NO_COLOR (no-color.org), and that is not "dumb".
bool colours_on(int descriptor);

// Lines longer than `columns` (0: none is) broken at blanks. What follows stands under the last cell of the
// line that begins in its first half (cells are parted by two blanks or more), else two further in than the
// line. Escapes of colours have no width. A word longer than the line is broken after a comma, else left
// whole.
std::string folded(std::string_view text, int columns);

// A line for people: to stderr when this goes. Names of files and texts of libraries that are in it cannot
// drive the terminal (io::printable); nothing else in it may.
class Note : public std::ostringstream {
 public:
  Note() = default;
  Note(const Note&) = delete;
  Note& operator=(const Note&) = delete;
  ~Note() override;
};

// Text for people: to stdout when this goes, folded to its width.
class PlainText : public std::ostringstream {
 public:
  PlainText() = default;
  PlainText(const PlainText&) = delete;
  PlainText& operator=(const PlainText&) = delete;
  ~PlainText() override;
};

}  // namespace brdf::cli
