// A car's wheel, off the lathe: its axle along z, its outer side at positive z.
#pragma once

#include "render/mesh/mesh.h"

namespace brdf::render {

inline constexpr float kTyreRadius = 0.34f;
Mesh make_tyre();
Mesh make_rim();  // ten spokes

}  // namespace brdf::render
