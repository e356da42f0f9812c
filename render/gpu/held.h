// Adapts reflectances with more parameters than the shaders' arguments have room for: all parameters except
// the first ones are held at their values.
#pragma once

#include <utility>

#include "brdf/material.h"

namespace brdf::render {

// Returns the material with each such term replaced. The first kMostWeights weights and the first
// most_shape() shape parameters (gpu_layout.h) remain parameters; the others become constants of the term's
// formula. Other terms stay unchanged.
Material with_room(Material material);
// Returns a reflectance with room for the proofs of shaders: the form itself or, if it has too many weights,
// the form with the others held at values of both signs that float represents.
Reflectance with_room(const Reflectance& form);

// Applies with_room() to all materials of a viewer state (compare/state.h).
template <class ViewState>
void give_room(ViewState& state) {
  for (auto& object : state.scene.objects) object.material = with_room(std::move(object.material));
  if (state.material) state.material = with_room(std::move(*state.material));
  for (auto& [name, material] : state.kept) material = with_room(std::move(material));
}

}  // namespace brdf::render
