#include "io/formats/exr_stream.h"

#include <Iex.h>
#include <ImfVersion.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <optional>

#include "io/files/error.h"
#include "io/files/inputs.h"

namespace brdf::io {

namespace {

// Throws the exception that OpenEXR uses for a damaged file.
[[noreturn]] void ends_too_soon() {
  throw Iex::InputExc("the file is truncated");
}

std::string word_at(Imf::IStream& stream) {
  std::string word;
  for (char c = 0; stream.read(&c, 1), c != '\0';) word += c;
  return word;
}

// Returns whether a list of channels ends at the end of its attribute. The list consists of names, each
// followed by 16 bytes, and ends with an empty name. OpenEXR reads up to the empty name and ignores the
// size of the attribute.
bool is_list_of_channels(const std::string& bytes) {
  std::size_t at = 0;
  while (at < bytes.size() && bytes[at] != '\0') {
    const std::size_t end = bytes.find('\0', at);
    if (end == bytes.npos) return false;
    at = end + 17;
  }
  return at + 1 == bytes.size();
}

template <class T>
T number_at(const std::string& value, std::size_t place) {
  T number = 0;
  if (value.size() < (place + 1) * sizeof number) ends_too_soon();
  std::memcpy(&number, value.data() + place * sizeof number, sizeof number);
  return number;
}

// Checks the extent of a window or a tile, because OpenEXR allocates the memory that the header requests.
void check_extent(const std::string& file, std::int64_t width, std::int64_t height) {
  constexpr std::int64_t kMost = kMostPixels, kWidest = kWidestPicture;
  if (width > kWidest || (width > 0 && height > kMost / width))
    throw InputError(file + ": " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels; at most " + std::to_string(kMost) + " in lines of at most " +
                     std::to_string(kWidest) + " are read");
}

bool is_sound(const std::string& file, const std::string& name, const std::string& type,
              const std::string& value) {
  if (type == "chlist") return is_list_of_channels(value);
  const auto corner = [&](std::size_t k) { return std::int64_t(number_at<std::int32_t>(value, k)); };
  const auto side = [&](std::size_t k) { return std::int64_t(number_at<std::uint32_t>(value, k)); };
  if (name == "dataWindow") check_extent(file, corner(2) - corner(0) + 1, corner(3) - corner(1) + 1);
  if (type == "tiledesc") check_extent(file, side(0), side(1));
  return true;
}

// Walks the attributes of a header: name, type, size, value. Returns their number, or std::nullopt if one
// is damaged.
std::optional<std::size_t> count_attributes(Imf::IStream& stream, std::uint64_t bytes) {
  constexpr std::int32_t kLongest = 1 << 20;  // bytes; longer values are skipped, except lists of channels
  std::size_t count = 0;
  for (std::string name; !(name = word_at(stream)).empty(); ++count) {
    const std::string type = word_at(stream);
    std::int32_t size = 0;
    stream.read(reinterpret_cast<char*>(&size), sizeof size);
    const std::uint64_t begin = stream.tellg();
    if (size < 0 || std::uint64_t(size) > bytes - begin) return std::nullopt;
    if (size <= kLongest || type == "chlist") {
      std::string value(std::size_t(size), '\0');
      stream.read(value.data(), size);
      if (!is_sound(stream.fileName(), name, type, value)) return std::nullopt;
    }
    stream.seekg(begin + std::uint64_t(size));
  }
  return count;
}

// Checks all headers. A file of several parts has its headers one after another, up to an empty one.
bool has_sound_headers(Imf::IStream& stream, std::uint64_t bytes) try {
  int preamble[2] = {};  // magic number and version
  stream.seekg(0);
  stream.read(reinterpret_cast<char*>(preamble), sizeof preamble);
  std::optional<std::size_t> count = count_attributes(stream, bytes);
  while (count && *count > 0 && Imf::isMultiPart(preamble[1])) count = count_attributes(stream, bytes);
  return count.has_value();
} catch (const Iex::InputExc&) {
  return false;
}

// Checks the headers, then rewinds the stream to the beginning of the file.
void check_header(Imf::IStream& stream, std::uint64_t bytes) {
  if (!has_sound_headers(stream, bytes))
    throw InputError(std::string(stream.fileName()) +
                     ": is not a readable OpenEXR picture: the header is damaged or truncated");
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
    throw InputError(path.string() + ": is not a regular file");  // reading a pipe would block
  file_.reset(std::fopen(path.c_str(), "rbe"));
  if (!file_) cannot_be_read(path.string(), errno);
  note_input(path);
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
