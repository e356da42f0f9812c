#include "io/files/file_buffer.h"

#include <unistd.h>

#include <cerrno>
#include <string_view>

namespace brdf::io {

FileBuffer::FileBuffer(int descriptor, bool by_line) : descriptor_(descriptor), by_line_(by_line) {
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

int FileBuffer::sync() {
  for (const char* at = pbase(); error_ == 0 && at < pptr();) {
    const ssize_t written = ::write(descriptor_, at, std::size_t(pptr() - at));
    if (written >= 0)
      at += written;
    else if (errno != EINTR)
      error_ = errno;
  }
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return error_ == 0 ? 0 : -1;
}

FileBuffer::int_type FileBuffer::overflow(int_type c) {
  if (sync() != 0) return traits_type::eof();
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  sputc(traits_type::to_char_type(c));
  if (by_line_ && c == '\n' && sync() != 0) return traits_type::eof();
  return c;
}

std::streamsize FileBuffer::xsputn(const char* text, std::streamsize size) {
  if (error_ != 0) return 0;
  const std::streamsize taken = std::streambuf::xsputn(text, size);
  const bool ends_line = std::string_view(text, std::size_t(taken)).find('\n') != std::string_view::npos;
  if (by_line_ && ends_line && sync() != 0) return 0;
  return taken;
}

}  // namespace brdf::io
