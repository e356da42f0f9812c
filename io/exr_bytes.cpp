#include "io/exr_bytes.h"

#include <Iex.h>
#include <ImfVersion.h>

#include <cstring>

#include "io/error.h"

namespace brdf::io {

namespace {

constexpr std::size_t kPreamble = 8;  // magic number and version

// Bytes of the list of channels that begins here: names with 16 bytes each, to an empty name. OpenEXR reads it to there, whatever
// the attribute says of its size.
std::size_t length_of_channels(const std::string& bytes, std::size_t first) {
  std::size_t at = first;
  while (at < bytes.size() && bytes[at] != '\0') {
    const std::size_t end = bytes.find('\0', at);
    if (end == bytes.npos) return bytes.size() - first;
    at = end + 17;
  }
  return at + 1 - first;
}

// Walks the attributes of the first header: name, type, size, value.
bool holds_its_attributes(const std::string& bytes) {
  std::size_t at = kPreamble;
  while (at < bytes.size() && bytes[at] != '\0') {
    std::string type;
    for (int word = 0; word < 2; ++word) {
      const std::size_t end = bytes.find('\0', at);
      if (end == bytes.npos) return false;
      type = bytes.substr(at, end - at);
      at = end + 1;
    }
    std::int32_t size = 0;
    if (bytes.size() - at < sizeof size) return false;
    std::memcpy(&size, bytes.data() + at, sizeof size);
    at += sizeof size;
    if (size < 0 || static_cast<std::size_t>(size) > bytes.size() - at) return false;
    if (type == "chlist" && length_of_channels(bytes, at) != static_cast<std::size_t>(size)) return false;
    at += static_cast<std::size_t>(size);
  }
  return true;
}

}  // namespace

ExrBytes::ExrBytes(const Content& content) : IStream(content.name.c_str()), bytes_(content.bytes) {
  if (!holds_its_attributes(bytes_))
    throw InputError(content.name +
                     ": is no OpenEXR picture that can be read: its header is damaged or cut off");
}

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
