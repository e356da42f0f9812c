#include "interop/programs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "brdf/targets/blender.h"
#include "brdf/targets/gltf.h"
#include "brdf/targets/materialx.h"
#include "brdf/targets/materialx_surfaces.h"
#include "brdf/targets/mitsuba.h"
#include "brdf/targets/osl.h"
#include "brdf/targets/pbrt.h"
#include "brdf/targets/radiance.h"
#include "brdf/targets/three.h"
#include "fit/model/constraints.h"
#include "interop/pbrt_colour.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"
#include "io/files/text.h"
#include "io/material/below_zero.h"

namespace brdf::interop {

// Each program has a file of its own, write_NAME.cpp. Other code needs only the program's row in the table
// below.
// Returns a Python script that makes the node material: make_material(name, tangent).
std::string write_blender(const Written& w);
std::string write_blender_3_4(const Written& w);
// Returns a scene with the bsdf, for inclusion.
std::string write_mitsuba(const Written& w);
// Returns a MakeNamedMaterial.
std::string write_pbrt(const Written& w);
// Returns a file with one material and its extensions.
std::string write_gltf(const Written& w);
// Returns a nodegraph of pbrlib with its surface and material.
std::string write_materialx(const Written& w);
// Return a document with one surface node of this name and its material.
std::string write_open_pbr_surface(const Written& w);
std::string write_standard_surface(const Written& w);
std::string write_gltf_pbr(const Written& w);
std::string write_usd_preview_surface(const Written& w);
std::string write_disney_principled(const Written& w);
// Returns an OSL surface shader that adds closures.
std::string write_osl(const Written& w);
// Returns material modifiers: plastic, metal, and mixfunc for sums.
std::string write_radiance(const Written& w);

namespace {

constexpr double kAnyWeight = std::numeric_limits<double>::infinity();

// Range of a principled model's index control. The name comes from the target's own parameter table.
fit::NamedRange index_up_to(const Reflectance& target, double high) {
  const ReflectanceInfo& form = info(target);
  const ParameterInfo& p = form.shape[std::size_t(form.shape_index(Role::index))];
  return {std::string(p.name), p.min, high};
}

// A surface node of MaterialX: one colour and one lobe.
Program surface_node(std::string_view name, Reflectance target, std::string (*write)(const Written&)) {
  return {.name = name,
          .title = "MaterialX 1.39.6, its node of this name in generated shaders",
          .most = 1,
          .most_lobe = 1,
          .adds = false,
          .run_here = false,
          .conventions = {"colours are linear (lin_rec709); the roughness of the lobe is that of the node",
                          "coat, sheen, transmission, emission and thin film are off"},
          .targets = {{target, {.coloured = {Role::diffuse}}}},
          .write = write};
}

// UsdPreviewSurface cannot write a coloured material between metal and dielectric, so both ends are tried.
Program with_both_ends(Program program) {
  for (const double metallic : {0.0, 1.0}) {
    program.targets.push_back(program.targets.front());
    program.targets.back().bounds = {{std::string(kMetallicInfo.name), metallic, metallic}};
  }
  return program;
}

// Places the term in the surface's frame.
Term in_place(Term term, Angle tangent) {
  term.tangent_phi = tangent;
  return term;
}

// The export of a material to one program.
struct Attempt {
  const Program& program;
  const std::vector<Wanted>& parts;
  const Comparison whole;  // their sum
  const std::string& name;
  std::optional<Loss> copied{};  // loss of the text that --naive writes
  std::vector<Refusal> refused{};

