#include "interop/programs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "brdf/targets/blender.h"
#include "brdf/targets/gltf.h"
#include "brdf/targets/materialx.h"
#include "brdf/targets/mitsuba.h"
#include "brdf/targets/osl.h"
#include "brdf/targets/pbrt.h"
#include "brdf/targets/three.h"
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

Limits limits_of(const Program& program) {
  Limits limits{program.name, program.most, program.most_lobe};
  for (const TargetRules& rules : program.targets) {
    limits.targets.push_back(rules.target);
    limits.fresnel_per_channel |= std::ranges::any_of(rules.copy.coloured, is_fresnel);
  }
  return limits;
}

// A material on its way to one program.
struct Attempt {
  const Program& program;
  const Wanted& asked;
  const std::string& name;
  std::optional<Loss> copied{};  // of what --naive writes
  std::vector<Refusal> refused{};

  // Throws InputError for what the program's controls do not reach.
  Exported with(const TargetRules& rules, bool naive) const {
    Exported made;
    made.projection = project(asked, rules, naive);
    if (copied) made.projection.copied = *copied;
    made.target = std::string(info(rules.target).name);
    made.words = as_command(made.projection.material.terms[0], asked.tangent);
    made.header = {
        "Written by brdf " BRDF_VERSION ": " + io::provenance().command,
        "for " + std::string(program.title) + ", as " + made.target + ": " + in_words(made.projection),
        "the same here: brdf eval " + made.words};
    made.header.insert(made.header.end(), program.conventions.begin(), program.conventions.end());
    made.text = program.write({made.projection.material.terms[0], asked.tangent, name, made.header});
    return made;
  }

  // Of the program's targets the nearest that can be written; what cannot be is kept with its reason.
  std::optional<Exported> best(bool naive) {
    std::optional<Exported> best;
    refused.clear();
    for (const TargetRules& rules : program.targets) {
      try {
        Exported tried = with(rules, naive);
        if (!best || is_nearer(tried.projection.loss, best->projection.loss)) best = std::move(tried);
      } catch (const InputError& error) {
        refused.push_back({std::string(info(rules.target).name), error.what()});
      }
      if (best && best->projection.exact()) break;
    }
    return best;
  }
};

}  // namespace

std::span<const Program> programs() {
  constexpr CopyRules kGrey{.grey_lobe = true};
  static const std::vector<Program> all{
      {"blender",
       "Blender 4.3 and later, Cycles",
       kAnyWeight,
       1,
       false,
       {"Roughness is the square root of alpha; colours are linear; distribution GGX, not Multiscatter GGX"},
       {{blender_metallic{}, kGrey, true}},
       write_blender},
      {"blender-3.4",
       "Blender 3.4, Cycles",
       kAnyWeight,
       kAnyWeight,
       true,
       {"Roughness is the square root of alpha; colours are linear; distribution GGX, not Multiscatter GGX"},
       {{blender_glossy{}}, {blender_principled{}, {}, false, {index_up_to(blender_principled{}, 1.788)}}},
       write_blender_3_4},
      {"mitsuba",
       "Mitsuba 3",
       1,
       1,
       false,
       {"roughconductor: alpha as it stands; principled: roughness is the square root of alpha",
        "colours are linear; the tangent is the mesh's dp/du"},
       {{mitsuba_roughconductor{}, {}, true}, {mitsuba_principled{}}},
       write_mitsuba},
      {"pbrt",
       "pbrt-v4",
       1,
       1,
       false,
       {"roughness is alpha: remaproughness is false; colours are linear and become spectra",
        "mix: amount is the share of the second material; the tangent is the mesh's dp/du"},
       {{pbrt_conductor{}, {.grey_lobe = true, .coloured = {Role::index, Role::extinction}}, true}},
       write_pbrt},
      {"gltf",
       "glTF 2.0, as its specification has it",
       1,
       1,
       false,
       {"roughness is the square root of alpha (of the narrower axis); colours are linear",
        "programs may compute more: three.js scales the lobe by a multiple-scattering term (--to three)"},
       {{gltf_metallic_roughness{}}},
       write_gltf},
      {"three",
       "three.js 0.187, as glTF",
       1,
       1,
       true,
       {"roughness is the square root of alpha (of the narrower axis); colours are linear",
        "lit by lights, not by an environment map"},
       {{three_physical{}, {.coloured = {Role::diffuse}}}},
       write_gltf},
      {"materialx",
       "MaterialX 1.39.6, its generated shaders",
       1,
       1,
       false,
       {"roughness of the lobe is alpha, of the diffuse part the slopes' standard deviation; colours are "
        "linear (lin_rec709)",
        "the tangent is Tworld, turned about Nworld"},
       {{materialx_schlick{}, {.grey_lobe = true, .coloured = {Role::f0}}}},
       write_materialx},
      {"osl",
       "OSL, as its testrender shades",
       kAnyWeight,
       kAnyWeight,
       false,
       {"widths are alphas; colours are linear; the tangent is dPdu, turned about N"},
       {{osl_microfacet{}}, {osl_ward{}}, {osl_phong{}}, {osl_oren_nayar{}}},
       write_osl}};
  return all;
}

const Program* find_program(std::string_view name) {
  for (const Program& program : programs())
    if (program.name == name) return &program;
  return nullptr;
}

Exported export_to(const Program& program, const Material& material, const std::string& name, bool naive) {
  const Wanted asked = wanted(material, limits_of(program));
  Attempt attempt{program, asked, name};
  std::optional<Exported> copy = attempt.best(true);
  if (copy && (naive || copy->projection.exact())) return std::move(*copy);
  if (copy) attempt.copied = copy->projection.loss;
  std::optional<Exported> best = naive ? std::nullopt : attempt.best(false);
  if (best && copy && !is_nearer(best->projection.loss, copy->projection.loss)) best.reset();
  if (!best) best = std::move(copy);
  if (!best) throw Refused("--to " + std::string(program.name) + ": " + attempt.refused.back().reason);
  best->refused = std::move(attempt.refused);
  return std::move(*best);
}

}  // namespace brdf::interop
