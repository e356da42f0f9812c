#include "interop/table_layouts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf::interop {
namespace {

using enum TableQuantity;
using enum TexelRule;

constexpr std::array kTableLayouts{
    TableLayout{"brdf",
                "this program",
                {cosine_of_root, ends, 128},
                {roughness, ends, 64},
                false,
                TableFormat::float32,
                "",
                ""},
    TableLayout{"filament",
                "Filament",
                {cosine, centres, 128},
                {roughness, centres, 128, true, 1},
                true,
                TableFormat::half,
                "google/filament@13d3ade5 libs/ibl/src/CubemapIBL.cpp, multiscatter",
                "size and number format"},
    TableLayout{"unity",
                "Unity HDRP",
                {cosine_of_root, ends, 64},
                {roughness, ends, 64},
                true,
                TableFormat::bits10,
                "com.unity.render-pipelines.core@3d17782, PreIntegratedFGD.hlsl",
                "number format; the third channel, Disney's diffuse albedo, is not written"},
    TableLayout{"unreal",
                "Unreal Engine",
                {cosine, centres, 128},
                {roughness, centres, 32},
                false,
                TableFormat::bits16,
                "SystemTextures.cpp and BRDF.ush, public copies",
                "the version of the copies"},
    TableLayout{"three",
                "three.js 0.187",
                {roughness, centres, 16},
                {cosine, centres, 16},
                false,
                TableFormat::half,
                "three 0.187.0 src/renderers/shaders/DFGLUTData.js",
                ""},
    TableLayout{"gltf",
                "Khronos gltf-viewer 1.1.0",
                {cosine, centres, 256},
                {roughness, centres, 256},
                false,
                TableFormat::bits8,
                "@khronosgroup/gltf-viewer 1.1.0",
                "size and number format"},
    TableLayout{"materialx",
                "MaterialX 1.39.6",
                {cosine, centres, 64},
                {alpha, centres, 64},
                false,
                TableFormat::float32,
                "MaterialX@4177b2cb, DIRECTIONAL_ALBEDO_METHOD 1",
                "size, rule of texels and number format"}};

double coordinate(const TableAxis& axis, std::size_t i, double shift) {
  const double place = double(axis.descending ? axis.size - 1 - i : i) + shift;
  if (axis.rule == ends) return axis.size > 1 ? place / double(axis.size - 1) : 0;
  return std::min((place + 0.5) / double(axis.size), 1.0);
}

}  // namespace

double TableAxis::computed_at(std::size_t i) const {
  return coordinate(*this, i, shift);
}

double TableAxis::read_at(std::size_t i) const {
  return coordinate(*this, i, 0);
}

std::span<const TableLayout> table_layouts() {
  return kTableLayouts;
}

const TableLayout* find_table_layout(std::string_view name) {
  const auto found = std::ranges::find(kTableLayouts, name, &TableLayout::name);
  return found == kTableLayouts.end() ? nullptr : &*found;
}

double stored(double value, TableFormat format) {
  const auto whole = [value](double most) { return std::round(std::clamp(value, 0.0, 1.0) * most) / most; };
  switch (format) {
    case TableFormat::float32:
      return float(value);
    case TableFormat::half: {
      int exponent = 0;
      std::frexp(value, &exponent);  // value = fraction in [1/2, 1) times 2^exponent
      const double step = std::ldexp(1.0, std::max(exponent - 11, -24));
      return std::nearbyint(value / step) * step;
    }
    case TableFormat::bits16:
      return whole(65535);
    case TableFormat::bits10:
      return whole(1023);
    case TableFormat::bits8:
      return whole(255);
  }
  return value;
}

std::string_view name_of_format(TableFormat format) {
  constexpr std::array<std::string_view, 5> kFormats{"32-bit float", "16-bit float", "16 bits", "10 bits",
                                                     "8 bits"};
  return kFormats[std::size_t(format)];
}

}  // namespace brdf::interop
