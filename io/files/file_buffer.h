// A stream buffer that writes to a file descriptor.
#pragma once

#include <array>
#include <streambuf>

namespace brdf::io {

// Stores the error of the first failed write; nothing is written after a failure. `by_line`: text that ends
// a line is written immediately. Does not close the descriptor.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(int descriptor, bool by_line = false);
  FileBuffer(const FileBuffer&) = delete;
  FileBuffer& operator=(const FileBuffer&) = delete;
  int error() const { return error_; }  // an errno; 0 if everything was written

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
