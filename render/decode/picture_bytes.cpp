#include "render/decode/picture_bytes.h"

#include <stb_image.h>

#include <algorithm>
#include <cstring>

#include "io/files/error.h"
#include "io/files/png.h"

namespace brdf::render {
namespace {

// The source from which stb reads. If stb needs more bytes than exist, it continues with zeros or with the
// former content of its memory; the source records this.
class Source {
 public:
  explicit Source(const std::string& bytes) : bytes_(bytes) {}
  bool ran_out() const { return ran_out_; }

  int read(char* to, int count) {
    if (!ahead_) ahead_ = to;
    const std::size_t got = std::min(std::size_t(count), bytes_.size() - at_);
    std::memcpy(to, bytes_.data() + at_, got);
    at_ += got;
    // stb reads ahead into its own buffer, which is the first buffer that it fills; such a read may get
    // fewer bytes than requested.
    if (got == 0 || (to != ahead_ && got < std::size_t(count))) ran_out_ = true;
    return int(got);
  }
  void skip(int count) {
    const auto forward = std::size_t(std::max(count, 0));
    at_ = forward < bytes_.size() - at_ ? at_ + forward : bytes_.size();
  }
  bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
  const char* ahead_ = nullptr;
  bool ran_out_ = false;
};

constexpr stbi_io_callbacks kCalls{
    [](void* source, char* to, int count) { return static_cast<Source*>(source)->read(to, count); },
    [](void* source, int count) { static_cast<Source*>(source)->skip(count); },
    [](void* source) { return static_cast<Source*>(source)->is_at_end() ? 1 : 0; }};

template <class Value, class Load>
Pixels<Value> decoded(const io::Content& content, int channels, const std::string& fault, Load load) {
  Source source(content.bytes);
  PictureSize size;
  int in_file = 0;
  const auto refuse = [&](const char* reason) {
    throw InputError(content.name + ": " + fault + " (" + reason + ")");
  };
  if (io::is_png(content.bytes) && !io::is_whole_png(content.bytes)) refuse("the file is truncated");
  Pixels<Value> pixels{
      {}, {load(&kCalls, &source, &size.width, &size.height, &in_file, channels), stbi_image_free}};
  if (!pixels.values) refuse(stbi_failure_reason());
  if (source.ran_out()) refuse("the file is truncated");
  pixels.size = size;
  return pixels;
}

}  // namespace

std::optional<PictureSize> picture_size(const io::Content& content) {
  Source source(content.bytes);
  PictureSize size;
  int channels = 0;
  if (!stbi_info_from_callbacks(&kCalls, &source, &size.width, &size.height, &channels)) return std::nullopt;
  return size;
}

bool is_radiance(const io::Content& content) {
  Source source(content.bytes);
  return stbi_is_hdr_from_callbacks(&kCalls, &source) != 0;
}

Pixels<unsigned char> decoded_bytes(const io::Content& content, int channels, const std::string& fault) {
  return decoded<unsigned char>(content, channels, fault, stbi_load_from_callbacks);
}

Pixels<float> decoded_radiance(const io::Content& content, int channels, const std::string& fault) {
  return decoded<float>(content, channels, fault, stbi_loadf_from_callbacks);
}

}  // namespace brdf::render
