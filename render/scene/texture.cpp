#include "render/scene/texture.h"

#include <cmath>
#include <cstring>
#include <random>

#include "brdf/random.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "render/decode/picture_bytes.h"
#include "render/scene/display_rule.h"

namespace brdf::render {
namespace {

std::uint8_t to_byte(float x) {
  return std::uint8_t(std::lround(glm::clamp(x, 0.0f, 1.0f) * 255));
}

// Tileable value noise: `octaves` lattices of random numbers, each twice as fine and half as strong as the
// one before.
class Noise {
 public:
  Noise(std::uint64_t seed, int cells, int octaves) {
    std::mt19937_64 random(seed);
    for (int o = 0; o < octaves; ++o, cells *= 2) {
      lattices_.emplace_back();
      lattices_.back().cells = cells;
      for (int i = 0; i < cells * cells; ++i) lattices_.back().values.push_back(float(uniform01(random)));
    }
  }
  // Returns a value in [0, 1], centred about 0.5; uv in units of the tile.
  float at(glm::vec2 uv) const {
    float sum = 0, weight = 0, amplitude = 1;
    for (const Lattice& lattice : lattices_) {
      sum += amplitude * lattice.at(uv);
      weight += amplitude;
      amplitude *= 0.5f;
    }
    return sum / weight;
  }

 private:
  struct Lattice {
    int cells = 0;
    std::vector<float> values;
    float corner(int x, int y) const { return values[std::size_t((y % cells) * cells + x % cells)]; }
    float at(glm::vec2 uv) const {
      const glm::vec2 p = (uv - glm::floor(uv)) * float(cells);
      const int x = int(p.x), y = int(p.y);
      glm::vec2 t = p - glm::vec2(float(x), float(y));
      t = t * t * (3.0f - 2.0f * t);
      return glm::mix(glm::mix(corner(x, y), corner(x + 1, y), t.x),
                      glm::mix(corner(x, y + 1), corner(x + 1, y + 1), t.x), t.y);
    }
  };
  std::vector<Lattice> lattices_;
};

// Returns the bilinear interpolation of decode(texel).
template <class Decode>
auto interpolated(const Texture& map, glm::vec2 uv, Decode decode) {
  const glm::vec2 size{float(map.width), float(map.height)};
  const glm::vec2 p = glm::vec2(uv.x - std::floor(uv.x), 1 - (uv.y - std::floor(uv.y))) * size - 0.5f;
  const glm::vec2 base = glm::floor(p), t = p - base;
  const auto texel = [&](int dx, int dy) {
    const int x = (int(base.x) + dx + map.width) % map.width,
              y = (int(base.y) + dy + map.height) % map.height;
    return decode(map.texels[std::size_t(y) * std::size_t(map.width) + std::size_t(x)]);
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), t.x), glm::mix(texel(0, 1), texel(1, 1), t.x), t.y);
}

float srgb_decoded(std::uint8_t byte) {
  const float x = float(byte) / 255;
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

glm::vec4 Texture::sample(glm::vec2 uv) const {
  return interpolated(*this, uv, [](const auto& c) { return glm::vec4(c[0], c[1], c[2], c[3]) / 255.0f; });
}

glm::vec3 Texture::sample_srgb(glm::vec2 uv) const {
  return interpolated(*this, uv, [](const auto& c) {
    return glm::vec3(srgb_decoded(c[0]), srgb_decoded(c[1]), srgb_decoded(c[2]));
  });
}

Texture load_texture(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) throw InputError(file.string() + ": no such texture file");
  const io::Content content = io::read_content(file);
  if (const auto size = picture_size(content);
      size && std::int64_t(size->width) * std::abs(std::int64_t(size->height)) > kMostTexels)
    throw InputError(file.string() + ": has " + std::to_string(size->width) + " x " +
                     std::to_string(size->height) + " pixels; at most " + std::to_string(kMostTexels) +
                     " (4096 x 4096) are read");
  const Pixels<unsigned char> pixels = decoded_bytes(content, 4, "cannot be read as PNG, JPEG, BMP or TGA");
  Texture texture;
  texture.width = pixels.size.width;
  texture.height = pixels.size.height;
  if (texture.width * texture.height == 0) throw InputError(file.string() + ": has no pixels");
  texture.texels.resize(std::size_t(texture.width) * std::size_t(texture.height));
  std::memcpy(texture.texels.data(), pixels.values.get(), 4 * texture.texels.size());
  return texture;
}