  // Throws InputError for values outside the range of the program's controls.
  Exported with(const TargetRules& rules, bool naive) const {
    std::vector<Projection> projections;
    for (const Wanted& part : parts) projections.push_back(project(part, within_shares(rules, part), naive));
    Exported made;
    made.carried.channels = whole.wanted().channels;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Projection& p = projections[k];
      made.refitted = made.refitted || p.refitted;
      const Material shown = shown_by(rules, p.material);
      made.by_channel = made.by_channel || !(shown == p.material);
      for (const Term& term : shown.terms) made.carried.terms.push_back(in_place(term, parts[k].tangent));
      made.words.push_back(as_command(p.material.terms[0], parts[k].tangent));
      for (std::string& sentence : not_held(parts[k], holds(rules)))
        made.not_held.push_back(std::move(sentence));
    }
    made.loss = whole.loss_of(made.carried);
    made.is_same = made.carried == whole.wanted();
    made.copied = copied ? *copied : made.loss;
    made.target = std::string(info(rules.target).name);
    made.header = header_of(made);
    Written written{{}, name, made.header};
    for (std::size_t k = 0; k < parts.size(); ++k)
      written.parts.push_back({projections[k].material.terms[0], parts[k].tangent, parts[k].given});
    made.text = program.write(written);
    return made;
  }

  // Returns the export with the nearest writable target of the program. Refused targets are recorded with
  // the reason.
  std::optional<Exported> best(bool naive) {
    std::optional<Exported> best;
    refused.clear();
    for (const TargetRules& rules : program.targets) {
      try {
        Exported tried = with(rules, naive);
        if (!best || is_nearer(tried.loss, best->loss)) best = std::move(tried);
      } catch (const InputError& error) {
        refused.push_back({std::string(info(rules.target).name), error.what()});
      }
      if (best && best->loss.none_found()) break;
    }
    return best;
  }

 private:
  // If the program mixes shaders, the lobes of several parts share the weight that the diffuse parts leave.
  TargetRules within_shares(TargetRules rules, const Wanted& part) const {
    if (!rules.mixes || parts.size() < 2) return rules;
    double diffuse = 0, lobes = 0;
    for (const Wanted& each : parts)
      diffuse += largest_weight(each, Role::diffuse), lobes += largest_weight(each, Role::specular);
    if (diffuse + lobes > 1 && diffuse < 1)
      rules.copy.most_lobe = (1 - diffuse) * largest_weight(part, Role::specular) / lobes;
    return rules;
  }
  static double largest_weight(const Wanted& part, Role role) {
    double most = 0;
    for (const Term& term : part.material.terms)
      if (const int k = info(term.form).weight_index(role); k >= 0)
        for (const std::vector<double>& w : term.weights) most = std::max(most, w[std::size_t(k)]);
    return most;
  }
  static Holds holds(const TargetRules& rules) {
    const ReflectanceInfo& form = info(rules.target);
    const bool coloured_fresnel = form.weight_index(Role::f0) >= 0 || form.weight_index(Role::specular) < 0 ||
                                  std::ranges::any_of(rules.copy.coloured, is_fresnel);
    return {!rules.copy.grey_lobe, coloured_fresnel};
  }

  std::vector<std::string> header_of(const Exported& made) const {
    std::vector<std::string> header{
        "Written by brdf " BRDF_VERSION ": " + io::provenance().command,
        "for " + std::string(program.title) + ", as " + made.target + ": " + in_words(made)};
    for (const std::string& sentence : made.not_held) header.push_back("not carried: " + sentence);
    const std::string count = std::to_string(made.words.size());
    for (std::size_t k = 0; k < made.words.size(); ++k)
      header.push_back(
          std::string(made.by_channel ? "in brdf, by channel, without the spectra of the program"
                                      : "the same values in brdf") +
          (made.words.size() > 1 ? ", term " + std::to_string(k + 1) + " of a sum of " + count : "") +
          ": brdf eval " + made.words[k]);
    if (!made.loss.none_found()) header.push_back(worst_place(made));
    header.insert(header.end(), program.conventions.begin(), program.conventions.end());
    return header;
  }
  // Describes the pair of the largest difference. If a single command reproduces the program's values, the
  // text includes the command that prints f at this pair.
  static std::string worst_place(const Exported& made) {
    const Largest& l = made.loss.largest;
    std::string pair;
    for (const double angle : {l.theta_i, l.phi_i, l.theta_o, l.phi_o})
      pair += (pair.empty() ? "" : ",") + io::to_text(angle);
    const std::string said = "the largest difference: " + l.channel + " is " +
                             io::short_number(l.carried, 6) + " instead of " + io::short_number(l.wanted, 6) +
                             " /sr at theta_i,phi_i,theta_o,phi_o " + pair;
    if (made.words.size() > 1 || made.by_channel) return said;
    return said + ": printf 'theta_i,phi_i,theta_o,phi_o\\n" + pair + "\\n' | brdf eval " + made.words[0] +
           " -";
  }
};

}  // namespace

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
  if (tangent != Angle{} && form.anisotropic())  // no other form has this parameter
    text += " --set " + std::string(fit::kTangentInfo.name) + "=" +
            io::to_text(std::remainder(tangent.degrees(), 360));
  return text;
}

