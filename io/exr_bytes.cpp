#include "io/exr_bytes.h"

#include <Iex.h>
#include <ImfVersion.h>

#include <cstring>

namespace brdf::io {

bool ExrBytes::read(char to[], int count) {
  const std::uint64_t left = at_ < bytes_.size() ? bytes_.size() - at_ : 0;
  if (count < 0 || std::uint64_t(count) > left) throw Iex::InputExc("the file ends too soon");
  std::memcpy(to, bytes_.data() + at_, std::size_t(count));
  at_ += std::uint64_t(count);
  return at_ < bytes_.size();
}

bool is_exr(const Content& content) {
  return content.bytes.size() >= 4 && Imf::isImfMagic(content.bytes.data());
}

}  // namespace brdf::io
