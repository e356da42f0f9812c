// Packs strings and lists of strings into bytes, for a pipe between two processes of this program.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace brdf::shader {

// Appends the number of bytes and the bytes.
inline void put(std::string& out, const std::string& bytes) {
  const std::uint64_t size = bytes.size();
  out.append(reinterpret_cast<const char*>(&size), sizeof size);
  out += bytes;
}
// Appends the number of strings and each string.
inline void put(std::string& out, const std::vector<std::string>& list) {
  put(out, std::to_string(list.size()));
  for (const std::string& text : list) put(out, text);
}

// Unpacks the output of put(). whole() returns false once data is missing.
class Taken {
 public:
  explicit Taken(const std::string& bytes) : bytes_(bytes) {}
  bool whole() const { return whole_; }
  std::string text() {
    std::uint64_t size = 0;
    whole_ = whole_ && bytes_.size() - at_ >= sizeof size;
    if (whole_) std::memcpy(&size, bytes_.data() + at_, sizeof size);
    whole_ = whole_ && bytes_.size() - at_ - sizeof size >= size;
    if (!whole_) return "";
    const std::string out = bytes_.substr(at_ + sizeof size, size);
    at_ += sizeof size + size;
    return out;
  }
  std::vector<std::string> list() {
    std::vector<std::string> out;
    const std::string count = text();
    for (std::size_t k = std::strtoull(count.c_str(), nullptr, 10); k > 0 && whole_; --k)
      out.push_back(text());
    return out;
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
  bool whole_ = true;
};

}  // namespace brdf::shader
