#include <algorithm>
#include <bit>
#include <cstring>

#include "io/files/json.h"
#include "io/files/png.h"
#include "maps/textures/written.h"

namespace brdf::maps {
namespace {

using io::Json;

static_assert(std::endian::native == std::endian::little, "a .glb has little-endian numbers");

constexpr int kFloat = 5126, kArrayBuffer = 34962, kNearest = 9728, kClampToEdge = 33071;

// The binary chunk, with the views and accessors of the document.
struct Buffer {
  std::string bytes;
  Json views = Json::array(), accessors = Json::array();

  std::size_t add(const std::string& part) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    views.push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", part.size()}});
    bytes += part;
    return views.size() - 1;
  }
  std::size_t add_vertices(const std::vector<std::vector<float>>& rows) {
    std::string part;
    Json least = rows[0], most = rows[0];
    for (const std::vector<float>& row : rows)
      for (std::size_t k = 0; k < row.size(); ++k) {
        part.append(reinterpret_cast<const char*>(&row[k]), sizeof(float));
        least[k] = std::min(least[k].get<float>(), row[k]);
        most[k] = std::max(most[k].get<float>(), row[k]);
      }
    const std::size_t view = add(part);
    views[view]["target"] = kArrayBuffer;
    accessors.push_back({{"bufferView", view},
                         {"componentType", kFloat},
                         {"count", rows.size()},
                         {"type", "VEC" + std::to_string(rows[0].size())},
                         {"min", least},
                         {"max", most}});
    return accessors.size() - 1;
  }
};

// Returns two triangles in z = 0 with the upper left texel at the upper left corner.
Json mesh_of(const TexelMaterials& maps, Buffer& buffer) {
  const float larger = float(std::max(maps.width(), maps.height()));
  const float x = float(maps.width()) / larger, y = float(maps.height()) / larger;
  std::vector<std::vector<float>> positions, coordinates;
  for (const auto& [right, down] : {std::pair{0, 1}, {1, 1}, {1, 0}, {0, 1}, {1, 0}, {0, 0}}) {
    positions.push_back({right ? x : -x, down ? -y : y, 0});
    coordinates.push_back({float(right), float(down)});
  }
  Json attributes;
  attributes["POSITION"] = buffer.add_vertices(positions);
  attributes["NORMAL"] = buffer.add_vertices(std::vector(6, std::vector<float>{0, 0, 1}));
  attributes["TANGENT"] = buffer.add_vertices(std::vector(6, std::vector<float>{1, 0, 0, 1}));
  attributes["TEXCOORD_0"] = buffer.add_vertices(coordinates);
  return {{"primitives", {{{"attributes", attributes}, {"material", 0}}}}};
}

// The images of the document.
class Images {
 public:
  Images(const Carried& carried, const TexelMaterials& maps, Buffer& buffer)
      : carried_(carried), maps_(maps), buffer_(buffer) {}

  // Adds an image with the bytes of pixel(texel) in each pixel, and returns its textureInfo.
  template <class Pixel>
  Json add(const char* name, Pixel&& pixel) {
    std::vector<unsigned char> pixels;
    for (std::size_t texel = 0; texel < maps_.size(); ++texel)
      for (const unsigned char byte : pixel(texel)) pixels.push_back(byte);
    images_.push_back({{"name", name},
                       {"bufferView", buffer_.add(io::png_of_pixels(maps_.width(), maps_.height(), pixels))},
                       {"mimeType", "image/png"}});
    return {{"index", images_.size() - 1}};
  }
  // Returns the byte of an input in a texel; 255 for a constant input: the factor is then the value.
  unsigned char byte(const InputMap& map, std::size_t colour, std::size_t texel) const {
    if (!carried_.held[texel]) return 0;
    return map.constant ? 255
                        : byte_of(map.input.storage, map.shares[map.shares.size() == 1 ? 0 : colour][texel]);
  }
  void put(Json& file) const {
    if (images_.empty()) return;
    file["samplers"] = {
        {{"magFilter", kNearest}, {"minFilter", kNearest}, {"wrapS", kClampToEdge}, {"wrapT", kClampToEdge}}};
    file["textures"] = Json::array();
    for (std::size_t k = 0; k < images_.size(); ++k)
      file["textures"].push_back({{"sampler", 0}, {"source", k}});
    file["images"] = images_;
  }

