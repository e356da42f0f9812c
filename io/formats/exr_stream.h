// Input streams for OpenEXR. They distinguish read errors of the machine from damaged pictures, and refuse
// a header that claims more data than the file has before OpenEXR allocates the memory.
#pragma once

#include <ImfIO.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "io/files/content.h"

namespace brdf::io {

// A stream over bytes that are already in memory. `content` must outlive the stream. The constructor throws
// InputError if the header is damaged.
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

// A stream that reads a file piece by piece. The constructor throws InputError if the path is not a file
// that can be opened, or if the header is damaged. The constructor and read() throw EnvironmentError if the
// machine fails to read.
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

// Returns whether the content begins with the magic number of OpenEXR.
bool is_exr(const Content& content);

}  // namespace brdf::io
