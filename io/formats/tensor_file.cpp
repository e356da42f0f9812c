#include "io/formats/tensor_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// The first bytes of the container (name and version 1.0), and the
// numbers of element types.
constexpr std::string_view kTensorMagic("tensor_file\0\1\0", 14);
enum TensorType : std::uint8_t { kUint8 = 1, kFloat32 = 10 };

// Bytes of an element by the number of its type: integers of 8 to 64 bits, each unsigned and signed, then
// floats.
constexpr std::array<std::size_t, 12> kElementSize{0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};

template <class T>
void append(std::string& out, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  out.append(raw, sizeof value);
}

}  // namespace

TensorFile::TensorFile(const Content& content) : content_(content) {
  if (!content.bytes.starts_with(kTensorMagic)) fail("not a tensor file of version 1.0");
  std::size_t at = kTensorMagic.size();
  const auto count = read_value<std::uint32_t>(at);
  for (std::uint32_t k = 0; k < count; ++k) fields_.push_back(read_field(at));
}

TensorFile::Field TensorFile::read_field(std::size_t& at) const {
  Field field;
  field.name = read_bytes(at, read_value<std::uint16_t>(at));
  field.shape.resize(read_value<std::uint16_t>(at));
  field.type = read_value<std::uint8_t>(at);
  field.offset = read_value<std::uint64_t>(at);
  const std::size_t element = field.type < kElementSize.size() ? kElementSize[field.type] : 0;
  if (element == 0)
    fail("field " + shown(field.name) + " is of the unknown type " + std::to_string(field.type));
  if (field.offset > content_.bytes.size())
    fail("field " + shown(field.name) + " begins beyond the end of the file");
  const std::size_t most = (content_.bytes.size() - field.offset) / element;
  field.count = 1;
  for (std::size_t& size : field.shape) {
    size = read_value<std::uint64_t>(at);
    if (size > 0 && field.count > most / size)
      fail("field " + shown(field.name) + " extends beyond the end of the file");
    field.count *= size;
  }
  return field;
}

template <class T>
T TensorFile::read_value(std::size_t& at) const {
  T value;
  std::memcpy(&value, read_bytes(at, sizeof value).data(), sizeof value);
  return value;
}

std::string_view TensorFile::read_bytes(std::size_t& at, std::size_t count) const {
  if (count > content_.bytes.size() - at) fail("the table of fields is truncated");
  at += count;
  return std::string_view(content_.bytes).substr(at - count, count);
}

void TensorFile::fail(const std::string& what) const {
  throw InputError(content_.name + ": tensor file: " + what);
}

const TensorFile::Field* TensorFile::find(const std::string& name) const {
  const auto same = [&](const Field& field) { return field.name == name; };
  const auto found = std::ranges::find_if(fields_, same);
  return found == fields_.end() ? nullptr : &*found;
}

const std::vector<std::size_t>& TensorFile::shape(const std::string& name) const {
  const Field* field = find(name);
  if (!field) fail("no field \"" + name + "\"");
  return field->shape;
}

const TensorFile::Field& TensorFile::require(const std::string& name, std::uint8_t type,
                                             const char* what) const {
  shape(name);
  const Field& field = *find(name);
  if (field.type != type) fail("field \"" + name + "\" must hold " + what);
  return field;
}

std::vector<float> TensorFile::floats(const std::string& name) const {
  const Field& field = require(name, kFloat32, "32-bit floats");
  std::vector<float> values(field.count);
  if (values.empty()) return values;  // memcpy to a null pointer is undefined
  std::memcpy(values.data(), content_.bytes.data() + field.offset, values.size() * sizeof(float));
  if (!std::ranges::all_of(values, [](float x) { return std::isfinite(x); }))
    fail("field \"" + name + "\" holds a value that is not finite");
  return values;
}

std::string TensorFile::bytes(const std::string& name) const {
  const Field& field = require(name, kUint8, "bytes");
  return content_.bytes.substr(field.offset, field.count);
}

void TensorWriter::add(const std::string& name, const std::string& bytes) {
  fields_.push_back({name, kUint8, {bytes.size()}, bytes});
}

void TensorWriter::add(const std::string& name, std::vector<std::uint64_t> shape,
                       const std::vector<float>& values) {
  std::string data(values.size() * sizeof(float), '\0');
  std::memcpy(data.data(), values.data(), data.size());
  fields_.push_back({name, kFloat32, std::move(shape), std::move(data)});
}

std::string TensorWriter::bytes() const {
  std::string out(kTensorMagic);
  append(out, std::uint32_t(fields_.size()));
  std::uint64_t offset = out.size();
  for (const Field& f : fields_) offset += 2 + f.name.size() + 2 + 1 + 8 + 8 * f.shape.size();
  for (const Field& f : fields_) {
    append(out, std::uint16_t(f.name.size()));
    out += f.name;
    append(out, std::uint16_t(f.shape.size()));
    append(out, f.type);
    append(out, offset);
    for (const std::uint64_t size : f.shape) append(out, size);
    offset += f.data.size();
  }
  for (const Field& f : fields_) out += f.data;
  return out;
}

}  // namespace brdf::io
