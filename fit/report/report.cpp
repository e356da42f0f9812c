#include "fit/report/report.h"

#include <cmath>
#include <iomanip>
#include <ostream>

#include "fit/assess/reported.h"
#include "io/material_json.h"
#include "io/numbers.h"
#include "io/provenance.h"

namespace brdf::fit {
namespace {

using io::Json;

// Infinite or undefined numbers have no JSON.
Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json estimate_json(const Estimate& e) {
  Json j{{"status", name_of(e.status)}};
  // An unidentified value is no value: the material needs one, a reader must not.
  j["value"] = e.status == Status::unidentified ? Json(nullptr) : number(e.value);
  if (e.status == Status::free) {
    j["low"] = number(e.low);
    j["high"] = number(e.high);
    j["standard_error"] = number(e.standard_error);
  }
  return j;
}

Json intervals_json(const FormFit& fit) {
  Json j = Json::object();
  for (const Estimate& e : fit.estimates) {
    if (e.channel.empty())
      j[e.name] = estimate_json(e);
    else
      j[e.name][e.channel] = estimate_json(e);
  }
  return j;
}

Json correlations_json(const Correlations& c) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < c.names.size(); ++i) {
    Json row = Json::array();
    for (std::size_t k = 0; k < c.names.size(); ++k) row.push_back(c.matrix(i, k));
    rows.push_back(row);
  }
  return {{"parameters", c.names}, {"matrix", rows}};
}

Json metrics_json(const Metrics& m) {
  return {{"log", number(m.log)},
          {"cosine_l2", number(m.cosine_l2)},
          {"cube_root", number(m.cube_root)},
          {"log_relative", number(m.log_relative)}};
}

Json statistics_json(const FormFit& fit) {
  Json j{{"form", fit.form},
         {"verdict", name_of(fit.verdict)},
         {"findings", fit.findings},
         {"median_relative_error", number(fit.median_relative_error)}};
  if (fit.cross_validated_error) {
    j["cross_validated_error"] = number(*fit.cross_validated_error);
    j["cross_validated_standard_error"] = number(*fit.cross_validated_standard_error);
  }
  j["bic"] = number(fit.bic);
  j["parameters"] = fit.parameters;
  j["metrics"] = metrics_json(fit.metrics);
  j["intervals"] = intervals_json(fit);
  return j;
}

Json samples_json(const FitResult& result, const io::SampleTable& table, const FitOptions& options) {
  Json j{{"file", table.source},
         {"format", table.format},
         {"rows", table.rows()},
         {"fitted_rows", result.rows},
         {"channels", result.channels},
         {"max_theta", options.max_theta},
         {"beyond_max_theta", result.beyond_max_theta},
         {"outside_domain", result.outside_domain},
         {"skipped", table.skipped}};
  j["noise_floor"] = result.noise_floor ? Json(*result.noise_floor) : Json(nullptr);
  return j;
}

std::string error_text(double error) {
  return std::isfinite(error) ? io::percent(error) : "-";
}

// The value with as many digits as its interval supports.
std::string estimate_text(const Estimate& e) {
  const std::string name = label(e);
  switch (e.status) {
    case Status::unidentified:
      return name + " not identified";
    case Status::fixed:
      return name + " " + io::short_number(e.value) + " (fixed)";
    case Status::at_bound:
      return name + " " + io::short_number(e.value) + " (at its bound)";
    default:
      return name + " " + io::short_number(e.value) + "  (" + io::short_number(e.low) + " to " +
             io::short_number(e.high) + ")";
  }
}

}  // namespace

Json to_json(const FitResult& result, const io::SampleTable& table, const FitOptions& options) {
  Json ranking = Json::array();
  for (const FormFit& fit : result.ranking) {
    Json j = statistics_json(fit);
    j["material"] = fit.solved() ? io::to_json(fit.material) : Json(nullptr);
    Json minima = Json::array();
    for (const MinimumReport& m : fit.minima)
      minima.push_back(
          {{"cost", number(m.cost)}, {"starts", m.basin}, {"material", io::to_json(m.material)}});
    j["minima"] = minima;
    j["correlations"] = correlations_json(fit.correlations);
    j["condition"] = number(fit.condition);
    j["solver"] = {{"message", fit.solver_message},
                   {"starts", fit.starts},
                   {"iterations", fit.iterations},
                   {"passes", fit.passes},
                   {"loss_scale", fit.loss_scale}};
    ranking.push_back(std::move(j));
  }
  Json j = io::to_json(io::provenance(options.seed));
  j["metric"] = name_of(options.metric);
  j["samples"] = samples_json(result, table, options);
  j["interrupted"] = result.interrupted;
  j["recommended"] = result.ranking.empty() ? Json(nullptr) : Json(result.ranking[result.recommended].form);
  j["ranking"] = std::move(ranking);
  return j;
}

Json material_block(const FormFit& fit, const FitResult& result, const io::SampleTable& table,
                    const FitOptions& options) {
  Json j = io::to_json(io::provenance(options.seed));
  j["metric"] = name_of(options.metric);
  j["samples"] = samples_json(result, table, options);
  j.update(statistics_json(fit));
  return j;
}

void print(std::ostream& out, const FitResult& result, const io::SampleTable& table,
           const FitOptions& options) {
  out << table.source << ": " << result.rows << " rows, " << result.channels.size() << " channel"
      << (result.channels.size() == 1 ? "" : "s") << ", residual " << name_of(options.metric) << '\n';
  if (result.beyond_max_theta)
    out << "  " << result.beyond_max_theta << " rows beyond " << options.max_theta
        << " degrees left out (--max-theta)\n";
  if (result.outside_domain)
    out << "  " << result.outside_domain << " rows left out: negative values without a residual\n";
  if (result.noise_floor)
    out << "  values scatter about their neighbours by " << io::percent(*result.noise_floor) << '\n';
  if (result.interrupted) out << "  interrupted: this is what was reached\n";
  out << "  " << std::left << std::setw(28) << "form" << std::setw(18) << "verdict" << std::setw(14)
      << "median error" << std::setw(14) << "left out"
      << "parameters\n";
  for (const FormFit& fit : result.ranking)
    out << "  " << std::setw(28) << fit.form << std::setw(18) << name_of(fit.verdict) << std::setw(14)
        << error_text(fit.median_relative_error) << std::setw(14)
        << (fit.cross_validated_error ? io::percent(*fit.cross_validated_error) : "-") << fit.parameters
        << '\n';
  if (result.ranking.empty()) return;
  const FormFit& best = result.ranking.front();
  out << best.form << ", " << name_of(best.verdict) << '\n';
  for (const std::string& finding : best.findings) out << "  " << finding << '\n';
  for (const Estimate& e : best.estimates) out << "  " << estimate_text(e) << '\n';
  const FormFit& simple = result.ranking[result.recommended];
  if (&simple != &best)
    out << "recommended: " << simple.form << ", which is simpler and as good within the noise\n";
}

}  // namespace brdf::fit
