// Reads and writes the container of RGL's files: named arrays one after another in one file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/content.h"

namespace brdf::io {

// The fields of a container.
class TensorFile {
 public:
  // `content` must outlive this object. Throws InputError if an array reaches beyond the end of the file.
  explicit TensorFile(const Content& content);
  explicit TensorFile(Content&&) = delete;

  bool has(const std::string& name) const { return find(name) != nullptr; }
  // Returns the sizes of a field from slow to fast. Throws InputError if the field is missing.
  const std::vector<std::size_t>& shape(const std::string& name) const;
  std::vector<float> floats(const std::string& name) const;  // refuses values that are not finite
  std::string bytes(const std::string& name) const;

 private:
  struct Field {
    std::string name;
    std::uint8_t type;
    std::uint64_t offset;
    std::vector<std::size_t> shape;
    std::size_t count;
  };
  Field read_field(std::size_t& at) const;
  template <class T>
  T read_value(std::size_t& at) const;
  std::string_view read_bytes(std::size_t& at, std::size_t count) const;
  const Field* find(const std::string& name) const;
  const Field& require(const std::string& name, std::uint8_t type, const char* what) const;
  [[noreturn]] void fail(const std::string& what) const;

  const Content& content_;
  std::vector<Field> fields_;
};

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
