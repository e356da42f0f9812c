#include "io/exr_stream.h"

#include <Iex.h>
#include <ImfVersion.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>

#include "io/error.h"

namespace brdf::io {

namespace {

constexpr std::uint64_t kPreamble = 8;  // magic number and version

// What OpenEXR throws, and tells as a damaged file.
[[noreturn]] void ends_too_soon() {
  throw Iex::InputExc("the file ends too soon");
}

std::string word_at(Imf::IStream& stream) {
  std::string word;
  for (char c = 0; stream.read(&c, 1), c != '\0';) word += c;
  return word;
}

// Whether it ends where its attribute does: names with 16 bytes each, to an empty name. OpenEXR reads it to there, whatever the
// attribute says of its size.
bool is_list_of_channels(const std::string& bytes) {
  std::size_t at = 0;
  while (at < bytes.size() && bytes[at] != '\0') {
    const std::size_t end = bytes.find('\0', at);
    if (end == bytes.npos) return false;
    at = end + 17;
  }
  return at + 1 == bytes.size();
}

// Walks the attributes of the first header: name, type, size, value.
bool holds_its_attributes(Imf::IStream& stream, std::uint64_t bytes) try {
  stream.seekg(kPreamble);
  while (!word_at(stream).empty()) {
    const std::string type = word_at(stream);
    std::int32_t size = 0;
    stream.read(reinterpret_cast<char*>(&size), sizeof size);
    const std::uint64_t value = stream.tellg();
    if (size < 0 || std::uint64_t(size) > bytes - value) return false;
    if (type == "chlist") {
      std::string list(std::size_t(size), '\0');
      stream.read(list.data(), size);
      if (!is_list_of_channels(list)) return false;
    }
    stream.seekg(value + std::uint64_t(size));
  }
  return true;
} catch (const Iex::InputExc&) {
  return false;
}

// At the file's beginning again.
void check_header(Imf::IStream& stream, std::uint64_t bytes) {
  if (!holds_its_attributes(stream, bytes))
    throw InputError(std::string(stream.fileName()) +
                     ": is no OpenEXR picture that can be read: its header is damaged or cut off");
  stream.seekg(0);
}

}  // namespace

ExrBytes::ExrBytes(const Content& content) : IStream(content.name.c_str()), bytes_(content.bytes) {
  check_header(*this, bytes_.size());
}

bool ExrBytes::read(char to[], int count) {
  const std::uint64_t left = at_ < bytes_.size() ? bytes_.size() - at_ : 0;
  if (count < 0 || std::uint64_t(count) > left) ends_too_soon();
  std::memcpy(to, bytes_.data() + at_, std::size_t(count));
  at_ += std::uint64_t(count);
  return at_ < bytes_.size();
}

ExrFile::ExrFile(const std::filesystem::path& path) : IStream(path.c_str()), file_(nullptr, &std::fclose) {
  struct stat status;
  if (stat(path.c_str(), &status) != 0) cannot_be_read(path.string(), errno);
  if (!S_ISREG(status.st_mode))
    throw InputError(path.string() + ": is no file");  // a pipe would be waited for
  file_.reset(std::fopen(path.c_str(), "rbe"));
  if (!file_) cannot_be_read(path.string(), errno);
  size_ = std::uint64_t(status.st_size);
  check_header(*this, size_);
}

bool ExrFile::read(char to[], int count) {
  if (count < 0 || std::fread(to, 1, std::size_t(count), file_.get()) != std::size_t(count)) {
    if (std::ferror(file_.get())) cannot_be_read(fileName(), errno);
    ends_too_soon();
  }
  at_ += std::uint64_t(count);
  return at_ < size_;
}

void ExrFile::seekg(std::uint64_t place) {
  if (fseeko(file_.get(), off_t(place), SEEK_SET) != 0) ends_too_soon();
  at_ = place;
}

bool is_exr(const Content& content) {
  return content.bytes.size() >= 4 && Imf::isImfMagic(content.bytes.data());
}

}  // namespace brdf::io