 private:
  const Carried& carried_;
  const TexelMaterials& maps_;
  Buffer& buffer_;
  Json images_ = Json::array();
};

Json colour_of(const InputMap& map) {
  const auto at = [&](std::size_t c) { return map.factors[map.factors.size() == 1 ? 0 : c]; };
  return {at(0), at(1), at(2)};
}

Json metallic_roughness(const Carried& carried, Images& images) {
  const InputMap &base = carried.input("base_color"), &roughness = carried.input("roughness"),
                 &metallic = carried.input("metallic");
  Json out{{"baseColorFactor", colour_of(base)},
           {"metallicFactor", metallic.factors[0]},
           {"roughnessFactor", roughness.factors[0]}};
  out["baseColorFactor"].push_back(1);
  if (!carried.is_whole())
    out["baseColorTexture"] = images.add("base_color", [&](std::size_t t) {
      return std::array{images.byte(base, 0, t), images.byte(base, 1, t), images.byte(base, 2, t),
                        (unsigned char)(carried.held[t] ? 255 : 0)};
    });
  else if (!base.constant)
    out["baseColorTexture"] = images.add("base_color", [&](std::size_t t) {
      return std::array{images.byte(base, 0, t), images.byte(base, 1, t), images.byte(base, 2, t)};
    });
  if (!roughness.constant || !metallic.constant)
    out["metallicRoughnessTexture"] = images.add("metallic_roughness", [&](std::size_t t) {
      return std::array{(unsigned char)(0), images.byte(roughness, 0, t), images.byte(metallic, 0, t)};
    });
  return out;
}

Json specular_of(const Carried& carried, Images& images) {
  const InputMap& share = carried.input("specular");
  Json out{{"specularFactor", share.factors[0]}};
  if (!share.constant)
    out["specularTexture"] = images.add("specular", [&](std::size_t t) {
      return std::array{(unsigned char)(255), (unsigned char)(255), (unsigned char)(255),
                        images.byte(share, 0, t)};
    });
  const auto tint =
      std::ranges::find(carried.inputs, "specular_color", [](const InputMap& map) { return map.input.name; });
  if (tint == carried.inputs.end()) return out;
  out["specularColorFactor"] = colour_of(*tint);
  if (!tint->constant)
    out["specularColorTexture"] = images.add("specular_color", [&](std::size_t t) {
      return std::array{images.byte(*tint, 0, t), images.byte(*tint, 1, t), images.byte(*tint, 2, t)};
    });
  return out;
}

void append_number(std::string& out, std::size_t number) {
  const std::uint32_t little = std::uint32_t(number);
  out.append(reinterpret_cast<const char*>(&little), sizeof little);
}

std::string binary_file(const Json& document, std::string bytes) {
  std::string text = io::to_text(document);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  bytes.resize((bytes.size() + 3) / 4 * 4);
  std::string out = "glTF";
  for (const std::size_t number : {std::size_t{2}, 28 + text.size() + bytes.size(), text.size()})
    append_number(out, number);
  out += "JSON" + text;
  append_number(out, bytes.size());
  return out + std::string("BIN\0", 4) + bytes;
}

}  // namespace

std::string glb_of(const Carried& carried, const TexelMaterials& maps, const Description& described) {
  Buffer buffer;
  const Json mesh = mesh_of(maps, buffer);
  Images images(carried, maps, buffer);
  Json material{{"name", described.name}, {"pbrMetallicRoughness", metallic_roughness(carried, images)}};
  if (carried.has_normals)
    material["normalTexture"] = images.add("normal", [&](std::size_t t) {
      const Vec3<double>& n = carried.normals[t];
      const auto byte = [](double x) { return byte_of(Storage::linear_byte, 0.5 + 0.5 * x); };
      return std::array{byte(n.x), byte(n.y), byte(n.z)};
    });
  if (!carried.is_whole()) material["alphaMode"] = "MASK";
  material["extensions"] = {{"KHR_materials_ior", {{"ior", carried.index.value()}}},
                            {"KHR_materials_specular", specular_of(carried, images)}};
  Json file;
  file["asset"] = {
      {"version", "2.0"}, {"generator", "brdf " BRDF_VERSION}, {"extras", {{"brdf", described.header}}}};
  file["extensionsUsed"] = {"KHR_materials_ior", "KHR_materials_specular"};
  file["materials"] = Json::array({material});
  file["meshes"] = Json::array({mesh});
  file["nodes"] = {{{"name", described.name}, {"mesh", 0}}};
  file["scenes"] = {{{"nodes", {0}}}};
  file["scene"] = 0;
  images.put(file);
  file["bufferViews"] = buffer.views;
  file["accessors"] = buffer.accessors;
  file["buffers"] = {{{"byteLength", buffer.bytes.size()}}};
  return binary_file(file, buffer.bytes);
}

}  // namespace brdf::maps
