#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>

#include "brdf/integrals.h"
#include "cli/options.h"
#include "cli/verbs.h"
#include "fit/assess/derived.h"
#include "io/error.h"
#include "io/json.h"
#include "io/material_json.h"
#include "io/numbers.h"
#include "io/provenance.h"
#include "io/text.h"

namespace brdf::cli {
namespace {

constexpr double kDifferenceTolerance = 1e-8;  // of integrals whose differences are taken

struct Options {
  MaterialChoice material;
  std::vector<double> theta;
  double phi = 0, tolerance = 1e-6;
  std::string fixed = "i", rule = "automatic";
  bool json = false;
};

struct Row {
  double theta;
  std::string channel;
  AlbedoResult result;
  std::optional<fit::Extent> interval;  // of the fit that the material came from
};

AlbedoOptions checked(const Options& o) {
  AlbedoOptions options;
  if (!(o.tolerance >= 1e-14 && o.tolerance <= 1))
    throw InputError("--tolerance " + io::to_text(o.tolerance) + ": must be between 1e-14 and 1");
  if (!std::isfinite(o.phi)) throw InputError("--phi: must be finite");
  for (const double theta : o.theta)
    if (!(theta >= 0 && theta <= 90))
      throw InputError("--theta " + io::to_text(theta) + ": must be between 0 and 90 degrees");
  options.tolerance = o.tolerance;
  options.fixed = o.fixed == "o" ? Fixed::viewer : Fixed::light;
  const std::optional<Rule> rule = find_named<Rule>(o.rule);
  if (!rule) throw InputError("--rule '" + o.rule + "': must be one of " + known_names<Rule>());
  options.rule = *rule;
  return options;
}

io::Json row_json(const Row& row, const Options& o) {
  io::Json json;
  json["theta"] = row.theta;
  json["phi"] = o.phi;
  json["fixed"] = o.fixed;
  json["channel"] = row.channel;
  json["value"] = row.result.value;
  json["error_bound"] = row.result.error_bound;
  json["evaluations"] = row.result.evaluations;
  json["converged"] = row.result.converged;
  json["rule"] = name_of(row.result.rule);
  if (row.interval) {
    json["low"] = row.interval->low;
    json["high"] = row.interval->high;
  }
  return json;
}

void print(const Row& row) {
  std::cout << std::setw(8) << row.theta << "  " << std::left << std::setw(10) << row.channel << std::right
            << std::setprecision(15) << std::setw(20) << row.result.value << std::setprecision(2) << "  +- "
            << std::left << std::setw(9) << row.result.error_bound << std::right << std::setw(9)
            << row.result.evaluations << "  " << name_of(row.result.rule)
            << (row.result.converged ? "" : "  NOT CONVERGED");
  if (row.interval)
    std::cout << "  " << io::short_number(row.interval->low, 5) << " to "
              << io::short_number(row.interval->high, 5);
  std::cout << std::setprecision(6) << '\n';
}

// 95 % intervals of the albedo from the fit that the material came from: the delta method on its parameters.
std::vector<std::optional<fit::Extent>> fitted_intervals(const io::MaterialFile& file, double theta,
                                                         const Options& o, AlbedoOptions options,
                                                         const std::vector<AlbedoResult>& results) {
  std::vector<std::optional<fit::Extent>> out(results.size());
  const auto covariance = fit::covariance_of(file.fit);
  if (!covariance) return out;
  options.tolerance = std::min(options.tolerance, kDifferenceTolerance);
  std::vector<double> values;
  for (const AlbedoResult& r : results) values.push_back(r.value);
  const auto albedo = [&](const Material& m) {
    std::vector<double> all;
    for (const AlbedoResult& r : directional_albedo(m, degrees(theta), degrees(o.phi), options))
      all.push_back(r.value);
    return all;
  };
  if (const auto found = fit::intervals(file.material, *covariance, values, albedo))
    std::copy(found->begin(), found->end(), out.begin());
  return out;
}

Exit run(const Options& o) {
  const AlbedoOptions options = checked(o);
  const io::MaterialFile file = choose_material_file(o.material);
  const Material& material = file.material;
  std::vector<Row> rows;
  bool converged = true;
  for (const double theta : o.theta) {
    const auto results = directional_albedo(material, degrees(theta), degrees(o.phi), options);
    const auto intervals = fitted_intervals(file, theta, o, options, results);
    for (std::size_t c = 0; c < results.size(); ++c) {
      rows.push_back({theta, material.channels[c], results[c], intervals[c]});
      converged &= results[c].converged;
    }
  }
  if (o.json) {
    io::Json json;
    json["form"] = material.terms.size() == 1 ? info(material.terms[0].form).name : std::string_view("sum");
    json["results"] = io::Json::array();
    for (const Row& row : rows) json["results"].push_back(row_json(row, o));
    json["provenance"] = io::to_json(io::provenance());
    std::cout << io::to_text(json);
  } else {
    const bool fitted =
        std::any_of(rows.begin(), rows.end(), [](const Row& r) { return r.interval.has_value(); });
    std::cout << "   theta  channel                  albedo     bound    evaluations  rule"
              << (fitted ? "  95 % interval of the fit" : "") << '\n';
    for (const Row& row : rows) print(row);
  }
  return converged ? Exit::good : Exit::failed;
}

}  // namespace

void add_albedo(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("albedo", "Directional albedo of a material, with an error bound");
  add_material_options(*verb, options->material);
  verb->add_option("--theta", options->theta,
                   "Polar angles of the fixed direction, degrees, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->required();
  verb->add_option("--phi", options->phi, "Azimuth of the fixed direction, degrees")->capture_default_str();
  verb->add_option("--fixed", options->fixed, "Which direction is fixed: i (light) or o (viewer)")
      ->check(CLI::IsMember({"i", "o"}))
      ->capture_default_str();
  verb->add_option("--tolerance", options->tolerance, "Relative error aimed at")->capture_default_str();
  verb->add_option("--rule", options->rule, "automatic, pole, slope or adaptive")->capture_default_str();
  verb->add_flag("--json", options->json, "JSON on stdout");
  verb->footer(
      "Of a material that `fit` has written, the 95 % interval of the fit stands beside it (not with "
      "--set).\n"
      "Exit code 1 where an integral did not converge. At 90 degrees the value is that at a cosine of\n"
      "1e-12: of a form that grows without limit towards grazing that cosine alone decides it.\n"
      "Examples: brdf albedo --form cook_torrance --set kd=0 --set ks=1 --set f0=1 --set alpha=1 --theta "
      "0,60\n"
      "          brdf albedo --material fitted.json --theta 45 --phi 30 --fixed o --rule adaptive "
      "--tolerance "
      "1e-8 --json");
  on_run(*verb, [options] { return run(*options); });
}

}  // namespace brdf::cli
