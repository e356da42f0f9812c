#include "interop/programs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "brdf/targets/blender.h"
#include "brdf/targets/gltf.h"
#include "brdf/targets/mitsuba.h"
#include "brdf/targets/pbrt.h"
#include "fit/model/constraints.h"
#include "interop/writers.h"
#include "io/error.h"
#include "io/numbers.h"
#include "io/provenance.h"
#include "io/text.h"

namespace brdf::interop {
namespace {

constexpr double kAnyWeight = std::numeric_limits<double>::infinity();

// What the index controls of a principled model reach: named by the target's own table.
fit::NamedRange index_up_to(const Reflectance& target, double high) {
  const ReflectanceInfo& form = info(target);
  const ParameterInfo& p = form.shape[std::size_t(form.shape_index(Role::index))];
  return {std::string(p.name), p.min, high};
}

// The projected material as other verbs take it: brdf eval --form NAME --set ...
std::string as_command(const Term& term, Angle tangent) {
  const ReflectanceInfo& form = info(term.form);
  std::string text = "--form " + std::string(form.name);
  const auto add = [&](const ParameterInfo& p, std::size_t k, const std::vector<std::vector<double>>& sets) {
    if (p.min == p.max) return;
    std::vector<std::string> values;
    for (const std::vector<double>& set : sets) values.push_back(io::to_text(set[k]));
    if (std::ranges::adjacent_find(values, std::not_equal_to<>()) == values.end()) values.resize(1);
    text += " --set " + std::string(p.name) + "=" + io::joined(values, ",");
  };
  for (std::size_t k = 0; k < form.weights.size(); ++k) add(form.weights[k], k, term.weights);
  for (std::size_t k = 0; k < form.shape.size(); ++k) add(form.shape[k], k, term.shape);
  if (tangent != Angle{})
    text += " --set " + std::string(fit::kTangentInfo.name) + "=" +
            io::to_text(std::remainder(tangent.degrees(), 360));
  return text;
}

}  // namespace

std::span<const Program> programs() {
  constexpr CopyRules kGrey{.grey_lobe = true};
  static const std::vector<Program> all{
      {"blender",
       "Blender 4.3 and later, Cycles",
       kAnyWeight,
       false,
       {"Roughness is the square root of alpha; colours are linear; distribution GGX, not Multiscatter GGX"},
       {{blender_metallic{}, kGrey, true}},
       write_blender},
      {"blender-3.4",
       "Blender 3.4, Cycles",
       kAnyWeight,
       true,
       {"Roughness is the square root of alpha; colours are linear; distribution GGX, not Multiscatter GGX"},
       {{blender_glossy{}}, {blender_principled{}, {}, false, {index_up_to(blender_principled{}, 1.788)}}},
       write_blender_3_4},
      {"mitsuba",
       "Mitsuba 3",
       1,
       false,
       {"roughconductor: alpha as it stands; principled: roughness is the square root of alpha",
        "colours are linear; the tangent is the mesh's dp/du"},
       {{mitsuba_roughconductor{}, {}, true}, {mitsuba_principled{}}},
       write_mitsuba},
      {"pbrt",
       "pbrt-v4",
       1,
       false,
       {"roughness is alpha: remaproughness is false; colours are linear and become spectra",
        "mix: amount is the share of the second material; the tangent is the mesh's dp/du"},
       {{pbrt_conductor{}, {.grey_lobe = true, .fresnel_per_channel = true}, true}},
       write_pbrt},
      {"gltf",
       "glTF 2.0, as its specification has it",
       1,
       false,
       {"roughness is the square root of alpha (of the narrower axis); colours are linear",
        "programs may compute more: three.js scales the lobe by a multiple-scattering term"},
       {{gltf_metallic_roughness{}}},
       write_gltf}};
  return all;
}

const Program* find_program(std::string_view name) {
  for (const Program& program : programs())
    if (program.name == name) return &program;
  return nullptr;
}

Exported export_to(const Program& program, const Material& material, const std::string& name, bool naive) {
  const Wanted asked = wanted(material, program.name, program.most);
  std::optional<Exported> best;
  std::string refused;
  for (const TargetRules& rules : program.targets) {
    Exported tried;
    tried.projection = project(asked, rules, naive);
    if (best && tried.projection.loss.rms >= best->projection.loss.rms) continue;
    tried.target = std::string(info(rules.target).name);
    tried.header = {
        "Written by brdf " BRDF_VERSION ": " + io::provenance().command,
        "for " + std::string(program.title) + ", as " + tried.target + ": " + in_words(tried.projection)};
    tried.header.push_back("the same here: brdf eval " +
                           as_command(tried.projection.material.terms[0], asked.tangent));
    tried.header.insert(tried.header.end(), program.conventions.begin(), program.conventions.end());
    try {
      tried.text = program.write({tried.projection.material.terms[0], asked.tangent, name, tried.header});
    } catch (const InputError& error) {
      refused = error.what();
      continue;
    }
    best = std::move(tried);
    if (best->projection.exact()) break;
  }
  if (!best) throw InputError("--to " + std::string(program.name) + ": " + refused);
  return std::move(*best);
}

}  // namespace brdf::interop
