#include "cli/steps/stack_scene.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "brdf/angle.h"
#include "io/colour/srgb.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/png.h"
#include "io/material/material_json.h"
#include "render/scene/texture_rule.h"

namespace brdf::cli {
namespace {

using io::Json;
using render::Rule;

constexpr double kDistance = 20;             // of the camera, in half heights of the plane
constexpr std::size_t kPicturePixels = 512;  // least number of pixels on the larger side

bool feeds_albedo(Rule rule) {
  return rule == Rule::albedo || rule == Rule::diffuse;
}

bool feeds_roughness(Rule rule) {
  return rule == Rule::width || rule == Rule::exponent || rule == Rule::slope || rule == Rule::roughness;
}

// Returns the map value for which render::driven() gives `value`.
double undriven(Rule rule, double value) {
  switch (rule) {
    case Rule::diffuse:
      return value / (1 - render::kDielectricReflectance);
    case Rule::width:
    case Rule::slope:
      return std::sqrt(value);
    case Rule::exponent:
      return std::sqrt(std::sqrt(2 / (value + 2)));
    default:
      return value;
  }
}

// Returns the parameter that the map represents, or null if the form has no such parameter.
const ParameterInfo* feeding(std::span<const ParameterInfo> table, const ReflectanceInfo& form,
                             bool (*feeds)(Rule)) {
  const auto found =
      std::ranges::find_if(table, [&](const ParameterInfo& p) { return feeds(render::rule_of(p, form)); });
  return found == table.end() ? nullptr : &*found;
}

using Plane = std::vector<float>;

double middle_of(const Plane& plane) {
  std::vector<double> known;
  for (const float value : plane)
    if (std::isfinite(value)) known.push_back(double(value));
  return io::median(std::move(known));
}

// Returns a picture with the first channel of each pixel first. Pixels without a sample are 0.
std::string picture_of(const texel::Planes& maps, const std::vector<std::vector<double>>& channels) {
  std::vector<unsigned char> pixels;
  for (std::size_t k = 0; k < maps.width * maps.height; ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = channels[std::min(c, channels.size() - 1)][k];
      pixels.push_back(std::isfinite(value) ? (unsigned char)(std::lround(255 * std::clamp(value, 0.0, 1.0)))
                                            : 0);
    }
  return io::png_of_pixels(maps.width, maps.height, pixels);
}

// Writes the files of one scene, and collects the properties that the files cannot hold.
class SceneWriter {
 public:
  SceneWriter(const std::filesystem::path& folder, const texel::Planes& maps, const ReflectanceInfo& form,
              const std::vector<std::string>& channels)
      : folder_(folder), maps_(maps), form_(form), channels_(channels) {}

  void add_albedo() {
    const ParameterInfo* p = feeding(form_.weights, form_, feeds_albedo);
    if (!p) return;
    std::vector<std::vector<double>> values;
    std::size_t above = 0;
    for (const std::string& channel : channels_) {
      std::vector<double>& out = values.emplace_back();
      for (const float value : plane(*p, channel)) {
        const double a = undriven(render::rule_of(*p, form_), double(value));
        above += a > 1;
        out.push_back(io::srgb_encoded(a));
      }
    }
    add("albedo", picture_of(maps_, values), *p);
    if (above > 0)
      lost_ = "; " + io::plural(std::size_t(above), "value") + " above 1 " +
              (above == 1 ? "was cut" : "were cut");
  }

  void add_roughness() {
    const ParameterInfo* p = feeding(form_.shape, form_, feeds_roughness);
    if (!p) return;
    std::vector<double> values;
    for (const float value : plane(*p, ""))
      values.push_back(undriven(render::rule_of(*p, form_), double(value)));
    add("roughness", picture_of(maps_, {values}), *p);
  }

