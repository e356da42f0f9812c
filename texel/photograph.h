// Reads one image of a stack, OpenEXR or PNG, in bands of rows.
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
  // `transfer` applies to PNG images. Throws InputError if there is no such image or it cannot be read, and
  // if a PNG image has no transfer.
  Photograph(const std::filesystem::path& path, const std::optional<Transfer>& transfer);

  std::size_t width() const { return exr_ ? exr_->width() : width_; }
  std::size_t height() const { return exr_ ? exr_->height() : height_; }
  const std::vector<std::string>& channels() const { return exr_ ? exr_->channels() : channels_; }

  // Reads these rows of each named channel, as whole lines. The largest number of a PNG is saturated and
  // becomes NaN. Throws InputError if the file is damaged.
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
