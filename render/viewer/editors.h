// The parts of the panels that edit a material, an object, the lights.
#pragma once

#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace brdf::render {

// A list to choose from; true when another entry was chosen.
bool combo(const char* label, std::size_t& index, const std::vector<std::string>& names);

template <class Enum>
void enum_combo(const char* label, Enum& value) {
  std::size_t index = std::size_t(value);
  if (combo(label, index, {kNames<Enum>.begin(), kNames<Enum>.end()})) value = Enum(index);
}

// Family, form, and a slider per parameter of the form's table, for every term.
void edit_material(Material& material);
void edit_object(Object& object);
void edit_lights(Scene& scene);

}  // namespace brdf::render
