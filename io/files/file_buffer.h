// A stream's buffer over a file descriptor.
#pragma once

#include <array>
#include <streambuf>

namespace brdf::io {

// Remembers why the first failed write failed; after it nothing more is written. `by_line`: what ends a line
// is written at once. Does not close the descriptor.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(int descriptor, bool by_line = false);
  FileBuffer(const FileBuffer&) = delete;
  FileBuffer& operator=(const FileBuffer&) = delete;
  int error() const { return error_; }  // an errno; 0 where all was written

 protected:
  int_type overflow(int_type c) override;
  int sync() override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;

 private:
  int descriptor_, error_ = 0;
  bool by_line_;
  std::array<char, 1 << 16> buffer_;
};

}  // namespace brdf::io
