#include "fit/report/report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>

#include "fit/assess/derived.h"
#include "fit/assess/reported.h"
#include "fit/report/plain_words.h"
#include "io/material_json.h"
#include "io/numbers.h"
#include "io/provenance.h"

namespace brdf::fit {
namespace {

using io::Json;

constexpr std::size_t kListedChannels = 8;

// Infinite or undefined numbers have no JSON.
Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json extent_json(const Extent& e) {
  return {{"low", number(e.low)}, {"high", number(e.high)}};
}

Json estimate_json(const Estimate& e) {
  Json j{{"status", name_of(e.status)}};
  // An unidentified value is no value: the material needs one, a reader must not.
  j["value"] = e.status == Status::unidentified ? Json(nullptr) : number(e.value);
  if (e.status == Status::free) {
    j["low"] = number(e.low);
    j["high"] = number(e.high);
    j["standard_error"] = number(e.standard_error);
    j["with_lack_of_fit"] = extent_json(e.with_lack_of_fit);
    j["left_out"] = extent_json(e.left_out);
    j["other_metrics"] = extent_json(e.other_metrics);
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
  return {{"parameters", c.names}, {"matrix", rows_json(c.matrix)}};
}

Json metrics_json(const Metrics& m) {
  return {{"log", number(m.log)},
          {"cosine_l2", number(m.cosine_l2)},
          {"cube_root", number(m.cube_root)},
          {"log_relative", number(m.log_relative)}};
}

Json errors_json(const RelativeErrors& e) {
  return {{"median", number(e.median)},
          {"ninth_decile", number(e.ninth_decile)},
          {"light_off_by_two", number(e.off_by_two)}};
}

// The same groups for every form.
Json left_out_json(const RowGroups& groups, const std::vector<double>& values) {
  Json j = Json::array();
  for (std::size_t g = 0; g < values.size(); ++g) {
    const RowGroup& group = groups.groups[g];
    const std::string side = groups.by_viewer ? "_o" : "_i";
    j.push_back({{"theta" + side, group.theta},
                 {"phi" + side, group.phi},
                 {"rows", group.range.rows},
                 {"fold", group.fold},
                 {"value", number(values[g])}});
  }
  return j;
}

Json lack_of_fit_json(const LackOfFit& lack) {
  Json j{{"residual_over_scatter", number(lack.residual_over_scatter.value_or(kUnknown))},
         {"beyond_scatter", lack.beyond_scatter}};
  j["worst"] = nullptr;
  if (const auto& w = lack.worst)
    j["worst"] = {{"theta_h", {w->range.low.theta_h, w->range.high.theta_h}},
                  {"theta_d", {w->range.low.theta_d, w->range.high.theta_d}},
                  {"rows", w->rows},
                  {"measured_over_model", number(w->ratio)},
                  {"share_of_residual", number(w->share)}};
  return j;
}

Json statistics_json(const FormFit& fit) {
  Json j{{"form", fit.form},
         {"verdict", name_of(fit.verdict)},
         {"findings", fit.findings},
         {"weakly_determined", weakly_determined(fit)},
         {"median_relative_error", number(fit.median_relative_error)},
         {"errors", errors_json(fit.errors)},
         {"lack_of_fit", lack_of_fit_json(fit.lack_of_fit)}};
  if (fit.left_out) {
    j["left_out"] = number(fit.left_out->value);
    j["left_out_errors"] = errors_json(fit.left_out->errors);
    j["cross_validated_error"] = number(fit.left_out->errors.median);
    j["cross_validated_standard_error"] = number(fit.left_out->median_standard_error);
  }
  if (fit.prediction_error) j["prediction_error"] = number(*fit.prediction_error);
  if (const auto& a = fit.largest_albedo)
    j["largest_albedo"] = {{"value", number(a->value)}, {"theta", a->theta}, {"channel", a->channel}};
  j["bic"] = number(fit.bic);
  j["parameters"] = fit.parameters;
  j["metrics"] = metrics_json(fit.metrics);
  j["intervals"] = intervals_json(fit);
  return j;
}

// How the residual was chosen; null where it was asked for.
Json choice_json(const MetricChoice& choice) {
  if (choice.asked) return nullptr;
  Json j{{"reason", choice.reason}, {"noise_unevenness", Json::object()}};
  for (const Unevenness& u : choice.unevenness) j["noise_unevenness"][name_of(u.metric)] = number(u.factor);
  return j;
}

Json optional_json(const std::optional<double>& x) {
  return x ? number(*x) : Json(nullptr);
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
  j["fault"] = result.input_fault.empty() ? Json(nullptr) : Json(result.input_fault);
  j["noise_floor"] = optional_json(result.noise_floor);
  j["noise_floors"] = Json::object();
  for (std::size_t c = 0; c < result.channel_noise.size(); ++c)
    j["noise_floors"][result.channels[c]] = optional_json(result.channel_noise[c]);
  return j;
}

std::string error_text(double error) {
  if (!std::isfinite(error)) return "-";
  return error < 10 ? io::percent(error) : std::to_string(std::llround(100 * error)) + " %";
}

std::string extent_text(double low, double high) {
  return io::short_number(low) + " to " + io::short_number(high);
}

// The value with its interval; where the model is wrong, also with what that adds.
std::string estimate_text(const Estimate& e, const std::string& name, bool wrong) {
  switch (e.status) {
    case Status::unidentified:
      return name + " not identified";
    case Status::fixed:
      return name + " " + io::short_number(e.value) + " (fixed)";
    case Status::at_bound:
      return name + " " + io::short_number(e.value) + " (at its bound)";
    default:
      break;
  }
  std::string text = name + " " + io::short_number(e.value) + "  (" + extent_text(e.low, e.high);
  if (wrong && std::isfinite(e.with_lack_of_fit.low))
    text +=
        " statistical, " + extent_text(e.with_lack_of_fit.low, e.with_lack_of_fit.high) + " with lack of fit";
  if (wrong && std::isfinite(e.other_metrics.low))
    text += "; by other metrics " + extent_text(e.other_metrics.low, e.other_metrics.high);
  return text + ")";
}

Json steps_json(const std::vector<Step>& steps) {
  Json j = Json::array();
  for (const Step& s : steps)
    j.push_back({{"added", s.added},
                 {"model", s.model},
                 {"left_out", number(s.left_out)},
                 {"difference", number(s.difference)},
                 {"standard_error", number(s.standard_error)},
                 {"p", s.p},
                 {"tried", s.tried},
                 {"kept", s.kept}});
  return j;
}

void print_ranking(std::ostream& out, const FitResult& result) {
  const auto row = [&out](std::initializer_list<std::pair<int, std::string>> cells) {
    out << "  " << std::left;
    for (const auto& [width, text] : cells) out << std::setw(width) << text;
    out << '\n';
  };
  int widest = 26;  // a form of the catalogue; sums are longer
  for (const FormFit& fit : result.ranking) widest = std::max(widest, int(fit.form.size()));
  row({{widest + 2, "form"},
       {18, "verdict"},
       {11, "left out"},
       {9, "median"},
       {9, "90 %"},
       {10, "off by 2"},
       {11, "x scatter"},
       {0, "parameters"}});
  for (const FormFit& fit : result.ranking) {
    const RelativeErrors& e = fit.left_out ? fit.left_out->errors : fit.errors;
    const double value = fit.left_out ? fit.left_out->value : kUnknown,
                 over = fit.lack_of_fit.residual_over_scatter.value_or(kUnknown);
    row({{widest + 2, fit.form},
         {18, std::string(name_of(fit.verdict))},
         {11, std::isfinite(value) ? io::short_number(value, 3) : "-"},
         {9, error_text(e.median)},
         {9, error_text(e.ninth_decile)},
         {10, error_text(e.off_by_two)},
         {11, std::isfinite(over) ? times_text(over) : "-"},
         {0, std::to_string(fit.parameters)}});
  }
}

}  // namespace

std::string times_text(double factor) {
  return factor < 100 ? io::short_number(factor, 2) : std::to_string(std::llround(factor));
}

std::string in_words(const LackOfFit& lack) {
  std::string text = lack.residual_over_scatter
                         ? "residual " + times_text(*lack.residual_over_scatter) + " times the scatter"
                         : std::string("the scatter is not known");
  if (!lack.beyond_scatter) return text + ": no lack of fit beyond it";
  if (const auto& w = lack.worst)
    text += "; worst at " + to_text(w->range) + " (" + std::to_string(w->rows) + " rows, " +
            io::percent(w->share, 2) + " of what was minimised): the values are in the middle " +
            io::short_number(w->ratio, 3) + " times the model's";
  return text;
}

std::string in_words(const Step& step) {
  const std::string start =
      step.added + ": " + step.model + ", left out " + io::short_number(step.left_out, 3);
  if (step.difference == 0 && step.kept) return start;
  return start + (step.difference < 0 ? ", higher by " : ", lower by ") +
         io::short_number(std::abs(step.difference), 3) + " +- " + io::short_number(step.standard_error, 2) +
         " (p " + io::short_number(step.p, 2) +
         (step.tried > 1 ? ", best of " + std::to_string(step.tried) : std::string()) +
         "): " + (step.kept ? "kept" : "not kept");
}

std::string recommendation(const FitResult& result) {
  const FormFit &best = result.ranking.front(), &chosen = result.ranking[result.recommended];
  if (&chosen == &best) return "";
  return "recommended: " + chosen.form + ", which is " + (usable(best.verdict) ? "simpler" : "usable") +
         " and no worse on the rows left out";
}

std::string scatter_text(const FitResult& result) {
  if (!result.noise_floor)
    return "how much the values scatter is not known: rows are too few, too far apart or too smooth";
  std::string text = "values scatter about their neighbours by " + io::percent(*result.noise_floor);
  if (result.channels.size() == 1 || result.channels.size() > kListedChannels) return text;
  std::string channels;
  for (std::size_t c = 0; c < result.channels.size(); ++c)
    channels += (c ? ", " : "") + result.channels[c] + " " +
                (result.channel_noise[c] ? io::percent(*result.channel_noise[c]) : "not known");
  return text + " (" + channels + ")";
}

Json to_json(const FitResult& result, const io::SampleTable& table, const FitOptions& options) {
  Json ranking = Json::array();
  for (const FormFit& fit : result.ranking) {
    Json j = statistics_json(fit);
    if (fit.left_out) j["left_out_by_incidence"] = left_out_json(result.groups, fit.left_out->by_group);
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
  j["metric"] = name_of(result.metric.metric);
  j["metric_choice"] = choice_json(result.metric);
  j["samples"] = samples_json(result, table, options);
  j["interrupted"] = result.interrupted;
  const bool any = !result.ranking.empty() && usable(result.ranking[result.recommended].verdict);
  j["recommended"] = any ? Json(result.ranking[result.recommended].form) : Json(nullptr);
  if (!result.steps.empty()) j["steps"] = steps_json(result.steps);
  j["ranking"] = std::move(ranking);
  return j;
}

Json material_block(const FormFit& fit, const FitResult& result, const io::SampleTable& table,
                    const FitOptions& options) {
  Json j = io::to_json(io::provenance(options.seed));
  j["metric"] = name_of(result.metric.metric);
  j["metric_choice"] = choice_json(result.metric);
  j["samples"] = samples_json(result, table, options);
  j.update(statistics_json(fit));
  constexpr std::size_t kMostParameters = 100;  // in a file that people read
  if (fit.covariance && fit.covariance->names.size() <= kMostParameters)
    j["covariance"] = to_json(*fit.covariance);
  return j;
}

void print(std::ostream& out, const FitResult& result, const io::SampleTable& table,
           const FitOptions& options) {
  out << table.source << ": " << result.rows << " rows, " << result.channels.size() << " channel"
      << (result.channels.size() == 1 ? "" : "s") << ", residual " << name_of(result.metric.metric) << '\n';
  if (!result.metric.asked) out << "  residual chosen (--metric auto): " << result.metric.reason << '\n';
  if (result.beyond_max_theta)
    out << "  " << result.beyond_max_theta << " rows beyond " << options.max_theta
        << " degrees left out (--max-theta)\n";
  if (result.outside_domain)
    out << "  " << result.outside_domain << " rows left out: negative values without a residual\n";
  if (options.free_scale)
    out << "  values divided by the scale " << io::short_number(table.scale, 6)
        << ", which is unknown: weights are relative\n";
  if (!result.input_fault.empty()) out << "  the samples: " << result.input_fault << '\n';
  out << "  " << scatter_text(result) << '\n';
  if (result.interrupted) out << "  interrupted: this is what was reached\n";
  for (const Step& step : result.steps) out << "  " << in_words(step) << '\n';
  print_ranking(out, result);
  if (result.ranking.empty()) return;
  const FormFit& best = result.ranking.front();
  out << best.form << ", " << name_of(best.verdict) << '\n';
  for (const std::string& finding : best.findings) out << "  " << finding << '\n';
  if (const std::string weak = weakness_text(best); !weak.empty()) out << "  " << weak << '\n';
  if (best.solved()) out << "  " << in_words(best.lack_of_fit) << '\n';
  for (const Estimate& e : best.estimates)
    if (const NamedParameter parameter = named(best, e); !parameter.repeats)
      out << "  " << estimate_text(e, label(parameter.symbol, e.channel), best.lack_of_fit.beyond_scatter)
          << '\n';
  if (const std::string text = recommendation(result); !text.empty()) out << text << '\n';
}

}  // namespace brdf::fit
