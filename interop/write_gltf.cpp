#include <algorithm>
#include <cmath>
#include <numbers>

#include "interop/reading.h"
#include "io/files/error.h"
#include "io/files/json.h"

namespace brdf::interop {

std::string write_gltf(const Written& w) {
  const Reading r(w.parts.front());
  r.check_widths(0, 1e4, "nothing");
  if (r.alpha_x() < r.alpha_y())
    throw InputError("the wider axis is across the tangent, but glTF widens along the tangent");
  const Colour base = r.colour(Role::diffuse);
  // alpha_x = alpha_y + (1 - alpha_y) strength^2
  const double strength = std::sqrt((r.alpha_x() - r.alpha_y()) / std::max(1 - r.alpha_y(), 1e-12));
  io::Json extensions;
  extensions["KHR_materials_ior"] = {{"ior", r.shape(Role::index)}};
  extensions["KHR_materials_specular"] = {{"specularFactor", r.shape(Role::specular)}};
  if (const Colour tint = r.shape_colours(Role::tint); r.has_shape(Role::tint) && tint != Colour{1, 1, 1})
    extensions["KHR_materials_specular"]["specularColorFactor"] = {tint[0], tint[1], tint[2]};
  if (r.anisotropic())
    extensions["KHR_materials_anisotropy"] = {{"anisotropyStrength", strength},
                                              {"anisotropyRotation", r.turn() * std::numbers::pi / 180}};
  io::Json material;
  material["name"] = w.name;
  material["pbrMetallicRoughness"] = {{"baseColorFactor", {base[0], base[1], base[2], 1}},
                                      {"metallicFactor", r.metallic()},
                                      {"roughnessFactor", std::sqrt(r.alpha_y())}};
  material["extensions"] = extensions;
  io::Json file;
  file["asset"] = {{"version", "2.0"}, {"generator", "brdf " BRDF_VERSION}, {"extras", {{"brdf", w.header}}}};
  file["extensionsUsed"] = io::Json::array();
  for (const auto& [name, value] : extensions.items()) file["extensionsUsed"].push_back(name);
  file["materials"] = io::Json::array({material});
  return io::to_text(file);
}

}  // namespace brdf::interop
