#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace brdf::io {

// The container of RGL's files: named arrays in one file, each read when asked for.
class TensorFile {
 public:
  explicit TensorFile(const std::filesystem::path& path);

  bool has(const std::string& name) const { return find(name) != nullptr; }
  // Sizes from slow to fast; throws InputError where the field is missing.
  const std::vector<std::size_t>& shape(const std::string& name) const;
  std::vector<float> floats(const std::string& name);
  std::string bytes(const std::string& name);

 private:
  struct Field {
    std::string name;
    std::uint8_t type;
    std::uint64_t offset;
    std::vector<std::size_t> shape;
    std::size_t count;
  };
  const Field* find(const std::string& name) const;
  const Field& require(const std::string& name) const;
  void read_at(std::uint64_t offset, void* into, std::size_t bytes);
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  std::ifstream in_;
  std::uint64_t size_ = 0;
  std::vector<Field> fields_;
};

}  // namespace brdf::io
