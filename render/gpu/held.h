// Reflectances with more parameters than the shaders' arguments have room for: all but the first ones held at their values.
#pragma once

#include "brdf/material.h"

namespace brdf::render {

// The material with every such term replaced: the first kMostWeights weights and kMostShape shape parameters stay, the others are
// constants of its formula. Others as they are.
Material with_room(Material material);

}  // namespace brdf::render