  void add_normal() {
    std::vector<std::vector<double>> values;
    for (const char* name : {"normal.x", "normal.y", "normal.z"}) {
      std::vector<double>& out = values.emplace_back();
      for (const float value : *maps_.find(name)) out.push_back(0.5 + 0.5 * double(value));
    }
    write("normal", picture_of(maps_, values));
  }

  const Plane& plane(const ParameterInfo& p, const std::string& channel) const {
    return *maps_.find_parameter(std::string(p.name), channel);
  }
  const Json& textures() const { return textures_; }
  std::string said() const { return "8 bits of " + io::joined(carried_) + " and the normal" + lost_; }

 private:
  void add(const std::string& slot, const std::string& png, const ParameterInfo& p) {
    write(slot, png);
    carried_.push_back(std::string(p.name));
  }
  void write(const std::string& slot, const std::string& png) {
    io::write_file_atomically(folder_ / (slot + ".png"), png);
    textures_[slot] = slot + ".png";
  }

  const std::filesystem::path& folder_;
  const texel::Planes& maps_;
  const ReflectanceInfo& form_;
  const std::vector<std::string>& channels_;
  Json textures_ = Json::object();
  std::vector<std::string> carried_;
  std::string lost_;
};

// Returns a material with the median of every parameter over the texels.
Material middle_material(const Reflectance& reflectance, const std::vector<std::string>& channels,
                         const SceneWriter& writer) {
  const ReflectanceInfo& form = info(reflectance);
  Material out{channels, {{reflectance, {}, {}}}};
  Term& term = out.terms[0];
  term.shape.resize(1);
  for (const ParameterInfo& p : form.shape) term.shape[0].push_back(middle_of(writer.plane(p, "")));
  for (const std::string& channel : channels) {
    std::vector<double>& weights = term.weights.emplace_back();
    for (const ParameterInfo& p : form.weights) weights.push_back(middle_of(writer.plane(p, channel)));
  }
  return out;
}

// Returns a scene of a plane that fills the picture, with one or several pixels per texel, under one light.
Json scene_of(const texel::Planes& maps, const Material& material, const Json& textures) {
  const std::size_t larger = std::max(maps.width, maps.height),
                    scale = (kPicturePixels + larger - 1) / larger;
  const double fov = 2 * Angle::from_radians(std::atan(1 / kDistance)).degrees();
  return {{"format", "brdf-scene"},
          {"version", 1},
          {"camera",
           {{"position", {0, 0, kDistance}},
            {"target", {0, 0, 0}},
            {"vertical_fov", fov},
            {"width", scale * maps.width},
            {"height", scale * maps.height}}},
          {"lights", {{{"type", "directional"}, {"direction", {1, -1, -1.5}}, {"intensity", kPi}}}},
          {"objects",
           {{{"mesh", "plane"},
             {"material", io::to_json(material)},
             {"textures", textures},
             {"rotation", {90, 0, 0}},
             {"scale", {double(maps.width) / double(maps.height), 1, 1}}}}}};
}

}  // namespace

std::string write_scene(const std::filesystem::path& folder, const texel::Stack& stack,
                        const maps::Settings& settings, const texel::Planes& maps) {
  if (settings.forms.size() != 1) return "no scene: a sum of forms has no texture maps";
  if (settings.options.per_channel) return "no scene: one map cannot hold a shape for each channel";
  if (stack.channels.size() != 1 && stack.channels != std::vector<std::string>{"r", "g", "b"})
    return "no scene: its channels are no colours";
  SceneWriter writer(folder, maps, info(settings.forms[0]), stack.channels);
  writer.add_albedo();
  writer.add_roughness();
  writer.add_normal();
  const Material material = middle_material(settings.forms[0], stack.channels, writer);
  io::write_file_atomically(folder / kSceneFile, io::to_text(scene_of(maps, material, writer.textures())));
  return (folder / kSceneFile).string() + ": " + writer.said() + "; other parameters at their middle values";
}

}  // namespace brdf::cli
