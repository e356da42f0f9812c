// The texels of a texture, the rules by which a program reads them, and the option that gives both.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/names.h"

namespace brdf::shader {

// The numbers of one channel, row by row, the first row of the file first; all are finite.
struct TexelTable {
  std::vector<float> values;
  float least = 0, most = 0;
};

enum class TextureFilter : std::uint8_t { nearest, bilinear };
enum class TextureWrap : std::uint8_t { repeat, clamp, mirror };

struct Texture {
  std::uint32_t width = 0, height = 0;  // at least 1
  // Red, green, blue and alpha; null: the channel is 0, alpha 1.
  std::array<std::shared_ptr<const TexelTable>, 4> channels = {};
  TextureFilter filter = TextureFilter::bilinear;
  TextureWrap wrap = TextureWrap::repeat;
};

// A texture as the command line names it: the file of a variable or an argument of the shader.
struct TextureChoice {
  std::string name, file;
  TextureFilter filter = TextureFilter::bilinear;
  TextureWrap wrap = TextureWrap::repeat;

  friend bool operator==(const TextureChoice&, const TextureChoice&) = default;
};

// Parses "NAME=FILE.exr", followed by any of :nearest, :bilinear, :repeat, :clamp and :mirror. Throws
// InputError if the text is not valid.
TextureChoice parse_texture(const std::string& text);
// Returns the text that parse_texture() reads; rules that are defaults are left out.
std::string to_text(const TextureChoice& choice);
// Reads the channels R, G, B and A of an OpenEXR file, or Y as all three colours. Throws InputError, with the
// option's text, if the file cannot be read, has none of these channels or has a number that is not finite.
Texture read_texture(const TextureChoice& choice);

}  // namespace brdf::shader

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 2> kNames<shader::TextureFilter>{"nearest", "bilinear"};
template <>
inline constexpr std::array<std::string_view, 3> kNames<shader::TextureWrap>{"repeat", "clamp", "mirror"};

}  // namespace brdf