std::string in_words(const Exported& made) {
  if (made.is_same) return "exact";
  if (made.loss.none_found()) return none_found_in_words(made.loss);
  if (!made.refitted) return "copied: " + in_words(made.loss);
  const std::string words = "refitted: " + in_words(made.loss);
  // If the program cannot hold the copied parameters, they have no loss of their own.
  return made.copied.rms == made.loss.rms ? words : words + "; copied parameters: " + in_words(made.copied);
}

const Program& gltf() {
  static const Program program{
      .name = "gltf",
      .title = "glTF 2.0, according to the specification",
      .most = 1,
      .most_lobe = 1,
      .adds = false,
      .run_here = true,
      .conventions =
          {"roughness is the square root of alpha (of the narrower axis); colours are linear",
           "programs may compute more: three.js scales the lobe by a multiple-scattering term (--to three)"},
      .targets = {{gltf_metallic_roughness{}, {.coloured = {Role::tint}}}},
      .write = write_gltf};
  return program;
}

std::span<const Program> programs() {
  const CopyRules kGrey{.grey_lobe = true};
  static const std::vector<Program> all{
      {.name = "blender",
       .title = "Blender 4.3 and later, Cycles",
       .most = kAnyWeight,
       .most_lobe = 1,
       .adds = true,
       .run_here = false,
       .conventions = {"Roughness is the square root of alpha; colours are linear; distribution GGX, not "
                       "Multiscatter GGX"},
       .targets = {{blender_metallic{}, kGrey, true}},
       .write = write_blender},
      {.name = "blender-3.4",
       .title = "Blender 3.4, Cycles",
       .most = kAnyWeight,
       .most_lobe = kAnyWeight,
       .adds = true,
       .run_here = true,
       .conventions = {"Roughness is the square root of alpha; colours are linear; distribution GGX, not "
                       "Multiscatter GGX"},
       .targets = {{blender_glossy{}},
                   {blender_principled{}, {}, false, false, {index_up_to(blender_principled{}, 1.788)}}},
       .write = write_blender_3_4},
      {.name = "mitsuba",
       .title = "Mitsuba 3",
       .most = 1,
       .most_lobe = 1,
       .adds = true,
       .run_here = false,
       .conventions = {"roughconductor: alpha unchanged; principled: roughness is the square root of alpha",
                       "colours are linear; the tangent is the mesh's dp/du"},
       .targets = {{mitsuba_roughconductor{}, {.coloured = {Role::index, Role::extinction}}, true, true},
                   {mitsuba_principled{}}},
       .write = write_mitsuba},
      {.name = "pbrt",
       .title = "pbrt-v4",
       .most = 1,
       .most_lobe = 1,
       .adds = true,
       .run_here = false,
       .conventions = {"roughness is alpha: remaproughness is false; colours are linear and become spectra",
                       "mix: amount is the share of the second material; the tangent is the mesh's dp/du"},
       .targets = {{pbrt_conductor{},
                    {.grey_lobe = true, .coloured = {Role::index, Role::extinction}},
                    true,
                    true,
                    {},
                    shown_by_pbrt}},
       .write = write_pbrt},
      gltf(),
      {.name = "three",
       .title = "three.js 0.187, as glTF",
       .most = 1,
       .most_lobe = 1,
       .adds = false,
       .run_here = true,
       .conventions = {"roughness is the square root of alpha (of the narrower axis); colours are linear",
                       "for lights, not for an environment map"},
       .targets = {{three_physical{}, {.coloured = {Role::diffuse}}}},
       .write = write_gltf},
      {.name = "materialx",
       .title = "MaterialX 1.39.6, its generated shaders",
       .most = 1,
       .most_lobe = 1,
       .adds = true,
       .run_here = false,
       .conventions =
           {"roughness of the lobe is alpha, of the diffuse part the slopes' standard deviation; colours are "
            "linear (lin_rec709)",
            "the tangent is Tworld, rotated about Nworld"},
       .targets = {{materialx_schlick{}, {.grey_lobe = true, .coloured = {Role::f0}}}},
       .write = write_materialx},
      surface_node("open_pbr_surface", open_pbr_surface{}, write_open_pbr_surface),
      surface_node("standard_surface", standard_surface{}, write_standard_surface),
      surface_node("gltf_pbr", materialx_gltf_pbr{}, write_gltf_pbr),
      with_both_ends(surface_node("UsdPreviewSurface", usd_preview_surface{}, write_usd_preview_surface)),
      surface_node("disney_principled", disney_principled{}, write_disney_principled),
      {.name = "osl",
       .title = "OSL, as its testrender shades",
       .most = kAnyWeight,
       .most_lobe = kAnyWeight,
       .adds = true,
       .run_here = false,
       .conventions = {"widths are alphas; colours are linear; the tangent is dPdu, rotated about N"},
       .targets = {{osl_microfacet{}}, {osl_ward{}}, {osl_phong{}}, {osl_oren_nayar{}}},
       .write = write_osl},
      {.name = "radiance",
       .title = "Radiance (normal.c 2.83, aniso.c 2.67), light that comes directly from sources",
       .most = 1,
       .most_lobe = 1,
       .adds = true,
       .run_here = false,
       .conventions =
           {"roughness is alpha; colours are linear, as Radiance's red, green and blue",
            "on a flat surface Radiance adds omega/(4 pi) of a source of solid angle omega to alpha^2",
            "sampled rays (ambient light, other surfaces) have weights of their own",
            "plastic2, metal2: the tangent is the x axis of the scene for a surface in its xy plane"},
       .targets = {{radiance_wgmd{}, {}, true, true}},
       .write = write_radiance}};
  return all;
}

