#include "texel/photograph.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/png.h"

namespace brdf::texel {
namespace {

constexpr const char* kPng = ".png";
constexpr int kLargest = 65535;

}  // namespace

Photograph::Photograph(const std::filesystem::path& path, const std::optional<Transfer>& transfer) {
  if (path.extension() == kPng)
    decode(path, transfer);
  else
    exr_.emplace(path);
}

void Photograph::decode(const std::filesystem::path& path, const std::optional<Transfer>& transfer) {
  if (!std::filesystem::is_regular_file(path)) throw InputError(path.string() + ": no such file");
  const std::string bytes = io::read_content(path).bytes;
  int width = 0, height = 0, in_file = 0;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto refuse = [&](const char* reason) {
    throw InputError(path.string() + ": is not a readable PNG image: " + reason);
  };
  if (bytes.size() > std::size_t(std::numeric_limits<int>::max())) refuse("too long");
  if (!stbi_info_from_memory(data, int(bytes.size()), &width, &height, &in_file))
    refuse(stbi_failure_reason());
  if (std::size_t(height) > io::kMostPixels / std::size_t(width)) refuse("too many pixels");
  if (!io::is_whole_png(bytes)) refuse("the file is truncated");
  if (!transfer)
    throw InputError(path.string() +
                     ": the transfer function of the image is not known: give `# transfer: linear`, `srgb` "
                     "or a power in lights.csv");
  const int channels = in_file >= 3 ? 3 : 1;
  const std::unique_ptr<stbi_us, void (*)(void*)> pixels(
      stbi_load_16_from_memory(data, int(bytes.size()), &width, &height, &in_file, channels),
      stbi_image_free);
  if (!pixels) refuse(stbi_failure_reason());
  width_ = std::size_t(width);
  height_ = std::size_t(height);
  channels_ = channels == 3 ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
  std::vector<float> meaning(kLargest + 1, std::numeric_limits<float>::quiet_NaN());
  for (int k = 0; k < kLargest; ++k) meaning[std::size_t(k)] = float(transfer->decoded(k / double(kLargest)));
  values_.assign(std::size_t(channels), std::vector<float>(width_ * height_));
  for (std::size_t k = 0; k < width_ * height_; ++k)
    for (std::size_t c = 0; c < values_.size(); ++c)
      values_[c][k] = meaning[pixels.get()[k * values_.size() + c]];
}

void Photograph::read_rows(const std::vector<std::string>& channels, std::size_t first, std::size_t rows,
                           std::vector<std::vector<float>>& out) {
  if (exr_) return exr_->read_rows(channels, first, rows, out);
  out.resize(channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto& values = values_[std::size_t(std::ranges::find(channels_, channels[c]) - channels_.begin())];
    out[c].assign(values.begin() + std::ptrdiff_t(first * width_),
                  values.begin() + std::ptrdiff_t((first + rows) * width_));
  }
}

}  // namespace brdf::texel
