#include "cli/options/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iostream>

#include "cli/options/progress.h"
#include "io/files/text.h"

namespace brdf::cli {
namespace {

constexpr int kFewest = 60, kMost = 200;

bool quiet = false;

// Returns the length of the escape sequence at the beginning of the text, or 0 if there is no escape
// sequence.
std::size_t escape_length(std::string_view text) {
  if (!text.starts_with("\x1b[")) return 0;
  const std::size_t end = text.find_first_not_of("0123456789;", 2);
  return end == text.npos ? text.size() : end + 1;
}

// Returns the number of bytes of the longest prefix that takes at most `columns`. A UTF-8 character takes
// one column.
std::size_t fitting(std::string_view text, int columns) {
  std::size_t at = 0;
  while (at < text.size()) {
    if (const std::size_t escape = escape_length(text.substr(at))) {
      at += escape;
      continue;
    }
    if (columns-- == 0) break;
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
  }
  return at;
}

// Returns the column at which continuation lines begin.
std::size_t hanging_indent(std::string_view line, int columns) {
  const std::size_t own = std::min(line.find_first_not_of(' '), line.size());
  std::size_t indent = own + 2, width = 0;
  for (std::size_t at = 0, blanks = 0; at < line.size() && width <= std::size_t(columns) / 2; ++at) {
    if (const std::size_t escape = escape_length(line.substr(at))) {
      at += escape - 1;
      continue;
    }
    if (at > own && line[at] != ' ' && blanks > 1) indent = width;
    blanks = line[at] == ' ' ? blanks + 1 : 0;
    ++width;
  }
  return indent <= std::size_t(columns) / 2 ? indent : own + 2;
}

void append_folded(std::string& out, std::string_view line, int columns) {
  const std::string margin(hanging_indent(line, columns), ' ');
  for (bool first = true;; first = false) {
    const int room = first ? columns : columns - int(margin.size());
    std::size_t end = fitting(line, room);
    if (end < line.size() && line[end] != ' ') {
      std::size_t blank = line.rfind(' ', end);
      if (blank == line.npos || line.find_first_not_of(' ') > blank) {  // a single word
        const std::size_t comma = line.rfind(',', end - 1);
        blank = comma != line.npos ? comma + 1 : line.find(' ', line.find_first_not_of(' '));
      }
      end = std::min(blank, line.size());
    }
    std::string_view part = line.substr(0, end);
    while (part.ends_with(' ')) part.remove_suffix(1);
    if (!first) out += margin;
    out += part;
    line.remove_prefix(end);
    if (const std::size_t rest = line.find_first_not_of(' '); rest != line.npos)
      line.remove_prefix(rest);
    else
      return;
    out += '\n';
  }
}

}  // namespace

int columns_of(int descriptor) {
  int columns = 0;
  if (const char* text = std::getenv("COLUMNS"); text && *text) {
    const std::string_view digits(text);
    std::from_chars(digits.data(), digits.data() + digits.size(), columns);
  }
  winsize size{};
  if (columns <= 0 && isatty(descriptor) != 0 && ioctl(descriptor, TIOCGWINSZ, &size) == 0)
    columns = size.ws_col;
  return columns <= 0 ? 0 : std::clamp(columns, kFewest, kMost);
}

bool colours_on(int descriptor) {
  const char *refused = std::getenv("NO_COLOR"), *terminal = std::getenv("TERM");
  return isatty(descriptor) != 0 && !(refused && *refused) &&
         !(terminal && std::string_view(terminal) == "dumb");
}

std::string folded(std::string_view text, int columns) {
  if (columns == 0) return std::string(text);
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    append_folded(out, text.substr(0, end), columns);
    if (end < text.size()) out += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

bool is_quiet() {
  return quiet;
}

void set_quiet() {
  quiet = true;
}

namespace {

// Called in destructors, which must not throw.
void print_line(std::string_view text) {
  try {
    erase_progress();
    std::cerr << io::printable(text) << '\n';
  } catch (const std::bad_alloc&) {
    std::cerr << "brdf: a message is lost, because there is no memory for it\n";
  }
}

}  // namespace

Warning::~Warning() {
  print_line(view());
}

Note::~Note() {
  if (!is_quiet()) print_line(view());
}

int descriptor_of(TextStream stream) {
  return stream == TextStream::out ? STDOUT_FILENO : STDERR_FILENO;
}

PlainText::~PlainText() {
  if (stream_ == TextStream::error && is_quiet()) return;
  erase_progress();
  (stream_ == TextStream::out ? std::cout : std::cerr) << folded(str(), columns_of(descriptor_of(stream_)));
}

}  // namespace brdf::cli
