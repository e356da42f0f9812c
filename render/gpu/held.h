// Reflectances with more parameters than the shaders' arguments have room for: all but the first ones held at
// their values.
#pragma once

#include <utility>

#include "brdf/material.h"

namespace brdf::render {

// The material with every such term replaced: the first kMostWeights weights and kMostShape shape parameters
// stay, the others are constants of its formula. Others as they are.
Material with_room(Material material);

// All materials of a state of the viewer (compare/state.h) with such room.
template <class ViewState>
void give_room(ViewState& state) {
  for (auto& object : state.scene.objects) object.material = with_room(std::move(object.material));
  if (state.material) state.material = with_room(std::move(*state.material));
  for (auto& [name, material] : state.kept) material = with_room(std::move(material));
}

}  // namespace brdf::render
