// The parts of the panels that edit a material, an object and the lights.
#pragma once

#include <string>
#include <vector>

#include "render/viewer/by_hand.h"
#include "render/viewer/session.h"

namespace brdf::render {

// Draws a list to choose from; returns true if another entry was chosen.
bool combo(const char* label, std::size_t& index, const std::vector<std::string>& names);

template <class Enum>
void enum_combo(const char* label, Enum& value) {
  std::size_t index = std::size_t(value);
  if (combo(label, index, {kNames<Enum>.begin(), kNames<Enum>.end()})) value = Enum(index);
}

// Draws family, form, and sliders for the parameters of the form's table, for each term of the selected
// object's material, with the intervals of its fit.
void edit_material(Session& session, const std::vector<Interval>& intervals);
void edit_object(Object& object);
void edit_lights(Scene& scene);

}  // namespace brdf::render
