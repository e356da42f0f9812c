#include "io/files/content.h"

#include <sys/stat.h>
#include <unistd.h>
#include <utf8.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "io/files/error.h"
#include "io/files/inputs.h"
#include "io/files/near_name.h"
#include "io/files/standard_input.h"

namespace brdf::io {

bool is_of_the_name(int error) {
  constexpr std::array kOfTheName{EACCES, EINVAL, EISDIR,  ELOOP, ENAMETOOLONG, ENODEV,
                                  ENOENT, ENXIO,  ENOTDIR, EPERM, EROFS,        ETXTBSY};
  return std::ranges::find(kOfTheName, error) != kOfTheName.end();
}

namespace {

// A socket, which some programs connect to standard input, cannot be opened by its name.
std::FILE* opened(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "rbe");
  if (!file && errno == ENXIO && path == kStandardInput) file = ::fdopen(::dup(STDIN_FILENO), "rb");
  return file;
}

std::string named(const std::string& name) {
  return name.empty() ? "''" : name;
}

}  // namespace

void cannot_be_read(const std::string& name, int error) {
  const std::string message = named(name) + ": cannot be read: " + std::strerror(error) +
                              (error == ENOENT ? did_you_mean_file(name) : "");
  if (is_of_the_name(error)) throw InputError(message);
  throw EnvironmentError(message);
}

std::string cannot_be_used(const std::filesystem::filesystem_error& error) {
  return named(error.path1().string()) + ": cannot be used: " + error.code().message();
}

Content read_content(const std::filesystem::path& path, std::size_t limit) {
  note_input(path);
  return read_result(path, limit);
}

Content read_result(const std::filesystem::path& path, std::size_t limit) {
  Content content{input_name(path.string()), {}};
  const auto refuse = [&](const std::string& what) { throw InputError(content.name + ": " + what); };
  const std::string too_large = "is larger than " + std::to_string(limit >> 20) + " MiB";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(opened(path), &std::fclose);
  struct stat status;
  if (!file || fstat(fileno(file.get()), &status) != 0) cannot_be_read(content.name, errno);
  if (S_ISDIR(status.st_mode)) refuse("is a folder");
  // A user may type at a terminal, but /dev/zero never ends.
  if (S_ISBLK(status.st_mode) || (S_ISCHR(status.st_mode) && !isatty(fileno(file.get()))))
    refuse("is a device");
  const auto size = static_cast<std::size_t>(status.st_size);  // 0 for a pipe
  if (size > limit) refuse(too_large);
  constexpr std::size_t kBlock = 1 << 16;
  std::string& bytes = content.bytes;
  for (std::size_t end = 0;;) {
    bytes.resize(std::min(std::max({size + 1, kBlock, 2 * end}), limit + 1));
    const std::size_t got = std::fread(bytes.data() + end, 1, bytes.size() - end, file.get());
    end += got;
    if (end > limit) refuse(too_large);
    if (end < bytes.size()) {
      if (std::ferror(file.get())) cannot_be_read(content.name, errno);
      bytes.resize(end);
      return content;
    }
  }
}

bool is_json(const Content& content) {
  const std::size_t first = content.bytes.find_first_not_of(" \t\r\n\v\f");
  return first != std::string::npos && content.bytes[first] == '{';
}

std::size_t line_of(const std::string& bytes, std::size_t place) {
  return 1 + static_cast<std::size_t>(
                 std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

namespace {

constexpr std::string_view kLittleEndian = "\xFF\xFE", kBigEndian = "\xFE\xFF";

// Returns whether the first two characters are Latin letters in UTF-16 of this byte order.
bool begins_as_utf16(const std::string& bytes, bool is_big) {
  for (std::size_t k = 0; k < 4; ++k)
    if (bytes.size() < 4 || (bytes[k] == '\0') != (k % 2 == (is_big ? 0 : 1))) return false;
  return true;
}

bool is_utf16(const std::string& bytes) {
  return bytes.starts_with(kLittleEndian) || bytes.starts_with(kBigEndian) || begins_as_utf16(bytes, false) ||
         begins_as_utf16(bytes, true);
}

// Converts UTF-16 as spreadsheets write it ("Unicode text"), with or without a byte order mark. Lone
// surrogates are invalid.
std::string from_utf16(Content& text) {
  const bool is_big = text.bytes.starts_with(kBigEndian) || begins_as_utf16(text.bytes, true);
  const bool is_marked = text.bytes.starts_with(kLittleEndian) || text.bytes.starts_with(kBigEndian);
  std::u16string units;
  units.reserve(text.bytes.size() / 2);
  for (std::size_t k = is_marked ? 2 : 0; k + 1 < text.bytes.size(); k += 2) {
    const auto a = static_cast<unsigned char>(text.bytes[k]),
               b = static_cast<unsigned char>(text.bytes[k + 1]);
    units += static_cast<char16_t>(is_big ? a << 8 | b : b << 8 | a);
  }
  try {
    if (text.bytes.size() % 2 != 0) throw utf8::invalid_utf16(0);
    std::string bytes;
    utf8::utf16to8(units.begin(), units.end(), std::back_inserter(bytes));
    text.bytes = std::move(bytes);
  } catch (const utf8::exception&) {
    throw InputError(text.name + ": begins like UTF-16 text, but is not valid UTF-16");
  }
  return "the text is UTF-16";
}

}  // namespace

std::string make_utf8(Content& text) {
  const auto refuse = [&](std::size_t place, const std::string& what) {
    throw InputError(text.name + ", line " + std::to_string(line_of(text.bytes, place)) + ": " + what);
  };
  std::string note;
  if (is_utf16(text.bytes)) note = from_utf16(text);
  if (text.bytes.find('\n') == text.bytes.npos && text.bytes.find('\r') != text.bytes.npos) {
    std::ranges::replace(text.bytes, '\r', '\n');
    note += std::string(note.empty() ? "" : "; ") + "lines end with CR only";
  }
  if (const std::size_t nul = text.bytes.find('\0'); nul != std::string::npos)
    refuse(nul, "contains a NUL byte: neither text nor a supported binary format");
  const auto invalid = utf8::find_invalid(text.bytes.begin(), text.bytes.end());
  if (invalid == text.bytes.end()) return note;
  std::string transcoded;
  transcoded.reserve(text.bytes.size());
  for (std::size_t k = 0; k < text.bytes.size(); ++k) {
    const auto c = static_cast<unsigned char>(text.bytes[k]);
    if (c >= 0x80 && c < 0xa0) refuse(k, "is neither UTF-8 nor Latin-1 text (save the file as UTF-8)");
    utf8::append(c, std::back_inserter(transcoded));
  }
  const std::size_t line = line_of(text.bytes, static_cast<std::size_t>(invalid - text.bytes.begin()));
  text.bytes = std::move(transcoded);
  return "line " + std::to_string(line) + " is not UTF-8: the text is read as Latin-1";
}

}  // namespace brdf::io
