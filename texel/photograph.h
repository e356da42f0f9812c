// One image of a stack, OpenEXR or PNG, a band of rows at a time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "texel/exr_input.h"
#include "texel/transfer.h"

namespace brdf::texel {

class Photograph {
 public:
  // Throws InputError where there is no such image. `transfer` of a PNG.
  Photograph(const std::filesystem::path& path, const std::optional<Transfer>& transfer);

  std::size_t width() const { return exr_ ? exr_->width() : width_; }
  std::size_t height() const { return exr_ ? exr_->height() : height_; }
  const std::vector<std::string>& channels() const { return exr_ ? exr_->channels() : channels_; }

  // Of each channel that is named these rows, whole lines. A number that is the largest of a PNG is
  // saturated: NaN. Throws InputError where the file is damaged.
  void read_rows(const std::vector<std::string>& channels, std::size_t first, std::size_t rows,
                 std::vector<std::vector<float>>& out);

 private:
  void decode(const std::filesystem::path& path, const std::optional<Transfer>& transfer);

  std::optional<ExrInput> exr_;
  std::size_t width_ = 0, height_ = 0;
  std::vector<std::string> channels_;       // of a PNG: R, G and B, or Y
  std::vector<std::vector<float>> values_;  // [channel][pixel]
};

}  // namespace brdf::texel
