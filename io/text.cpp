#include "io/text.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "io/error.h"

namespace brdf::io {

LineReader::LineReader(const std::filesystem::path& path)
    : path_(path.string()), file_(std::fopen(path.c_str(), "rb"), &std::fclose), buffer_(1 << 16) {
  std::error_code ignored;
  if (!file_) throw InputError(path_ + ": cannot be read: " + std::strerror(errno));
  if (std::filesystem::is_directory(path, ignored)) throw InputError(path_ + ": is a folder");
}

std::string LineReader::where() const {
  return path_ + ", line " + std::to_string(line_);
}

// Moves the unread rest to the front and reads on; grows the buffer for a line longer than it.
bool LineReader::fill() {
  if (at_end_) return false;
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
  const std::size_t got = std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, file_.get());
  if (got == 0) {
    if (std::ferror(file_.get())) throw InputError(path_ + ": cannot be read: " + std::strerror(errno));
    at_end_ = true;
  }
  end_ += got;
  return got > 0;
}

bool LineReader::next(std::string_view& line) {
  std::size_t scanned = begin_;
  for (;;) {
    const void* newline = std::memchr(buffer_.data() + scanned, '\n', end_ - scanned);
    if (newline || (at_end_ && begin_ < end_)) {
      const std::size_t stop =
          newline ? static_cast<std::size_t>(static_cast<const char*>(newline) - buffer_.data()) : end_;
      line = std::string_view(buffer_.data() + begin_, stop - begin_);
      begin_ = std::min(stop + 1, end_);
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (line_++ == 0 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
      return true;
    }
    if (at_end_) return false;
    const std::size_t seen = end_ - begin_;
    fill();
    scanned = begin_ + seen;
  }
}

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

void split(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  for (;;) {
    const std::size_t stop = line.find(separator);
    fields.push_back(trimmed(line.substr(0, stop)));
    if (stop == std::string_view::npos) return;
    line.remove_prefix(stop + 1);
  }
}

void split_blanks(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const std::size_t stop = std::min(line.find_first_of(" \t"), line.size());
    fields.push_back(line.substr(0, stop));
    line.remove_prefix(stop);
  }
}

bool parse_number(std::string_view text, double& value) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return false;
  }
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

void append_number(std::string& out, double value) {
  char digits[32];
  const auto result = std::to_chars(digits, digits + sizeof digits, value);
  out.append(digits, result.ptr);
}

std::string to_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

}  // namespace brdf::io
