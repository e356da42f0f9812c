#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "io/files/provenance.h"
#include "maps/textures/carried.h"

namespace brdf::maps {
namespace {

std::string number(double x) {
  return io::short_number(x, 3);
}

std::string in_words(const TexelLoss& loss, const TexelMaterials& maps) {
  if (loss.largest == 0) return "0 in every texel";
  return "median " + number(loss.median) + ", 95 % of the texels at most " + number(loss.most) +
         ", largest " + number(loss.largest) + " at " + maps.place(loss.where);
}

std::string inputs_of(const Carried& carried, Storage storage) {
  std::vector<std::string> names;
  for (const InputMap& map : carried.inputs)
    if (!map.constant && map.input.storage == storage) names.emplace_back(map.input.name);
  if (carried.has_normals && storage == Storage::linear_byte &&
      carried.inputs[0].input.storage != Storage::real)
    names.emplace_back("normal");
  return io::joined(names);
}

io::Json to_json(const TexelLoss& loss, const TexelMaterials& maps) {
  return {{"median", loss.median},
          {"percentile_95", loss.most},
          {"largest", loss.largest},
          {"x", loss.where % maps.width()},
          {"y", loss.where / maps.width()}};
}

io::Json to_json(const Vec3<double>& n) {
  const double scale = 1 / std::sqrt(dot(n, n));
  return {n.x * scale, n.y * scale, n.z * scale};
}

// Returns the texels with the largest loss, the loss at the 95th percentile and the median loss.
io::Json places_of(const Carried& carried, const TexelMaterials& maps) {
  const TexelLoss loss = summary_of(carried.losses.rms);
  io::Json places = io::Json::array();
  for (const double wanted : {loss.largest, loss.most, loss.median}) {
    const auto found = std::ranges::find(carried.losses.rms, float(wanted));
    const std::size_t texel = std::size_t(found - carried.losses.rms.begin());
    places.push_back(
        {{"x", texel % maps.width()},
         {"y", texel / maps.width()},
         {"rms", wanted},
         {"wanted", "brdf eval " + interop::as_command(maps.at(texel).terms[0])},
         {"carried", "brdf eval " + interop::as_command(carried_material(carried, maps, texel).terms[0])},
         {"wanted_normal", to_json(maps.normal(texel))},
         {"carried_normal", to_json(carried.has_normals ? carried.normals[texel] : maps.normal(texel))}});
  }
  return places;
}

}  // namespace

std::vector<std::string> sentences(const Carried& carried, const TexelMaterials& maps) {
  const std::size_t held = std::size_t(std::ranges::count(carried.held, true));
  std::vector<std::string> out{std::to_string(maps.width()) + " x " + std::to_string(maps.height()) +
                               " texels of " + std::string(info(maps.form()).name) + ", " +
                               std::to_string(held) + " carried as " +
                               std::string(info(carried.target).name)};
  if (carried.without_fit > 0)
    out.push_back(io::plural(carried.without_fit, "texel") + " without a fit: holes");
  if (carried.refused > 0)
    out.push_back(
        io::plural(carried.refused, "texel") +
        " that the program cannot hold: holes; the first: " + carried.reason +
        " (a weight that the fit holds, for example by --fix ks=1, stays within the limits of a program)");
  if (maps.unusable_count() > 0)
    out.push_back(io::plural(maps.unusable_count(), "texel") +
                  " with a verdict that is no usable fit, carried like the others");
  out.push_back("loss of a texel (rms of ln(1 + f cos_i)): " +
                in_words(summary_of(carried.losses.rms), maps));
  out.push_back("the same without the rounding of textures: " +
                in_words(summary_of(carried.losses.of_formula), maps));
  out.push_back("largest relative difference over the same pairs of directions: " +
                in_words(summary_of(carried.losses.largest), maps));
  if (carried.has_normals) {
    const TexelLoss turned = summary_of(carried.losses.turned);
    out.push_back("degrees by which the rounding turns a normal: " + in_words(turned, maps));
  }
  if (const std::string names = inputs_of(carried, Storage::srgb_byte); !names.empty())
    out.push_back("8 bits with the sRGB curve: " + names);
  if (const std::string names = inputs_of(carried, Storage::linear_byte); !names.empty())
    out.push_back("8 bits, linear: " + names);
  if (const std::string names = inputs_of(carried, Storage::real); !names.empty())
    out.push_back("32-bit float, linear: " + names);
  if (carried.index)
    out.push_back("one index of refraction for all texels: " + io::short_number(*carried.index, 6));
  if (carried.has_normals && carried.program->name.starts_with("blender"))
    out.push_back(
        "Cycles darkens the diffuse part if the light is nearer to the horizon of the plane than to that of "
        "a texel's normal, and it bends a normal that mirrors the viewer below the plane; the losses leave "
        "this out");
  out.push_back(
      "textures are read at the nearest texel: between texels a filter mixes parameters, and the "
      "losses do not hold");
  return out;
}

io::Json to_json(const Carried& carried, const TexelMaterials& maps) {
  const TexelLosses& losses = carried.losses;
  io::Json out{{"form", info(maps.form()).name},
               {"width", maps.width()},
               {"height", maps.height()},
               {"held", std::ranges::count(carried.held, true)},
               {"without_fit", carried.without_fit},
               {"refused", carried.refused},
               {"unusable", maps.unusable_count()},
               {"rms", to_json(summary_of(losses.rms), maps)},
               {"rms_of_formula", to_json(summary_of(losses.of_formula), maps)},
               {"largest", to_json(summary_of(losses.largest), maps)},
               {"normal_turned", to_json(summary_of(losses.turned), maps)},
               {"places", places_of(carried, maps)}};
  if (carried.refused > 0) out["reason"] = carried.reason;
  return out;
}

texel::Planes loss_planes(const Carried& carried, const TexelMaterials& maps) {
  texel::Planes out{maps.width(), maps.height(), {"rms", "rms_of_formula", "largest", "normal_turned"}, {}};
  out.values = {carried.losses.rms, carried.losses.of_formula, carried.losses.largest, carried.losses.turned};
  out.attributes = {{"program", std::string(carried.program->title)},
                    {"target", std::string(info(carried.target).name)}};
  for (const auto& field : io::provenance_fields(io::provenance())) out.attributes.push_back(field);
  return out;
}

}  // namespace brdf::maps
