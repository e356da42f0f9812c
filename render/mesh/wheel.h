// A car's wheel made by the lathe: the axle along z, the outer side at positive z.
#pragma once

#include "render/mesh/mesh.h"

namespace brdf::render {

inline constexpr float kTyreRadius = 0.34f;
Mesh make_tyre();
Mesh make_rim();  // ten spokes

}  // namespace brdf::render
