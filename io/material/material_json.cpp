#include "io/material/material_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include "io/columns/foreign_json.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/near_name.h"
#include "io/files/output.h"
#include "io/files/text.h"
#include "io/material/shader_forms.h"
#include "io/samples/table_rules.h"

namespace brdf::io {
namespace {

constexpr const char* kFormat = "brdf-material";
constexpr std::string_view kViewFormat = "brdf-view";
constexpr int kVersion = 1;

// Returns the shortest decimal number of degrees that converts back to this angle, or the nearest number if
// there is no such number.
double to_degrees(Angle angle) {
  const double exact = angle.degrees();
  for (int digits = 15; digits <= 17; ++digits) {
    char text[40];
    const auto end =
        std::to_chars(text, text + sizeof text, exact, std::chars_format::scientific, digits - 1).ptr;
    double rounded = exact;
    std::from_chars(text, end, rounded);
    if (degrees(rounded) == angle) return rounded;
  }
  for (const double near : {std::nextafter(exact, -1e9), std::nextafter(exact, 1e9)})
    if (degrees(near) == angle) return near;
  return exact;
}

std::vector<std::string> read_channels(const JsonPlace& place) {
  std::vector<std::string> channels;
  for (std::size_t k = 0; k < place.size(); ++k) channels.push_back(place.at(k).text());
  if (channels.empty()) place.fail("must name at least one channel");
  check_channel_names(channels, place.file() + ": " + place.path());
  return channels;
}

void check_parameter_names(const JsonPlace& place, std::span<const ParameterInfo> table) {
  if (!place.value().is_object()) place.fail("must be an object");
  for (const auto& [key, value] : place.value().items()) {
    if (parameter_index(table, key) >= 0) continue;
    std::string known;
    for (const ParameterInfo& p : table) (known += known.empty() ? "" : ", ") += p.name;
    throw InputError(place.file() + ": " + place.path() + ": unknown key \"" + printable(key, 60) +
                     "\" (known: " + (known.empty() ? "none" : known) + ")");
  }
}

// Reads one value per channel. A single number applies to all channels.
std::vector<double> read_values(const JsonPlace& place, const ParameterInfo& p, std::size_t channels) {
  if (place.value().is_number()) return std::vector(channels, place.number(p.min, p.max));
  if (place.size() != channels)
    place.fail("must have one value per channel (" + std::to_string(channels) + ")");
  std::vector<double> values;
  for (std::size_t c = 0; c < channels; ++c) values.push_back(place.at(c).number(p.min, p.max));
  return values;
}

Term read_term(const JsonPlace& place, const Reflectance& form, std::size_t channels) {
  const ReflectanceInfo& table = info(form);
  Term term{form, {}, std::vector<std::vector<double>>(channels)};
  const JsonPlace weights = place.at("weights");
  check_parameter_names(weights, table.weights);
  for (const ParameterInfo& p : table.weights) {
    const std::vector<double> values = read_values(weights.at(p.name), p, channels);
    for (std::size_t c = 0; c < channels; ++c) term.weights[c].push_back(values[c]);
  }
  static const Json kNone = Json::object();
  const bool has_shape = place.has("shape") || !table.shape.empty();
  const JsonPlace shape = has_shape ? place.at("shape") : JsonPlace(kNone, place.file(), place.path());
  check_parameter_names(shape, table.shape);
  const auto is_array = [&](const ParameterInfo& p) { return shape.at(p.name).value().is_array(); };
  const bool per_channel = std::ranges::any_of(table.shape, is_array);
  term.shape.resize(per_channel ? channels : 1);
  for (const ParameterInfo& p : table.shape) {
    const std::vector<double> values = read_values(shape.at(p.name), p, channels);
    for (std::size_t s = 0; s < term.shape.size(); ++s) term.shape[s].push_back(values[s]);
  }
  if (place.has("tangent_phi")) term.tangent_phi = degrees(place.at("tangent_phi").number(-180, 180));
  return term;
}

void check_header(const JsonPlace& place) {
  if (!place.value().is_object()) place.fail("must be an object");
  if (place.has("format") && place.at("format").text() != kFormat)
    place.at("format").fail(std::string("must be \"") + kFormat + "\"");
  if (place.has("version") && place.at("version").number() != kVersion)
    place.at("version").fail("must be " + std::to_string(kVersion));
}

// Determines the form of a term, or of a material that is a single term.
using FormReader = std::function<Reflectance(const JsonPlace& term)>;

Reflectance read_form(const JsonPlace& term) {
  if (term.has(kShader)) return read_shader(term);
  const JsonPlace place = term.at("form");
  const std::string name = place.text();
  if (const auto form = find_form(name)) return *form;
  std::vector<std::string> known{"sum"};
  for (const Reflectance& form : catalogue()) known.emplace_back(info(form).name);
  place.fail("is not the name of a form (" + known_names_text(name, known) + ")");
}

bool is_sum(const JsonPlace& place) {
  return !place.has(kShader) && place.at("form").value() == "sum";
}

// Reads a term of a sum. The term may omit its channels if they are known already.
Term read_sum_term(const JsonPlace& place, const FormReader& form_of, std::vector<std::string>& channels) {
  check_header(place);
  if (is_sum(place)) place.at("form").fail("must be a form: sums do not nest");
  place.allow_keys({"format", "version", "form", kShader, "channels", "weights", "shape", "tangent_phi"});
  const Reflectance form = form_of(place);
  if (place.has("channels") || channels.empty()) {
    const std::vector<std::string> own = read_channels(place.at("channels"));
    if (channels.empty()) channels = own;
    if (own != channels) place.at("channels").fail("must be the same in every term");
  }
  return read_term(place, form, channels.size());
}

Json values_json(const std::vector<std::vector<double>>& sets, std::size_t parameter) {
  Json values = Json::array();
  for (const auto& set : sets) values.push_back(set[parameter]);
  return values;
}

// Writes a term. Shaders are named as a file in `folder` names them; with absolute paths if `folder` is
// null.
Json term_json(const Term& given, const std::vector<std::string>& channels,
               const std::filesystem::path* folder) {
  const Term term = whole_term(given);
  const ReflectanceInfo& table = info(term.form);
  Json json;
  json["form"] = table.name;
  if (Json shader = shader_json(term.form, folder); !shader.is_null()) json[kShader] = std::move(shader);
  json["channels"] = channels;
  json["weights"] = Json::object();
  for (std::size_t k = 0; k < table.weights.size(); ++k)
    json["weights"][std::string(table.weights[k].name)] = values_json(term.weights, k);
  json["shape"] = Json::object();
  for (std::size_t k = 0; k < table.shape.size(); ++k)
    json["shape"][std::string(table.shape[k].name)] =
        term.shape.size() == 1 ? Json(term.shape[0][k]) : values_json(term.shape, k);
  json["tangent_phi"] = to_degrees(term.tangent_phi);
  return json;
}

MaterialFile read_material_at(const JsonPlace& place, const FormReader& form_of) {
  check_header(place);
  MaterialFile file;
  if (is_sum(place)) {
    place.allow_keys({"format", "version", "name", "source", "form", "channels", "terms", "fit"});
    if (place.has("channels")) file.material.channels = read_channels(place.at("channels"));
    const JsonPlace terms = place.at("terms");
    if (terms.size() == 0) terms.fail("must hold at least one term");
    for (std::size_t k = 0; k < terms.size(); ++k)
      file.material.terms.push_back(read_sum_term(terms.at(k), form_of, file.material.channels));
  } else {
    const Reflectance form = form_of(place);
    place.allow_keys({"format", "version", "name", "source", "form", kShader, "channels", "weights", "shape",
                      "tangent_phi", "fit"});
    file.material.channels = read_channels(place.at("channels"));
    file.material.terms.push_back(read_term(place, form, file.material.channels.size()));
  }
  if (place.has("name")) file.name = place.at("name").text();
  if (place.has("source")) file.source = place.at("source").text();
  if (place.has("fit")) file.fit = place.at("fit").value();
  return file;
}

}  // namespace

MaterialFile material_from_json(const JsonPlace& place) {
  MaterialFile file = read_material_at(place, read_form);
  name_shaders_from_here(file.fit, file.material, place.file());
  return file;
}

namespace {

// A saved state of `brdf view` contains a scene. The material is that of the selected object.
MaterialFile material_of_view(const JsonPlace& view) {
  const JsonPlace objects = view.at("scene").at("objects");
  const auto selected = std::size_t(view.at("selected").number(0, double(objects.size()) - 1));
  return material_from_json(objects.at(selected).at("material"));
}

}  // namespace

MaterialFile read_material_file(const Content& content) {
  const std::size_t first = content.bytes.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && content.bytes[first] != '{' && content.bytes[first] != '[')
    throw InputError(
        content.name +
        ": is not a material, because a material is JSON; use `brdf fit` to make a material from samples");
  const Json json = read_json(content);
  const JsonPlace place(json, content.name);
  if (!json.is_object()) place.fail("must be an object");
  if (place.has("ranking"))
    throw InputError(content.name +
                     ": is the result of a fit (fit --json), not a material; use the file written by fit -o");
  if (!place.has("format"))
    if (const std::string foreign = foreign_json(content); !foreign.empty())
      throw InputError(content.name + ": " + foreign);
  if (place.at("format").value() == kViewFormat) return material_of_view(place);
  place.at("version");
  return material_from_json(place);
}

