// Colours of the grid, the light and the text around lobes, for plots and bodies.
#pragma once

#include "render/picture/canvas.h"

namespace brdf::render {

inline constexpr ByteColor kLobeGrid{110, 110, 115}, kLobeLight{255, 220, 120}, kLobeWords{225, 225, 225};

}  // namespace brdf::render
