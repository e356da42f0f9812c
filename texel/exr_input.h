// An OpenEXR image that is read a band of rows at a time.
#pragma once

#include <ImfInputFile.h>

#include <filesystem>
#include <string>
#include <vector>

#include "io/formats/exr_stream.h"
#include "texel/planes.h"

namespace brdf::texel {

class ExrInput {
 public:
  // Throws InputError where there is no such image, EnvironmentError where the machine fails.
  explicit ExrInput(const std::filesystem::path& path);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  const std::vector<std::string>& channels() const {
    return channels_;
  }  // in OpenEXR's order, the alphabet's

  // These rows of one channel, whole lines, as float. Throws InputError where the file is damaged.
  void read_rows(const std::vector<std::string>& channels, std::size_t first, std::size_t rows,
                 std::vector<std::vector<float>>& out);
  std::vector<std::pair<std::string, std::string>> attributes() const;

 private:
  std::filesystem::path path_;
  io::ExrFile bytes_;
  Imf::InputFile file_;
  std::size_t width_ = 0, height_ = 0;
  int left_ = 0, top_ = 0;
  std::vector<std::string> channels_;
};

}  // namespace brdf::texel