MaterialFile read_material_file(const std::filesystem::path& path) {
  return read_material_file(read_content(path));
}

Material read_material(const std::filesystem::path& path) {
  return read_material_file(path).material;
}

Material read_material(const Content& content) {
  return read_material_file(content).material;
}

namespace {

Json json_of(const MaterialFile& file, const std::filesystem::path* folder) {
  const Material& material = file.material;
  Json json;
  json["format"] = kFormat;
  json["version"] = kVersion;
  if (!file.name.empty()) json["name"] = file.name;
  if (!file.source.empty()) json["source"] = file.source;
  if (material.terms.size() == 1) {
    json.update(term_json(material.terms[0], material.channels, folder));
  } else {
    json["form"] = "sum";
    json["channels"] = material.channels;
    json["terms"] = Json::array();
    for (const Term& term : material.terms)
      json["terms"].push_back(term_json(term, material.channels, folder));
  }
  if (!file.fit.is_null()) json["fit"] = file.fit;
  return json;
}

}  // namespace

Json to_json(const Material& material) {
  return to_json(MaterialFile{material, nullptr});
}

Json to_json(const MaterialFile& file) {
  return json_of(file, nullptr);
}

void write_material_file(const std::filesystem::path& path, const MaterialFile& file) {
  check_material(file.material, path.string());
  MaterialFile written = file;
  name_shaders_from(path, written.fit, file.material);
  const std::filesystem::path folder = path.parent_path();
  write_file_atomically(path, to_text(json_of(written, &folder)));
}

void check_material(const Material& material, const std::string& where) {
  const Json json = to_json(material);
  std::size_t next = 0;  // the forms are known already: only their parameters are checked
  read_material_at(JsonPlace(json, where), [&](const JsonPlace& term) {
    const Term& known = material.terms.at(next++);
    return term.has(kShader) ? whole_term(known).form : read_form(term);
  });
}

}  // namespace brdf::io
