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
  r.check_wider_along("glTF");
  const Colour base = r.colour(Role::diffuse);
  io::Json extensions;
  extensions["KHR_materials_ior"] = {{"ior", r.shape(Role::index)}};
  extensions["KHR_materials_specular"] = {{"specularFactor", r.shape(Role::specular)}};
  if (const Colour tint = r.shape_colours(Role::tint); r.has_shape(Role::tint) && tint != Colour{1, 1, 1})
    extensions["KHR_materials_specular"]["specularColorFactor"] = {tint[0], tint[1], tint[2]};
  if (r.anisotropic())
    extensions["KHR_materials_anisotropy"] = {{"anisotropyStrength", r.anisotropy_strength()},
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
