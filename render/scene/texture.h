// Textures: PNG, JPEG, BMP and TGA through stb, and the seeded rusty-metal maps.
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

  // Bilinear, repeating, v upwards; each channel in [0, 1] as stored.
  glm::vec4 sample(glm::vec2 uv) const;
  // The same of texels that hold sRGB: decoded first, then interpolated.
  glm::vec3 sample_srgb(glm::vec2 uv) const;
};

// Throws InputError naming the file when it is missing, no picture, or larger than this (4096 x 4096): a
// small file may ask for any size.
inline constexpr std::int64_t kMostTexels = 1 << 24;
Texture load_texture(const std::filesystem::path& file);
Texture constant_texture(glm::vec4 value);

// Rusty metal: patches of rough rust on smooth metal, by seeded value noise, tileable. In the order of
// TextureSlot: albedo (sRGB), normal, roughness, metallic.
std::array<Texture, 4> rusty_metal(int size, std::uint64_t seed);
// One floor tile with its joint: albedo (sRGB), slightly uneven by the seed.
Texture floor_tile(int size, std::uint64_t seed);

}  // namespace brdf::render
