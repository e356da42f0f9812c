// Tensor files in memory for tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace brdf {

// Builds a tensor file in memory: the smallest file that can be read, with fields that a test may change.
struct TensorBytes {
  struct Field {
    std::string name;
    std::uint8_t type;
    std::vector<std::uint64_t> shape;
    std::string data;
  };
  std::vector<Field> fields = {
      {"description", 1, {4}, "test"},
      {"phi_i", 10, {1}, floats({0})},
      {"theta_i", 10, {2}, floats({0.1f, 1.2f})},
      {"ndf", 10, {2, 2}, floats({1, 2, 3, 4})},
      {"sigma", 10, {2, 2}, floats({1, 1, 1, 1})},
      {"vndf", 10, {1, 2, 2, 2}, floats({1, 2, 3, 4, 4, 3, 2, 1})},
      {"rgb", 10, {1, 2, 3, 2, 2}, floats(std::vector<float>(24, 0.5f))},
  };

  static std::string floats(const std::vector<float>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
  }
  Field& field(const std::string& name) {
    for (Field& f : fields)
      if (f.name == name) return f;
    return fields.emplace_back();
  }
  std::string bytes() const {
    std::size_t end = 18;
    for (const Field& f : fields) end += 2 + f.name.size() + 2 + 1 + 8 + 8 * f.shape.size();
    std::string table("tensor_file\0\1\0", 14), data;
    append(table, static_cast<std::uint32_t>(fields.size()));
    for (const Field& f : fields) {
      append(table, static_cast<std::uint16_t>(f.name.size()));
      table += f.name;
      append(table, static_cast<std::uint16_t>(f.shape.size()));
      append(table, f.type);
      append(table, static_cast<std::uint64_t>(end + data.size()));
      for (const std::uint64_t size : f.shape) append(table, size);
      data += f.data;
    }
    return table + data;
  }

 private:
  template <class T>
  static void append(std::string& out, T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    out.append(raw, sizeof value);
  }
};

}  // namespace brdf
