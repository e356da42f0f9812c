#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

// Reads a text file line by line through a fixed buffer, so that a file's size does not matter.
// Accepts LF and CRLF, and a byte order mark. Throws InputError where the file cannot be opened or read.
class LineReader {
 public:
  explicit LineReader(const std::filesystem::path& path);
  // The view is valid until the next call.
  bool next(std::string_view& line);
  std::size_t line() const { return line_; }  // of the last line returned, from 1
  // "FILE, line N"
  std::string where() const;

 private:
  bool fill();

  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0, line_ = 0;
  bool at_end_ = false;
};

std::string_view trimmed(std::string_view text);

// Splits at `separator`; fields are trimmed, empty ones kept.
void split(std::string_view line, char separator, std::vector<std::string_view>& fields);
// Splits at runs of blanks and tabs.
void split_blanks(std::string_view line, std::vector<std::string_view>& fields);

// The whole of `text` as a number (a leading plus sign is
// allowed). False where it is none or out of double's range.
bool parse_number(std::string_view text, double& value);

// Shortest decimal that reads back to the same double.
void append_number(std::string& out, double value);
std::string to_text(double value);

}  // namespace brdf::io
