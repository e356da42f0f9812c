#include "io/tensor_file.h"

#include <algorithm>

#include "io/error.h"

namespace brdf::io {
namespace {

constexpr std::string_view kMagic("tensor_file\0\1\0", 14);  // name and version 1.0
constexpr std::uint8_t kUint8 = 1, kFloat32 = 10;

template <class T>
T read_value(std::ifstream& in) {
  T value{};
  in.read(reinterpret_cast<char*>(&value), sizeof value);
  return value;
}

}  // namespace

TensorFile::TensorFile(const std::filesystem::path& path)
    : path_(path.string()), in_(path, std::ios::binary) {
  std::error_code error;
  size_ = std::filesystem::file_size(path, error);
  if (!in_ || error) throw InputError(path_ + ": cannot be read");
  std::string magic(kMagic.size(), '\0');
  in_.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  if (magic != kMagic) fail("not a tensor file of version 1.0");
  const auto count = read_value<std::uint32_t>(in_);
  for (std::uint32_t k = 0; k < count && in_; ++k) {
    Field field;
    field.name.resize(read_value<std::uint16_t>(in_));
    in_.read(field.name.data(), static_cast<std::streamsize>(field.name.size()));
    field.shape.resize(read_value<std::uint16_t>(in_));
    field.type = read_value<std::uint8_t>(in_);
    field.offset = read_value<std::uint64_t>(in_);
    field.count = 1;
    for (std::size_t& size : field.shape) {
      size = read_value<std::uint64_t>(in_);
      if (size > size_ || field.count * size > size_)
        fail("field \"" + field.name + "\" is larger than the file");
      field.count *= size;
    }
    if (field.offset > size_) fail("field \"" + field.name + "\" lies behind the file's end");
    fields_.push_back(std::move(field));
  }
  if (!in_) fail("the table of fields is cut off");
}

void TensorFile::fail(const std::string& what) const {
  throw InputError(path_ + ": tensor file: " + what);
}

const TensorFile::Field* TensorFile::find(const std::string& name) const {
  const auto same = [&](const Field& field) { return field.name == name; };
  const auto found = std::find_if(fields_.begin(), fields_.end(), same);
  return found == fields_.end() ? nullptr : &*found;
}

const TensorFile::Field& TensorFile::require(const std::string& name) const {
  const Field* field = find(name);
  if (!field) fail("no field \"" + name + "\"");
  return *field;
}

const std::vector<std::size_t>& TensorFile::shape(const std::string& name) const {
  return require(name).shape;
}

void TensorFile::read_at(std::uint64_t offset, void* into, std::size_t bytes) {
  in_.clear();
  in_.seekg(static_cast<std::streamoff>(offset));
  in_.read(static_cast<char*>(into), static_cast<std::streamsize>(bytes));
  if (!in_) fail("cut off");
}

std::vector<float> TensorFile::floats(const std::string& name) {
  const Field& field = require(name);
  if (field.type != kFloat32) fail("field \"" + name + "\" must hold 32-bit floats");
  std::vector<float> values(field.count);
  read_at(field.offset, values.data(), values.size() * sizeof(float));
  return values;
}

std::string TensorFile::bytes(const std::string& name) {
  const Field& field = require(name);
  if (field.type != kUint8) fail("field \"" + name + "\" must hold bytes");
  std::string values(field.count, '\0');
  read_at(field.offset, values.data(), values.size());
  return values;
}

}  // namespace brdf::io
