#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "cli/options/shader_options.h"
#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "fit/assess/derived.h"
#include "fit/report/budget.h"
#include "io/columns/foreign_json.h"
#include "io/csv/csv.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/provenance.h"
#include "io/files/standard_input.h"
#include "io/files/text.h"
#include "io/formats/read.h"
#include "io/samples/degrees.h"
#include "io/samples/samples.h"

namespace brdf::cli {
namespace {

struct EvalCall {
  MaterialOptions material;
  std::string first, directions, output;  // `first`: the first of two positional arguments, or the only one
  bool cosine = false, sigma = false, in_float = false;
};

// A pipe can be read only once and is not looked into.
bool is_json_file(const std::string& file) {
  return std::filesystem::is_regular_file(file) && io::may_be_material(io::read_content(file));
}

// Sorts the positional arguments: MATERIAL and DIRECTIONS, or DIRECTIONS alone.
void settle_arguments(EvalCall& o) {
  if (o.first.empty()) throw InputError("DIRECTIONS is required (see brdf eval --help)");
  if (o.directions.empty()) {
    o.directions = o.first;
    return;
  }
  if (!o.material.material.empty())
    throw InputError("MATERIAL " + io::input_name(o.first) + " and --material " + o.material.material +
                     " are both given: give one of them");
  if (is_json_file(o.directions) && !is_json_file(o.first))
    throw InputError(io::input_name(o.first) + ", " + o.directions +
                     ": the material's JSON comes first, then the directions: brdf eval MATERIAL DIRECTIONS");
  o.material.material = o.first;
}

// Multiplies the measured values by the cosine of the angle of incidence, to match the columns of computed
// values.
void multiply_by_cosine(io::SampleTable& table) {
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double cosine = io::cos_degrees(table.theta_i[k]);
    for (auto& values : table.values) values[k] *= cosine;
    for (auto& sigma : table.sigma)
      if (!sigma.empty()) sigma[k] *= cosine;
  }
}

// Writes the values of every channel and row one after another, channel by channel.
std::vector<double> values_of(const Material& material, const Directions<double>& d, bool cosine) {
  const std::size_t channels = material.channels.size();
  std::vector<double> out(channels * d.count), values(channels);
  for (std::size_t k = 0; k < d.count; ++k) {
    if (cosine)
      eval_cos(material, d.wi(k), d.wo(k), values);
    else
      eval(material, d.wi(k), d.wo(k), values);
    for (std::size_t c = 0; c < channels; ++c) out[c * d.count + k] = values[c];
  }
  return out;
}

// The same for a shader, as single precision computes them.
std::vector<double> float_values_of(const Material& material, const Directions<double>& d) {
  std::vector<double> out;
  for (std::size_t c = 0; c < material.channels.size(); ++c)
    for (std::size_t k = 0; k < d.count; ++k) {
      const Vec3<double> wi = d.wi(k), wo = d.wo(k);
      const Vec3<float> i{float(wi.x), float(wi.y), float(wi.z)}, o{float(wo.x), float(wo.y), float(wo.z)};
      float value;
      eval_batch(material.terms.front(), c, one_pair(i, o), &value);
      out.push_back(double(value));
    }
  return out;
}

// Adds the material's values as columns f or f_<channel>.
void add_values(io::SampleTable& table, const Material& material, bool cosine, bool in_float) {
  if (cosine) multiply_by_cosine(table);
  const std::size_t first = table.channels.size(), count = material.channels.size();
  for (const std::string& channel : material.channels) {
    const std::string name = count == 1 ? "f" : "f_" + channel;
    if (std::ranges::find(table.channels, name) != table.channels.end())
      throw InputError(table.source + ": has a column '" + name + "' already");
    table.channels.push_back(name);
    table.values.emplace_back(table.rows());
  }
  table.sigma.resize(table.channels.size());
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const std::vector<double> values =
      in_float ? float_values_of(material, arrays.view()) : values_of(material, arrays.view(), cosine);
  for (std::size_t c = 0; c < count; ++c)
    std::copy_n(&values[c * table.rows()], table.rows(), table.values[first + c].begin());
}

// Adds the standard uncertainties of the values from column `first` on, which follow from the covariance of
// the material's fit.
void add_sigma(io::SampleTable& table, const io::MaterialFile& file, std::size_t first, bool cosine) {
  const fit::Knowledge known = fit::knowledge_of(file.fit);
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const auto value = [&](const Material& m) { return values_of(m, arrays.view(), cosine); };
  const std::vector<double> values = value(file.material);
  const auto found =
      known.covariance ? fit::combined(file.material, *known.covariance, values, value) : std::nullopt;
  if (!found)
    throw InputError(
        "--sigma-columns: the material holds no covariance of its parameters: use a material that "
        "brdf fit -o has written");
  for (std::size_t c = 0; c < file.material.channels.size(); ++c)
    for (std::size_t k = 0; k < table.rows(); ++k)
      table.sigma[first + c].push_back((*found)[c * table.rows() + k].standard_uncertainty);
  table.add_comment("standard uncertainties",
                    known.has_budget() ? "with the budget of the fit" : fit::kScatterOnly);
}

// Counts the values from column `first` on that are not finite. Reports the count and the first such row on
// stderr.
std::size_t report_not_finite(const io::SampleTable& table, std::size_t first) {
  std::size_t count = 0, row = 0, column = 0;
  for (std::size_t k = 0; k < table.rows(); ++k)
    for (std::size_t c = first; c < table.channels.size(); ++c)
      if (!std::isfinite(table.values[c][k]) && count++ == 0) row = k, column = c;
  if (count == 0) return 0;
  const std::size_t all = table.rows() * (table.channels.size() - first);
  Warning() << "brdf eval: " << count << " of " << all << (count == 1 ? " values is" : " values are")
            << " no finite number; the first: " << table.where(row) << ": " << table.channels[column] << " "
            << (std::isnan(table.values[column][row]) ? "nan" : io::to_text(table.values[column][row]));
  return count;
}

}  // namespace

