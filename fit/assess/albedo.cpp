#include "fit/assess/albedo.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/derived.h"
#include "io/files/error.h"
#include "io/files/provenance.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

constexpr double kDifferenceTolerance = 1e-8;  // for integrals that are subtracted from each other

io::Json row_json(const AlbedoRow& row, const AlbedoChoice& choice) {
  io::Json json;
  json["theta"] = row.theta;
  json["phi"] = choice.phi;
  json["fixed"] = choice.fixed;
  json["channel"] = row.channel;
  json["value"] = row.result.value;
  json["error_bound"] = row.result.error_bound;
  json["evaluations"] = row.result.evaluations;
  json["converged"] = row.result.converged;
  json["rule"] = name_of(row.result.rule);
  if (row.interval) {
    // An open end is written as null.
    json["low"] = io::finite_or_null(row.interval->low);
    json["high"] = io::finite_or_null(row.interval->high);
    json["interval_contains"] = row.uncertainty ? "scatter and budget" : "scatter";
  }
  if (row.uncertainty) {
    json["standard_uncertainty"] = io::finite_or_null(row.uncertainty->standard_uncertainty);
    json["sources"] = parts_json(*row.uncertainty);
  }
  return json;
}

// Returns the albedo of every channel.
std::vector<double> channel_albedos(const Material& material, Angle theta, Angle phi,
                                    const AlbedoOptions& options) {
  std::vector<double> all;
  for (const AlbedoResult& r : directional_albedo(material, theta, phi, options)) all.push_back(r.value);
  return all;
}

// Sets the 95 % interval and the standard uncertainty of each row from the fit that produced the material.
void add_uncertainty(const io::MaterialFile& file, double theta, double phi, AlbedoOptions options,
                     std::span<AlbedoRow> rows) {
  const Knowledge known = knowledge_of(file.fit);
  if (!known.any()) return;
  options.tolerance = std::min(options.tolerance, kDifferenceTolerance);
  std::vector<double> values;
  for (const AlbedoRow& row : rows) values.push_back(row.result.value);
  const auto albedo = [&](const Material& m) {
    return channel_albedos(m, degrees(theta), degrees(phi), options);
  };
  const auto found = intervals(file.material, known, values, albedo);
  for (std::size_t k = 0; found && k < rows.size(); ++k) rows[k].interval = (*found)[k];
  if (!known.has_budget()) return;
  const auto parts = combined(file.material, *known.covariance, values, albedo);
  for (std::size_t k = 0; parts && k < rows.size(); ++k) rows[k].uncertainty = (*parts)[k];
}

}  // namespace

AlbedoOptions options_of(const AlbedoChoice& o) {
  AlbedoOptions options;
  if (!(o.tolerance >= 1e-14 && o.tolerance <= 1))
    throw InputError("--tolerance " + io::to_text(o.tolerance) + ": must be between 1e-14 and 1");
  if (!std::isfinite(o.phi)) throw InputError("--phi: must be finite");
  for (const double theta : o.theta)
    if (!(theta >= 0 && theta <= 90))
      throw InputError("--theta " + io::to_text(theta) + ": must be between 0 and 90 degrees");
  if (o.fixed != "i" && o.fixed != "o") throw InputError("--fixed: " + o.fixed + ": must be i or o");
  options.tolerance = o.tolerance;
  options.fixed = o.fixed == "o" ? Fixed::viewer : Fixed::light;
  const std::optional<Rule> rule = find_named<Rule>(o.rule);
  if (!rule) throw InputError("--rule '" + o.rule + "': must be one of " + known_names<Rule>());
  options.rule = *rule;
  return options;
}

std::vector<double> albedos_at(const Material& material, std::span<const double> theta) {
  AlbedoOptions options;
  options.tolerance = kDifferenceTolerance;
  std::vector<double> out;
  for (const double angle : theta)
    for (const double albedo : channel_albedos(material, degrees(angle), {}, options)) out.push_back(albedo);
  return out;
}

std::vector<AlbedoRow> albedo_rows(const io::MaterialFile& file, const AlbedoChoice& choice) {
  const AlbedoOptions options = options_of(choice);
  std::vector<AlbedoRow> rows;
  for (const double theta : choice.theta) {
    const auto results = directional_albedo(file.material, degrees(theta), degrees(choice.phi), options);
    const std::size_t first = rows.size();
    for (std::size_t c = 0; c < results.size(); ++c)
      rows.push_back({theta, file.material.channels[c], results[c], std::nullopt, std::nullopt});
    add_uncertainty(file, theta, choice.phi, options, std::span(rows).subspan(first));
  }
  return rows;
}

io::Json to_json(const Material& material, const std::vector<AlbedoRow>& rows, const AlbedoChoice& choice) {
  io::Json json;
  json["form"] = material.terms.size() == 1 ? info(material.terms[0].form).name : std::string_view("sum");
  json["results"] = io::Json::array();
  for (const AlbedoRow& row : rows) json["results"].push_back(row_json(row, choice));
  json["provenance"] = io::to_json(io::provenance());
  return json;
}

}  // namespace brdf::fit
