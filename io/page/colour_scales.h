// Colour scales for pictures, pages and shaders.
#pragma once

#include <array>

namespace brdf::io {

// Five colours at equal distances with equal steps in lightness, 0 to 255 per channel. Colours between them
// are interpolated linearly.
using ColourScale = std::array<std::array<double, 3>, 5>;
// From dark to bright; readable in print and without colour vision.
inline constexpr ColourScale kSequentialScale{
    {{48, 18, 59}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
// From blue over white to red, for values with a sign.
inline constexpr ColourScale kDivergingScale{
    {{31, 95, 168}, {143, 175, 212}, {255, 255, 255}, {217, 140, 149}, {178, 24, 43}}};

}  // namespace brdf::io