void add_eval(CLI::App& app) {
  auto options = std::make_shared<EvalCall>();
  CLI::App* verb = add_verb(app, Purpose::look, "eval", "Evaluate a material at given directions");
  add_material_options(*verb, options->material);
  verb->add_option("MATERIAL", options->first, "A material's JSON file (not with --form or --shader)");
  verb->add_option("DIRECTIONS", options->directions,
                   "CSV with theta_i,phi_i,theta_o,phi_o in degrees (required)");
  verb->add_option("-o,--output", options->output, "CSV to write (default: stdout)");
  auto* cosine = verb->add_flag("--cos", options->cosine, "Print f_r cos_i instead of f_r");
  auto* sigma = verb->add_flag(
      "--sigma-columns", options->sigma,
      "Add the standard uncertainty of every value, from the covariance of the material's fit");
  verb->add_flag("--float", options->in_float, "Print the values of single precision (of --shader)")
      ->needs("--shader")
      ->excludes(cosine)
      ->excludes(sigma);
  verb->footer(
      "Exit code 1 if a value is not a finite number. All rows are written, with such values as nan, inf or "
      "-inf.\n"
      "Examples: brdf eval --form ward --set alpha=0.1 directions.csv -o values.csv\n"
      "          brdf eval fitted.json --cos directions.csv\n"
      "          brdf eval fitted.json --sigma-columns directions.csv\n"
      "          brdf eval --shader ggx.glsl --entry \"ggx(L, V, N, alpha)\" --param alpha=0.01:1:0.3:log "
      "--returns f directions.csv\n"
      "          brdf eval --shader ggx.glsl --float directions.csv");
  on_run(*verb, [options] {
    settle_arguments(*options);
    io::check_targets({{"-o", options->output}});
    const io::MaterialFile file = choose_material_file(options->material, "eval");
    io::SampleTable table = io::read_directions(options->directions);
    const std::size_t measured = table.channels.size();
    add_values(table, file.material, options->cosine, options->in_float);
    if (options->sigma) add_sigma(table, file, measured, options->cosine);
    for (auto& field : io::provenance_fields(io::provenance())) table.metadata.push_back(std::move(field));
    const std::string_view quantity = options->cosine ? "f_r*cos_i" : "f_r";
    if (options->output.empty())
      io::write_samples(std::cout, table, quantity, io::Origin::computed);
    else
      io::write_samples(options->output, table, quantity, io::Origin::computed);
    return report_not_finite(table, measured) == 0 ? Exit::good : Exit::failed;
  });
}

}  // namespace brdf::cli
