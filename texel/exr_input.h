// Reads an OpenEXR image in bands of rows.
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
  // Throws InputError if there is no such image, EnvironmentError if the machine fails.
  explicit ExrInput(const std::filesystem::path& path);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  const std::vector<std::string>& channels() const { return channels_; }  // in OpenEXR's alphabetical order

  // Reads these rows of the named channels, as whole lines of floats. Throws InputError if the file is
  // damaged.
  void read_rows(const std::vector<std::string>& channels, std::size_t first, std::size_t rows,
                 std::vector<std::vector<float>>& out);
  // Returns the names and values of the string attributes.
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
