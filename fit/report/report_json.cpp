#include <cmath>

#include "fit/assess/derived.h"
#include "fit/assess/reported.h"
#include "fit/report/budget.h"
#include "fit/report/plain_words.h"
#include "fit/report/report.h"
#include "io/files/provenance.h"
#include "io/material/material_json.h"

namespace brdf::fit {
namespace {

using io::finite_or_null;
using io::Json;

Json extent_json(const Extent& e) {
  return {{"low", finite_or_null(e.low)}, {"high", finite_or_null(e.high)}};
}

Json estimate_json(const Estimate& e) {
  Json j{{"status", name_of(e.status)}};
  // The value of an unidentifiable parameter is null. The material needs a value, but readers must not use
  // it.
  j["value"] = e.status == Status::unidentified ? Json(nullptr) : finite_or_null(e.value);
  // An open end is null.
  if (e.status != Status::fixed) j.update(extent_json(interval_of(e)));
  if (e.status != Status::fixed) j["deciding_values"] = finite_or_null(e.deciding);
  if (e.status == Status::free)
    j.update(Json{{"standard_error", finite_or_null(e.standard_error)},
                  {"with_lack_of_fit", extent_json(interval_with_lack_of_fit(e))},
                  {"left_out", extent_json(e.left_out)},
                  {"other_metrics", extent_json(e.other_metrics)}});
  if (e.budget)
    j["budget"] = {
        {"standard_uncertainty", finite_or_null(e.budget->standard_uncertainty)},
        {"relative",
         e.value != 0 ? finite_or_null(e.budget->standard_uncertainty / std::abs(e.value)) : Json(nullptr)},
        {"sources", parts_json(*e.budget)}};
  if (std::isfinite(e.bootstrap_error))
    j["bootstrap"] = {{"low", finite_or_null(e.bootstrap.low)},
                      {"high", finite_or_null(e.bootstrap.high)},
                      {"standard_error", finite_or_null(e.bootstrap_error)}};
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
  return {{"parameters", c.names}, {"matrix", rows_json(c.matrix)}};
}

Json metrics_json(const Metrics& m) {
  return {{"log", finite_or_null(m.log)},
          {"cosine_l2", finite_or_null(m.cosine_l2)},
          {"cube_root", finite_or_null(m.cube_root)},
          {"log_relative", finite_or_null(m.log_relative)}};
}

Json errors_json(const RelativeErrors& e) {
  return {{"median", finite_or_null(e.median)},
          {"ninth_decile", finite_or_null(e.ninth_decile)},
          {"light_off_by_two", finite_or_null(e.off_by_two)}};
}

// Returns the held-out values of the groups, which are the same for every form.
Json left_out_json(const RowGroups& groups, const std::vector<double>& values) {
  Json j = Json::array();
  for (std::size_t g = 0; g < values.size(); ++g) {
    const RowGroup& group = groups.groups[g];
    const std::string side = groups.by_viewer ? "_o" : "_i";
    j.push_back({{"theta" + side, group.theta},
                 {"phi" + side, group.phi},
                 {"rows", group.range.rows},
                 {"fold", group.fold},
                 {"value", finite_or_null(values[g])}});
  }
  return j;
}

Json region_json(const WorstRegion& w) {
  return {{"theta_h", {w.range.low.theta_h, w.range.high.theta_h}},
          {"theta_d", {w.range.low.theta_d, w.range.high.theta_d}},
          {"rows", w.rows},
          {"measured_over_model", finite_or_null(w.ratio)},
          {"share_of_residual", finite_or_null(w.share)}};
}

Json lack_of_fit_json(const LackOfFit& lack) {
  Json j{{"residual_over_scatter", finite_or_null(lack.residual_over_scatter.value_or(kUnknown))},
         {"beyond_scatter", lack.beyond_scatter},
         {"judged", lack.judged()}};
  j["worst"] = lack.worst ? region_json(*lack.worst) : Json(nullptr);
  j["others"] = Json::array();
  for (const WorstRegion& w : lack.others) j["others"].push_back(region_json(w));
  return j;
}

// Writes the coefficients by powers of 1000 nm / wavelength.
Json smooth_json(const std::vector<SmoothCurve>& curves) {
  Json j = Json::object();
  for (const SmoothCurve& curve : curves) {
    j[curve.parameter] = {{"scale", curve.scale}, {"coefficients", Json::array()}};
    for (std::size_t k = 0; k < curve.coefficients.size(); ++k)
      j[curve.parameter]["coefficients"].push_back(
          {{"value", finite_or_null(curve.coefficients[k])},
           {"standard_error", finite_or_null(curve.standard_errors[k])}});
  }
  return j;
}

Json conditions_json(const FormFit& fit) {
  Json j = Json::array();
  for (const Condition condition : conditions_of(fit)) {
    const std::string text = sentence_of(condition, fit);
    j.push_back({{"name", name_of(condition)},
                 {"state", name_of(state_of(condition).mark)},
                 {"sentence", text.empty() ? Json(nullptr) : Json(text)}});
  }
  return j;
}

Json albedo_json(const LargestAlbedo& a) {
  return {{"value", finite_or_null(a.value)}, {"theta", a.theta}, {"channel", a.channel}};
}

Json statistics_json(const FormFit& fit) {
  Json j{{"form", fit.form},
         {"verdict", name_of(fit.verdict)},
         {"state", name_of(mark_of(fit))},
         {"sentence", verdict_sentence(fit)},
         {"conditions", conditions_json(fit)},
         {"findings", fit.findings},
         {"weakly_determined", weakly_determined(fit)},
         {"median_relative_error", finite_or_null(fit.median_relative_error)},
         {"errors", errors_json(fit.errors)},
         {"lack_of_fit", lack_of_fit_json(fit.lack_of_fit)}};
  if (fit.left_out) {
    j["left_out"] = finite_or_null(fit.left_out->value);
    j["left_out_errors"] = errors_json(fit.left_out->errors);
    j["cross_validated_error"] = finite_or_null(fit.left_out->errors.median);
    j["cross_validated_standard_error"] = finite_or_null(fit.left_out->median_standard_error);
  }
  if (fit.replicates > 0) j["bootstrap_replicates"] = fit.replicates;
  if (fit.prediction_error) j["prediction_error"] = finite_or_null(*fit.prediction_error);
  if (fit.largest_albedo) j["largest_albedo"] = albedo_json(*fit.largest_albedo);
  if (fit.largest_measured_albedo) j["largest_measured_albedo"] = albedo_json(*fit.largest_measured_albedo);
  if (fit.about.hidden_width) j["hidden_highlight"] = finite_or_null(*fit.about.hidden_width);
  j["bic"] = finite_or_null(fit.bic);
  j["parameters"] = fit.parameters;
  j["metrics"] = metrics_json(fit.metrics);
  j["intervals_by"] = name_of(fit.intervals);
  j["approximate"] = fit.intervals == IntervalsBy::curvature;
  j["intervals"] = intervals_json(fit);
  j["intervals_contain"] = fit.budget ? "scatter and budget" : "scatter";
  if (!fit.smooth.empty()) j["smooth"] = smooth_json(fit.smooth);
  return j;
}

// Returns the reason for the chosen residual; null if the user requested it.
Json choice_json(const MetricChoice& choice) {
  if (choice.asked) return nullptr;
  Json j{{"reason", choice.reason}, {"noise_unevenness", Json::object()}};
  for (const Unevenness& u : choice.unevenness)
    j["noise_unevenness"][name_of(u.metric)] = finite_or_null(u.factor);
  return j;
}

Json optional_json(const std::optional<double>& x) {
  return x ? finite_or_null(*x) : Json(nullptr);
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
  if (options.free_scale) j["scale"] = table.scale;
  const std::vector<const sheet::Finding*> faults = result.sheet.faults();
  j["fault"] = faults.empty() ? Json(nullptr) : Json(faults.front()->statement);
  j["sheet"] = sheet::to_json(result.sheet.findings)["findings"];
  j["read_as"] = table.warnings;
  j["noise_floor"] = optional_json(result.noise_floor);
  j["noise_floors"] = Json::object();
  for (std::size_t c = 0; c < result.channel_noise.size(); ++c)
    j["noise_floors"][result.channels[c]] = optional_json(result.channel_noise[c]);
  return j;
}

// Returns the keys of the run that reports and materials share.
Json run_json(const FitResult& result, const io::SampleTable& table, const FitOptions& options) {
  Json j = io::to_json(io::provenance(options.seed));
  j["metric"] = name_of(result.metric.metric);
  j["metric_choice"] = choice_json(result.metric);
  j["samples"] = samples_json(result, table, options);
  return j;
}

Json steps_json(const std::vector<Step>& steps) {
  Json j = Json::array();
  for (const Step& s : steps)
    j.push_back({{"added", s.added},
                 {"model", s.model},
                 {"left_out", finite_or_null(s.left_out)},
                 {"difference", finite_or_null(s.difference)},
                 {"standard_error", finite_or_null(s.standard_error)},
                 {"p", s.p},
                 {"tried", s.tried},
                 {"kept", s.kept}});
  return j;
}

}  // namespace

Json to_json(const FitResult& result, const io::SampleTable& table, const FitOptions& options) {
  Json ranking = Json::array();
  for (const FormFit& fit : result.ranking) {
    Json j = statistics_json(fit);
    if (fit.left_out) j["left_out_by_incidence"] = left_out_json(result.groups, fit.left_out->by_group);
    j["material"] = fit.solved() ? io::to_json(fit.material) : Json(nullptr);
    Json minima = Json::array();
    for (const MinimumReport& m : fit.minima)
      minima.push_back(
          {{"cost", finite_or_null(m.cost)}, {"starts", m.basin}, {"material", io::to_json(m.material)}});
    j["minima"] = minima;
    j["correlations"] = correlations_json(fit.correlations);
    j["budget"] = budget_json(fit, ranking.empty() ? &table : nullptr);
    j["condition"] = finite_or_null(fit.condition);
    j["solver"] = {{"status", fit.solver_status}, {"message", fit.solver_message},
                   {"starts", fit.starts},        {"iterations", fit.iterations},
                   {"passes", fit.passes},        {"loss_scale", fit.loss_scale}};
    ranking.push_back(std::move(j));
  }
  Json j = run_json(result, table, options);
  j["interrupted"] = result.interrupted;
  const bool any = !result.ranking.empty() && usable(result.ranking[result.recommended].verdict);
  j["recommended"] = any ? Json(result.ranking[result.recommended].form) : Json(nullptr);
  if (!result.steps.empty()) j["steps"] = steps_json(result.steps);
  j["ranking"] = std::move(ranking);
  return j;
}

Json material_block(const FormFit& fit, const FitResult& result, const io::SampleTable& table,
                    const FitOptions& options) {
  Json j = run_json(result, table, options);
  j.update(statistics_json(fit));
  if (result.interrupted) j["interrupted"] = true;
  if (fit.budget) j["budget"] = budget_json(fit, nullptr);
  constexpr std::size_t kMostParameters = 100, kMostEnds = 40;  // limits for a file that people read
  if (fit.covariance && fit.covariance->names.size() <= kMostParameters)
    j["covariance"] = to_json(*fit.covariance);
  if (!fit.ends.empty() && fit.ends.size() <= kMostEnds) j["ends"] = to_json(fit.ends);
  return j;
}

}  // namespace brdf::fit
