// OpenEXR reads through these: what the machine fails to read is told apart from what is no picture, and a
// header that says to be longer than the file is refused before OpenEXR takes that much memory.
#pragma once

#include <ImfIO.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "io/files/content.h"

namespace brdf::io {

// What was read at once. The content must live longer. Throws InputError where the header is damaged.
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

// A file that is read piece by piece. Throws InputError where it is no file that can be opened or the header
// is damaged, then and when it is read EnvironmentError where the machine fails.
class ExrFile : public Imf::IStream {
 public:
  explicit ExrFile(const std::filesystem::path& path);
  bool read(char to[], int count) override;
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t place) override;

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::uint64_t size_ = 0, at_ = 0;
};

bool is_exr(const Content& content);

}  // namespace brdf::io
