#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>

#include "cli/options/options.h"
#include "cli/options/shader_options.h"
#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "interop/gloss_numbers.h"
#include "interop/width_parameters.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/output.h"

namespace brdf::cli {
namespace {

constexpr const char *kGlassIndex = "glass_index", *kGlossGroup = "gloss";

struct ConvertParametersCall {
  MaterialOptions material;
  std::string from, to;
  double index = kGlossGlass, phi = 0;
  bool has_index = false, json = false;
};

// A line of the table.
struct ConvertedRow {
  std::string name, channel, kind, rule, undecided;
  double value = 0;
  std::optional<double> error_bound{}, weight{};
  std::optional<interop::Loss> loss{};
};

bool is_gloss_number(const std::string& name) {
  return name == kGlossGroup ||
         std::ranges::find(interop::kGlossNumbers, name) != interop::kGlossNumbers.end();
}

bool is_asked(const ConvertParametersCall& o, const std::string& name) {
  return o.to.empty() || o.to == name || (o.to == kGlossGroup && name.starts_with("gloss_"));
}

std::vector<ConvertedRow> rows_of(const ConvertParametersCall& o,
                                  const std::vector<interop::GlossNumber>& numbers,
                                  const std::string& before = "") {
  std::vector<ConvertedRow> rows;
  for (const interop::GlossNumber& number : numbers)
    if (is_asked(o, number.name))
      rows.push_back({number.name, number.channel, "integral", before + number.rule, number.undecided,
                      number.value, number.error_bound});
  return rows;
}

ConvertedRow converted(const interop::WidthParameter& from, double value, const interop::WidthParameter& to) {
  const interop::ConvertedWidth found = interop::convert_width(from, value, to);
  ConvertedRow row{std::string(to.name), "", std::string(name_of(found.kind)), found.rule, "", found.value};
  if (found.kind == interop::Conversion::fit) row.weight = found.weight;
  row.loss = found.loss;
  return row;
}

// Converts the width to every parameter that is asked for. If all are asked for, a refusal is a row.
std::vector<ConvertedRow> converted_widths(const ConvertParametersCall& o,
                                           const interop::WidthParameter& from, double value) {
  std::vector<ConvertedRow> rows;
  for (const interop::WidthParameter& to : interop::width_parameters()) {
    if (!is_asked(o, std::string(to.name))) continue;
    try {
      rows.push_back(converted(from, value, to));
    } catch (const InputError& error) {
      if (!o.to.empty() || &to == &from) throw;
      rows.push_back({std::string(to.name), "", "refused", "", error.what()});
    }
  }
  return rows;
}

// Computes the gloss of the GGX lobe that has this width, or that is nearest to a lobe with this width.
std::vector<ConvertedRow> gloss_of_width(const ConvertParametersCall& o, const interop::WidthParameter& from,
                                         double value) {
  if (!o.to.empty() && !is_gloss_number(o.to)) return {};
  const ConvertedRow ggx = converted(from, value, *interop::find_width_parameter("ggx_alpha"));
  const std::string before = "GGX lobe of alpha " + io::short_number(ggx.value, 6) + " (" + ggx.kind +
                             ") with Fresnel's reflectance of index " + io::short_number(o.index, 6) + "; ";
  std::vector<ConvertedRow> rows = rows_of(
      o, interop::gloss_numbers(interop::dielectric_lobe(ggx.value, o.index), degrees(o.phi)), before);
  for (ConvertedRow& row : rows) row.channel.clear(), row.loss = ggx.loss;
  return rows;
}

std::vector<ConvertedRow> from_value(const ConvertParametersCall& o) {
  const std::vector<io::Setting> settings = io::parse_settings({o.from}, "--from");
  const io::Setting& given = settings.front();
  if (given.values.size() != 1) throw InputError("--from " + o.from + ": needs one value");
  if (given.name == kGlassIndex) {
    if (!o.to.empty() && !is_gloss_number(o.to))
      throw InputError("--from glass_index: polished glass has no lobe; --to gloss, haze or distinctness");
    return rows_of(o, interop::gloss_numbers_of_glass(given.values[0]),
                   "Fresnel's reflectance of index " + io::short_number(given.values[0], 6) + "; ");
  }
  const interop::WidthParameter* from = interop::find_width_parameter(given.name);
  if (!from) {
    std::string names;
    for (const interop::WidthParameter& p : interop::width_parameters()) names += std::string(p.name) + ", ";
    throw InputError("--from " + given.name + ": must be one of " + names + kGlassIndex);
  }
  std::vector<ConvertedRow> rows = converted_widths(o, *from, given.values[0]);
  for (ConvertedRow& row : gloss_of_width(o, *from, given.values[0])) rows.push_back(std::move(row));
  return rows;
}

std::vector<ConvertedRow> from_material(const ConvertParametersCall& o) {
  if (!o.to.empty() && !is_gloss_number(o.to))
    throw InputError("--to " + o.to +
                     ": a material is converted to gloss, haze and distinctness; --from "
                     "NAME=VALUE converts a parameter");
  if (o.has_index) throw InputError("--index: the material has its own reflectance; leave the option out");
  return rows_of(o,
                 interop::gloss_numbers(choose_material(o.material, "convert-parameters"), degrees(o.phi)));
}

io::Json to_json(const ConvertedRow& row) {
  io::Json json{{"name", row.name}, {"kind", row.kind}};
  if (!row.channel.empty()) json["channel"] = row.channel;
  json["value"] = row.undecided.empty() ? io::finite_or_null(row.value) : io::Json();
  if (!row.undecided.empty()) json["undecided"] = row.undecided;
  if (row.error_bound && row.undecided.empty()) json["error_bound"] = *row.error_bound;
  if (!row.rule.empty()) json["rule"] = row.rule;
  if (row.weight) json["weight"] = *row.weight;
  if (row.loss) json["loss"] = interop::to_json(*row.loss);
  return json;
}

void print(std::ostream& out, const ConvertedRow& row) {
  out << std::left << std::setw(22) << (row.channel.empty() ? row.name : row.name + " " + row.channel)
      << std::setw(12) << (row.undecided.empty() ? io::short_number(row.value, 6) : "-") << std::setw(10)
      << row.kind;
  if (!row.undecided.empty()) {
    out << row.undecided << '\n';
    return;
  }
  out << row.rule;
  if (row.error_bound) out << "; integrated within " << io::short_number(*row.error_bound, 2);
  if (row.weight) out << "; weight " << io::short_number(*row.weight);
  if (row.loss) out << "; loss: " << interop::in_words(*row.loss);
  out << '\n';
}

Exit run_convert_parameters(const ConvertParametersCall& o) {
  const bool has_material =
      !o.material.material.empty() || !o.material.form.empty() || is_given(o.material.shader);
  if (has_material == !o.from.empty())
    throw InputError("convert-parameters: give either --from NAME=VALUE or a material");
  const std::vector<ConvertedRow> rows = has_material ? from_material(o) : from_value(o);
  if (o.json) {
    io::Json json{{"from", has_material ? io::Json("material") : io::Json(o.from)},
                  {"results", io::Json::array()}};
    for (const ConvertedRow& row : rows) json["results"].push_back(to_json(row));
    json["provenance"] = io::to_json(io::provenance());
    std::cout << io::to_text(json);
  } else {
    PlainText out;
    for (const ConvertedRow& row : rows) print(out, row);
  }
  const auto undecided = [](const ConvertedRow& row) { return !row.undecided.empty(); };
  return !o.to.empty() && std::ranges::any_of(rows, undecided) ? Exit::failed : Exit::good;
}

std::vector<std::string> converted_names() {
  std::vector<std::string> names;
  for (const interop::WidthParameter& parameter : interop::width_parameters())
    names.emplace_back(parameter.name);
  names.emplace_back(kGlossGroup);
  names.insert(names.end(), interop::kGlossNumbers.begin(), interop::kGlossNumbers.end());
  return names;
}

}  // namespace

void add_convert_parameters(CLI::App& app) {
  auto options = std::make_shared<ConvertParametersCall>();
  CLI::App* verb = add_verb(app, Purpose::ship, "convert-parameters",
                            "Convert exponents, widths and roughness into each other and into gloss");
  add_material_options(*verb, options->material);
  add_material_argument(*verb, options->material);
  verb->add_option("--from", options->from,
                   "NAME=VALUE of a lobe (phong_exponent, ggx_alpha, ...), or glass_index=VALUE of polished "
                   "glass");
  verb->add_option("--to", options->to, "Parameter or number to compute (default: all)")
      ->check(CLI::IsMember(converted_names()));
  CLI::Option* index = verb->add_option("--index", options->index,
                                        "Index of refraction of the lobe for gloss, 1 to 5 (black below)")
                           ->capture_default_str();
  verb->add_option("--phi", options->phi, "Azimuth of the plane of incidence for gloss, degrees")
      ->capture_default_str();
  verb->add_flag("--json", options->json, "JSON on stdout");
  verb->footer(
      "Each line states its rule with its source. A conversion without a published rule is a fit: the\n"
      "nearest lobe of the other formula, with the loss. Gloss units are integrated over the apertures of\n"
      "ISO 2813; black glass of index 1.567 has 100 (docs/howto/parameters.md). Exit code 1 if the "
      "requested\n"
      "number is undecided.\n"
      "Examples: brdf convert-parameters --from phong_exponent=50 --to ggx_alpha\n"
      "          brdf convert-parameters --from roughness=0.4 --index 1.5 --json\n"
      "          brdf convert-parameters --from glass_index=1.5 --to gloss\n"
      "          brdf convert-parameters fitted.json --to gloss --phi 90");
  on_run(*verb, [options, index] {
    options->has_index = index->count() > 0;
    return run_convert_parameters(*options);
  });
}

}  // namespace brdf::cli