const Program* find_program(std::string_view name) {
  for (const Program& program : programs())
    if (program.name == name) return &program;
  return nullptr;
}

Limits limits_of(const Program& program) {
  Limits limits{program.name, program.most, program.most_lobe, program.adds};
  for (const TargetRules& rules : program.targets) limits.targets.push_back(rules.target);
  return limits;
}

Exported export_to(const Program& program, const Material& material, const std::string& name, bool naive) {
  try {
    io::require_not_below_zero(material, "--to " + std::string(program.name));
  } catch (const InputError& error) {
    throw Refused(error.what());
  }
  const std::vector<Wanted> parts = wanted(material, limits_of(program));
  Attempt attempt{program, parts, Comparison(sum_of(parts)), name};
  std::optional<Exported> copy = attempt.best(true);
  if (copy && (naive || copy->loss.none_found())) return std::move(*copy);
  if (copy) attempt.copied = copy->loss;
  std::optional<Exported> best = naive ? std::nullopt : attempt.best(false);
  if (best && copy && !is_better(best->loss, copy->loss)) best.reset();
  if (!best) best = std::move(copy);
  if (!best) throw Refused("--to " + std::string(program.name) + ": " + attempt.refused.back().reason);
  best->refused = std::move(attempt.refused);
  return std::move(*best);
}

}  // namespace brdf::interop
