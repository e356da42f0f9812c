// OpenEXR out of what a file holds, read at once: what the machine fails to read is told apart from what is no picture.
#pragma once

#include <ImfIO.h>

#include <cstdint>

#include "io/content.h"

namespace brdf::io {

// For OpenEXR, which names the file in what it says. The content must live longer. Throws InputError where an attribute says
// to be longer than the file: OpenEXR takes that much memory before it looks.
class ExrBytes : public Imf::IStream {
 public:
  explicit ExrBytes(const Content& content);
  bool read(char to[], int count) override;
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t place) override { at_ = place; }

 private:
  const std::string& bytes_;
  std::uint64_t at_ = 0;
};

bool is_exr(const Content& content);

}  // namespace brdf::io
