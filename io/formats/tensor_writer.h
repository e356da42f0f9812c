// Writes the container of RGL's files: named arrays one after another.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace brdf::io {

class TensorWriter {
 public:
  // Adds an array of bytes.
  void add(const std::string& name, const std::string& bytes);
  // `shape` lists the sizes from slow to fast.
  void add(const std::string& name, std::vector<std::uint64_t> shape, const std::vector<float>& values);
  // Returns the bytes of the file.
  std::string bytes() const;

 private:
  struct Field {
    std::string name;
    std::uint8_t type;
    std::vector<std::uint64_t> shape;
    std::string data;
  };
  std::vector<Field> fields_;
};

}  // namespace brdf::io
