#include "io/formats/tensor_writer.h"

#include <cstring>

#include "io/formats/tensor_file.h"

namespace brdf::io {
namespace {

template <class T>
void append(std::string& out, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  out.append(raw, sizeof value);
}

}  // namespace

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