Texture constant_texture(glm::vec4 value) {
  return {1, 1, {{to_byte(value.r), to_byte(value.g), to_byte(value.b), to_byte(value.a)}}};
}

std::array<Texture, 4> rusty_metal(int size, std::uint64_t seed) {
  const Noise patches(seed, 4, 6), grain(seed + 1, 32, 3);
  const auto rust_at = [&](glm::vec2 uv) { return glm::smoothstep(0.46f, 0.54f, patches.at(uv)); };
  const auto height_at = [&](glm::vec2 uv) { return rust_at(uv) * (0.6f + 0.8f * grain.at(uv)); };
  std::array<Texture, 4> maps;
  for (Texture& map : maps) {
    map.width = map.height = size;
    map.texels.resize(std::size_t(size) * std::size_t(size));
  }
  const float step = 1 / float(size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const glm::vec2 uv = (glm::vec2(float(x), float(y)) + 0.5f) * step;
      const float rust = rust_at(uv), fine = grain.at(uv);
      const glm::vec3 rust_color =
          glm::mix(glm::vec3(0.20f, 0.06f, 0.02f), glm::vec3(0.45f, 0.18f, 0.06f), fine);
      const glm::vec3 metal_color(0.56f, 0.57f, 0.58f);
      const glm::vec3 albedo = glm::mix(metal_color, rust_color, rust);
      // The relief is one hundredth of the tile high; v runs upwards, rows downwards.
      const glm::vec2 slope(height_at(uv + glm::vec2(step, 0)) - height_at(uv - glm::vec2(step, 0)),
                            height_at(uv - glm::vec2(0, step)) - height_at(uv + glm::vec2(0, step)));
      const glm::vec3 normal = glm::normalize(glm::vec3(-slope * (0.005f / step), 1));
      const float roughness = glm::mix(0.45f + 0.1f * fine, 0.85f + 0.1f * fine, rust);
      const std::size_t at = std::size_t(y) * std::size_t(size) + std::size_t(x);
      maps[0].texels[at] = {to_byte(srgb_encoded(albedo.r)), to_byte(srgb_encoded(albedo.g)),
                            to_byte(srgb_encoded(albedo.b)), 255};
      maps[1].texels[at] = {to_byte(normal.x * 0.5f + 0.5f), to_byte(normal.y * 0.5f + 0.5f),
                            to_byte(normal.z * 0.5f + 0.5f), 255};
      maps[2].texels[at] = {to_byte(roughness), to_byte(roughness), to_byte(roughness), 255};
      maps[3].texels[at] = {to_byte(1 - rust), to_byte(1 - rust), to_byte(1 - rust), 255};
    }
  }
  return maps;
}

Texture floor_tile(int size, std::uint64_t seed) {
  const Noise cloud(seed, 4, 5);
  Texture map;
  map.width = map.height = size;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const glm::vec2 uv = (glm::vec2(float(x), float(y)) + 0.5f) / float(size);
      const float edge = glm::min(glm::min(uv.x, 1 - uv.x), glm::min(uv.y, 1 - uv.y));
      const float tile = glm::smoothstep(0.015f, 0.03f, edge);
      const glm::vec3 albedo =
          glm::mix(glm::vec3(0.08f), glm::vec3(0.42f, 0.38f, 0.34f) * (0.8f + 0.4f * cloud.at(uv)), tile);
      map.texels.push_back({to_byte(srgb_encoded(albedo.r)), to_byte(srgb_encoded(albedo.g)),
                            to_byte(srgb_encoded(albedo.b)), 255});
    }
  }
  return map;
}

}  // namespace brdf::render
