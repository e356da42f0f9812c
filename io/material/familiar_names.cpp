// Maps the terms of other programs and books to the forms and parameters of this project. A term may have
// several meanings; the names known in the context decide.
#include <array>

#include "io/files/near_name.h"

namespace brdf::io {
namespace {

struct Familiar {
  std::string_view word, ours;
};
constexpr std::array kFamiliar{
    Familiar{"ggx", "cook_torrance"},
    Familiar{"trowbridgereitz", "cook_torrance"},
    Familiar{"microfacet", "cook_torrance"},
    Familiar{"roughconductor", "cook_torrance"},
    Familiar{"beckmann", "cook_torrance_beckmann"},
    Familiar{"roughdielectric", "cook_torrance_dielectric"},
    Familiar{"torrancesparrow", "cook_torrance_vcavity"},
    Familiar{"lambertian", "lambert"},
    Familiar{"matte", "lambert"},
    Familiar{"eon", "oren_nayar_energy"},
    Familiar{"gaussian", "ward"},
    Familiar{"specular", "ks"},
    Familiar{"specular", "cook_torrance"},
    Familiar{"gloss", "ks"},
    Familiar{"diffuse", "kd"},
    Familiar{"diffuse", "rho"},
    Familiar{"diffuse", "albedo"},
    Familiar{"diffuse", "lambert"},
    Familiar{"basecolor", "kd"},
    Familiar{"basecolor", "rho"},
    Familiar{"albedo", "rho"},
    Familiar{"albedo", "kd"},
    Familiar{"reflectance", "rho"},
    Familiar{"reflectance", "f0"},
    Familiar{"fresnel", "f0"},
    Familiar{"roughness", "alpha"},
    Familiar{"roughness", "sigma"},
    Familiar{"roughness", "exponent"},
    Familiar{"shininess", "exponent"},
    Familiar{"glossiness", "exponent"},
    Familiar{"n", "exponent"},
    Familiar{"ior", "eta"},
    Familiar{"m", "alpha"},
};

}  // namespace

std::vector<std::string_view> familiar_names(std::string_view word) {
  std::vector<std::string_view> names;
  for (const Familiar& f : kFamiliar)
    if (f.word == word) names.push_back(f.ours);
  return names;
}

}  // namespace brdf::io
