// Textures: PNG, JPEG, BMP and TGA decoded by stb, and the rusty-metal maps generated from a seed.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

namespace brdf::render {

struct Texture {
  int width = 1, height = 1;
  std::vector<std::array<std::uint8_t, 4>> texels;  // rows from the top

  // Returns the bilinear interpolation at uv; repeating, v upwards; each channel in [0, 1] as stored.
  glm::vec4 sample(glm::vec2 uv) const;
  // Returns the same for texels in sRGB, which are decoded first and then interpolated.
  glm::vec3 sample_srgb(glm::vec2 uv) const;
};

// Reads a texture. Throws InputError naming the file if it is missing, is not a picture, or is larger than
// this (4096 x 4096), because a small file may declare any size.
inline constexpr std::int64_t kMostTexels = 1 << 24;
Texture load_texture(const std::filesystem::path& file);
// Returns a texture with one texel; `value` in [0, 1].
Texture constant_texture(glm::vec4 value);

// Returns tileable maps of rusty metal, with patches of rough rust on smooth metal, from seeded value
// noise. In the order of TextureSlot: albedo (sRGB), normal, roughness, metallic.
std::array<Texture, 4> rusty_metal(int size, std::uint64_t seed);
// Returns the albedo (sRGB) of one floor tile with its joint, slightly uneven depending on the seed.
Texture floor_tile(int size, std::uint64_t seed);

}  // namespace brdf::render
