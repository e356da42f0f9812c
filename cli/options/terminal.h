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

// With --quiet, notes, progress and next steps are not printed; results, warnings and errors are.
bool is_quiet();
void set_quiet();

// A warning, which changes the meaning of the results: a line of text that the destructor prints on stderr.
// The text passes through io::printable(), which prevents names of files and messages of libraries from
// controlling the terminal.
class Warning : public std::ostringstream {
 public:
  Warning() = default;
  Warning(const Warning&) = delete;
  Warning& operator=(const Warning&) = delete;
  ~Warning() override;
};

// A line of information that is not a warning. Nothing is printed with --quiet.
class Note : public std::ostringstream {
 public:
  Note() = default;
  Note(const Note&) = delete;
  Note& operator=(const Note&) = delete;
  ~Note() override;
};

// The stream that text for people goes to. If a file of the verb is written to standard output, its text
// goes to standard error.
enum class TextStream { out, error };

// Text that the destructor prints, folded to the width of the terminal. Text on stderr is left out with
// --quiet.
class PlainText : public std::ostringstream {
 public:
  explicit PlainText(TextStream stream = TextStream::out) : stream_(stream) {}
  PlainText(const PlainText&) = delete;
  PlainText& operator=(const PlainText&) = delete;
  ~PlainText() override;

 private:
  TextStream stream_;
};

// Returns the file descriptor of the stream.
int descriptor_of(TextStream stream);

}  // namespace brdf::cli
