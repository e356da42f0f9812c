#include "fit/between/difference_report.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "fit/assess/reported.h"
#include "fit/between/shared_report.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"
#include "io/files/text.h"
#include "io/page/html_report.h"

namespace brdf::fit {
namespace {

// Returns a relative difference of a logarithm d: exp(d) - 1.
double as_share(double difference, bool logarithmic) {
  return logarithmic ? std::expm1(difference) : difference;
}

std::string name_in_text(const FittedTable& table) {
  return io::printable(io::file_name(table.name));
}

std::string differences_of(const Difference& d, const std::vector<std::string>& names) {
  std::vector<std::string> texts;
  for (const ParameterDifference& p : d.parameters)
    if (std::ranges::find(names, p.name) != names.end())
      texts.push_back(p.name + " (" +
                      signed_amount_text(as_share(-p.difference, p.logarithmic), p.logarithmic) + " in " +
                      name_in_text(d.fits.tables[1]) + ")");
  return listed(texts);
}

std::string statistic_text(const Difference& d) {
  return "W " + io::short_number(d.statistic, 3) + " for " + io::plural(d.parameters.size(), "parameter") +
         ", p " + probability_text(d.probability);
}

std::string size_text(const Explanation& e) {
  if (e.cause == Cause::scale) return signed_amount_text(e.size, true, 2);
  return (e.cause == Cause::aperture ? ""
          : e.size < 0               ? "-"
                                     : "+") +
         io::short_number(std::abs(e.size), 2) + " degrees";
}

std::string cause_text(const Explanation& e) {
  const std::string in = " in " + io::printable(io::file_name(e.table));
  switch (e.cause) {
    case Cause::scale:
      return "a scale error of " + size_text(e) + in;
    case Cause::zero_theta_i:
      return "a zero error of theta_i of " + size_text(e) + in;
    case Cause::zero_theta_o:
      return "a zero error of theta_o of " + size_text(e) + in;
    default:
      return "an aperture of " + size_text(e) + in;
  }
}

std::string limits_text(Cause cause) {
  switch (cause) {
    case Cause::scale:
      return "a scale error up to " + io::percent(kLargestScale);
    case Cause::zero_theta_i:
      return "a zero error of theta_i up to " + io::short_number(kLargestZeroError) + " degrees";
    case Cause::zero_theta_o:
      return "a zero error of theta_o up to " + io::short_number(kLargestZeroError) + " degrees";
    default:
      return "an aperture up to " + io::short_number(kLargestAperture) + " degrees";
  }
}

io::Json parameter_json(const ParameterDifference& p) {
  return {{"name", p.name},
          {"relative", p.logarithmic},
          {"first", io::finite_or_null(p.first)},
          {"second", io::finite_or_null(p.second)},
          {"difference", io::finite_or_null(p.difference)},
          {"standard_uncertainty", io::finite_or_null(p.uncertainty)}};
}

io::Json direction_json(const DirectionDifference& d, bool judged) {
  io::Json json{{"theta_i", d.at.theta_i},
                {"theta_o", d.at.theta_o},
                {"phi", d.at.phi},
                {"channel", d.channel},
                {"difference", io::finite_or_null(d.difference)},
                {"standard_uncertainty", io::finite_or_null(d.uncertainty)}};
  json["beyond"] = judged ? io::Json(d.beyond) : io::Json(nullptr);
  return json;
}

io::Json explanation_json(const Explanation& e) {
  return {{"cause", name_of(e.cause)},
          {"samples", e.table},
          {"size", e.found ? io::finite_or_null(e.size) : io::Json(nullptr)},
          {"standard_uncertainty", e.stated > 0 ? io::Json(e.stated) : io::Json(nullptr)},
          {"unit", e.cause == Cause::scale ? "relative" : "degree"},
          {"explains", e.explains}};
}

const char* name_of_answer(const Difference& d) {
  if (!d.obstacle.empty() || !d.doubt.empty()) return "undecided";
  if (!d.fits.have_budgets()) return "cannot_be_told";
  return d.sameness == Sameness::different ? "different" : "no_difference";
}

// Returns the limits of a comparison of parameters, as a clause after the answer; empty without limits.
std::string limits_of(const Difference& d) {
  if (d.common) return "";
  std::vector<std::string> rough, unknown;
  for (const FittedTable& t : d.fits.tables) {
    if (t.fit.lack_of_fit.beyond_scatter) rough.push_back(name_in_text(t));
    if (!t.fit.lack_of_fit.judged()) unknown.push_back(name_in_text(t));
  }
  if (!unknown.empty())
    return "; the noise of " + listed(unknown) + " is not known, so that a lack of fit is not seen";
  return rough.empty() ? ""
                       : "; " + d.fits.form + " describes " + listed(rough) +
                             " only roughly, and a difference that it cannot describe is not seen";
}

std::string common_words(const Difference& d) {
  const CommonValues& c = *d.common;
  return std::to_string(c.beyond) + " of " + io::plural(c.count, "value") + " at the same directions";
}

}  // namespace

std::string answer(const Difference& d) {
  if (!d.obstacle.empty()) return "undecided: " + d.obstacle;
  if (!d.doubt.empty()) return "undecided: " + d.doubt;
  if (!d.fits.have_budgets())
    return "cannot be told: a common scale or angle error of either instrument is unknown (--budget)";
  if (d.sameness == Sameness::no_difference)
    return "no difference beyond the budgets (" + statistic_text(d) + ")" + limits_of(d);
  const std::vector<std::string> names = d.differing();
  return "different beyond the budgets: " + (names.empty() ? common_words(d) : differences_of(d, names)) +
         " (" + statistic_text(d) + ")";
}

std::string values_in_words(const Difference& d) {
  if (!d.common) return {};
  const CommonValues& c = *d.common;
  const std::string text = "the measured values differ beyond the budgets at " + common_words(d);
  if (c.beyond == 0) return text;
  std::vector<std::string> angles;
  for (const double angle : {c.theta_i, c.phi_i, c.theta_o, c.phi_o})
    angles.push_back(io::short_number(angle));
  return text + "; most clearly at theta_i, phi_i, theta_o, phi_o " + io::joined(angles) +
         (d.fits.channels.size() > 1 ? " (" + d.fits.channels[c.channel] + ")" : "") + ", " +
         signed_amount_text(as_share(c.difference, true), true) + " in " + name_in_text(d.fits.tables[1]) +
         ", standard uncertainty " + amount_text(c.uncertainty, true);
}

std::string directions_in_words(const Difference& d) {
  if (!d.fits.have_budgets() || d.directions.empty()) return {};
  const auto beyond = std::ranges::count(d.directions, true, &DirectionDifference::beyond);
  const std::string of = std::to_string(d.directions.size()) + " values in the plane of incidence";
  if (beyond == 0) return "the fitted f differs beyond the budgets at 0 of " + of;
  const auto most = std::ranges::max_element(d.directions, {}, [](const DirectionDifference& x) {
    return x.beyond ? std::abs(x.difference) / x.uncertainty : 0;
  });
  return "the fitted f differs beyond the budgets at " + std::to_string(beyond) + " of " + of +
         "; most clearly at theta_i:theta_o" + (most->at.phi == 180 ? " " : ":phi ") + to_text(most->at) +
         (d.fits.channels.size() > 1 ? " (" + most->channel + ")" : "") + ", " +
         signed_amount_text(as_share(-most->difference, true), true) + " in " +
         name_in_text(d.fits.tables[1]) + ", standard uncertainty " + amount_text(most->uncertainty, true);
}

std::string in_words(const Explanation& e) {
  if (!e.found) return "not explained by " + limits_text(e.cause);
  std::string text =
      e.explains ? "explained by " + cause_text(e) : "not explained by " + cause_text(e) + " alone";
  if (e.stated > 0)
    text += ", " + io::short_number(std::abs(e.size) / e.stated, 2) +
            " times its standard uncertainty by the budgets";
  return text;
}

void print(std::ostream& out, const Comparison& comparison) {
  const Difference& d = comparison.difference;
  for (const FittedTable& t : d.fits.tables) {
    out << io::printable(t.name) << ": " << io::plural(t.rows, "row") << ", " << name_of(t.fit.verdict);
    if (const auto ratio = t.fit.lack_of_fit.residual_over_scatter)
      out << ", residuals " << io::short_number(*ratio, 2) << " times the noise";
    if (t.fit.verdict != Verdict::converged && !t.fit.findings.empty())
      out << ": " << io::printable(t.fit.findings.front());
    out << '\n';
  }
  out << "  " << form_and_metric(d.fits) << '\n';
  out << answer(d) << '\n';
  if (!d.obstacle.empty()) return;
  for (const ParameterDifference& p : d.parameters)
    out << "  " << p.name << " " << io::short_number(p.first) << " and " << io::short_number(p.second) << ": "
        << signed_amount_text(as_share(-p.difference, p.logarithmic), p.logarithmic)
        << ", standard uncertainty " << amount_text(p.uncertainty, p.logarithmic)
        << (d.fits.have_budgets() ? "" : " (scatter alone)") << '\n';
  for (const std::string& text : {directions_in_words(d), values_in_words(d)})
    if (!text.empty()) out << "  " << text << '\n';
  for (const Explanation& e : comparison.explanations) out << "  " << in_words(e) << '\n';
}

io::Json to_json(const Comparison& comparison) {
  const Difference& d = comparison.difference;
  io::Json json = fits_json(d.fits);
  json["answer"] = name_of_answer(d);
  json["sentence"] = answer(d);
  if (!d.obstacle.empty() || !d.doubt.empty()) json["reason"] = d.obstacle + d.doubt;
  json["parameters"] = io::Json::array();
  json["directions"] = io::Json::array();
  json["explanations"] = io::Json::array();
  const bool judged = d.obstacle.empty() && d.fits.have_budgets();
  if (judged) {
    json["statistic"] = io::finite_or_null(d.statistic);
    json["p"] = io::finite_or_null(d.probability);
    json["differing"] = d.differing();
    json["common_values"] =
        d.common ? io::Json{{"count", d.common->count}, {"beyond", d.common->beyond}} : io::Json(nullptr);
  }
  if (d.obstacle.empty())
    for (const ParameterDifference& p : d.parameters) json["parameters"].push_back(parameter_json(p));
  for (const DirectionDifference& x : d.directions) json["directions"].push_back(direction_json(x, judged));
  for (const Explanation& e : comparison.explanations) json["explanations"].push_back(explanation_json(e));
  json["provenance"] = io::to_json(io::provenance());
  return json;
}

}  // namespace brdf::fit
