// Parts of the reader of Speos' text formats, `.brdf` and `.anisotropicbsdf`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/files/content.h"

namespace brdf::io::speos {

// Reads words and numbers of a text, and counts lines for messages. The content must outlive the object.
class Cursor {
 public:
  explicit Cursor(const Content& content) : content_(&content) {}
  explicit Cursor(Content&&) = delete;

  // Returns the rest of the current line without its end, and moves to the next line.
  std::string_view line();
  // Reads the next word. Returns an empty word at the end of the text.
  std::string_view word();
  // Reads a finite number. Throws InputError with the line; `name` describes the number.
  double number(const std::string& name);
  // Reads a whole number from `least` to `most`.
  std::size_t count(const std::string& name, std::size_t least, std::size_t most);
  // Reads `count` numbers. Memory grows with the text, not with `count`.
  std::vector<double> numbers(const std::string& name, std::size_t count);
  // Skips a description of this number of characters, which may contain line breaks. A line break and a
  // character of several bytes count once; if no line ends there, line breaks in CRLF count twice. Returns
  // false if no line ends there either.
  bool skip_description(std::size_t characters);
  // Skips the rest of the current line, which must be blank.
  void end_line();
  [[noreturn]] void fail(const std::string& what) const;
  // The place in the text, to which back() returns.
  std::size_t place() const { return at_; }
  void back(std::size_t place) { at_ = place; }

 private:
  std::string_view text() const { return content_->bytes; }

  const Content* content_;
  std::size_t at_ = 0;
};

// One table of a block: values of azimuths (columns) for polar angles (rows).
struct Block {
  std::vector<double> theta, phi;  // degrees, ascending
  std::vector<double> values;      // [theta][phi], row by row

  double at(std::size_t t, std::size_t p) const { return values[t * phi.size() + p]; }
  // Returns the integral of the values times the cosine over the hemisphere. The table is interpolated
  // linearly. `is_intensity`: the values contain the cosine. Azimuths from 0 to 180 degrees represent
  // both halves; other gaps are closed.
  double reflectance(bool is_intensity) const;
};

// Reads the numbers of angles, the azimuths and the rows of a table.
Block read_block(Cursor& cursor);

}  // namespace brdf::io::speos
