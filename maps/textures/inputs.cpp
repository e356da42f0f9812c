#include "maps/textures/inputs.h"

#include <algorithm>
#include <cmath>

#include "brdf/targets/parts.h"
#include "io/colour/srgb.h"

namespace brdf::maps {
namespace {

constexpr Scale kSame{[](double x) { return x; }, [](double x) { return x; }};
// Roughness is the root of alpha.
constexpr Scale kRoot{[](double alpha) { return std::sqrt(alpha); }, [](double r) { return r * r; }};
// The Specular of Blender's Principled BSDF, f0/0.08, and the index.
constexpr Scale kSpecular{[](double eta) { return f0_of_index(eta) / 0.08; },
                          [](double specular) {
                            const double root = std::sqrt(0.08 * specular);
                            return (1 + root) / (1 - root);
                          }};

constexpr double kMirrorOfCycles = 3.17e-4;  // alpha_x alpha_y <= 1e-7

Input number(std::string_view name, Role role, Storage storage, const Scale& scale = kSame) {
  return {name, role, false, false, storage, scale};
}
Input colour(std::string_view name, Role role, Storage storage) {
  return {name, role, false, true, storage, kSame};
}
Input metallic(Storage storage) {
  return {"metallic", Role::other, true, false, storage, kSame};
}

std::vector<Input> of_gltf() {
  return {colour("base_color", Role::diffuse, Storage::srgb_byte),
          number("roughness", Role::width, Storage::linear_byte, kRoot), metallic(Storage::linear_byte),
          number("specular", Role::specular, Storage::linear_byte)};
}

const std::vector<TexturedTarget>& all_targets() {
  static const std::vector<TexturedTarget> all = [] {
    std::vector<TexturedTarget> out{{"gltf_metallic_roughness", of_gltf()}, {"three_physical", of_gltf()}};
    out[0].inputs.push_back(colour("specular_color", Role::tint, Storage::srgb_byte));
    out.push_back({"materialx_schlick",
                   {colour("kd", Role::diffuse, Storage::real), number("ks", Role::specular, Storage::real),
                    colour("f0", Role::f0, Storage::real), number("alpha", Role::width, Storage::real),
                    number("sigma", Role::slope, Storage::real)}});
    out.push_back({"blender_glossy",
                   {colour("kd", Role::diffuse, Storage::real), colour("ks", Role::specular, Storage::real),
                    number("roughness", Role::width, Storage::real, kRoot)},
                   kMirrorOfCycles});
    out.push_back({"blender_principled",
                   {colour("base_color", Role::diffuse, Storage::real), metallic(Storage::real),
                    number("specular", Role::index, Storage::real, kSpecular),
                    number("roughness", Role::width, Storage::real, kRoot)},
                   kMirrorOfCycles});
    out.push_back(
        {"blender_metallic",
         {colour("kd", Role::diffuse, Storage::real), number("ks", Role::specular, Storage::real),
          colour("f0", Role::f0, Storage::real), number("roughness", Role::width, Storage::real, kRoot)},
         kMirrorOfCycles});
    return out;
  }();
  return all;
}

double encoded(Storage storage, double share) {
  return storage == Storage::srgb_byte ? io::srgb_encoded(share) : share;
}

}  // namespace

unsigned char byte_of(Storage storage, double share) {
  return (unsigned char)(std::lround(255 * encoded(storage, std::clamp(share, 0.0, 1.0))));
}

double rounded(Storage storage, double share) {
  if (storage == Storage::real) return double(float(share));
  const double stored = byte_of(storage, share) / 255.0;
  return storage == Storage::srgb_byte ? io::srgb_decoded(stored) : stored;
}

const TexturedTarget* find_textured(std::string_view target) {
  const auto found = std::ranges::find(all_targets(), target, &TexturedTarget::target);
  return found == all_targets().end() ? nullptr : &*found;
}

std::vector<std::string_view> textured_programs() {
  std::vector<std::string_view> names;
  for (const interop::Program& program : interop::programs())
    if (std::ranges::any_of(program.targets, [](const interop::TargetRules& rules) {
          return find_textured(info(rules.target).name) != nullptr;
        }))
      names.push_back(program.name);
  return names;
}

Knob::Knob(const Reflectance& target, const Input& input) {
  const ReflectanceInfo& form = info(target);
  weight_ = !input.metallic && form.weight_index(input.role) >= 0;
  if (weight_) {
    places_ = {std::size_t(form.weight_index(input.role))};
    return;
  }
  for (std::size_t k = 0; k < form.shape.size(); ++k) {
    const ParameterInfo& p = form.shape[k];
    const bool across = input.role == Role::width && p.role == Role::width_across;
    if (input.metallic ? p.map == Map::metallic : p.role == input.role || across) places_.push_back(k);
  }
}

double Knob::get(const Term& term, std::size_t colour) const {
  return weight_ ? term.weights[colour][places_[0]] : term.shape[colour][places_[0]];
}

void Knob::set(Term& term, std::size_t colour, double value) const {
  for (const std::size_t place : places_)
    (weight_ ? term.weights[colour][place] : term.shape[colour][place]) = value;
}

}  // namespace brdf::maps
