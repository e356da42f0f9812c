#include "fit/report/budget.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "brdf/material.h"
#include "fit/assess/albedo.h"
#include "fit/assess/derived.h"
#include "fit/assess/reported.h"
#include "fit/report/plain_words.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kMostRows = 10000;  // of JSON
constexpr std::size_t kNamedParts = 3;    // of a sentence

// The smallest, median and largest relative standard uncertainty of the values.
struct RowSummary {
  double least = 0, median = 0, largest = 0;
  std::size_t values = 0;
};

RowSummary summary_of(const RowBudget& rows) {
  std::vector<double> all;
  for (std::size_t c = 0; c < rows.values.size(); ++c)
    for (std::size_t k = 0; k < rows.row.size(); ++k) all.push_back(rows.combined(c, k));
  if (all.empty()) return {};
  const auto [least, largest] = std::minmax_element(all.begin(), all.end());
  return {*least, io::median(all), *largest, all.size()};
}

std::string relative_text(double uncertainty, double value) {
  return value != 0 ? io::percent(std::abs(uncertainty / value), 3) : io::short_number(uncertainty, 3);
}

// Returns "reference_standard 62 %, zero_theta_o 30 %", the largest parts by their shares of the variance.
std::string largest_parts(const Combined& c) {
  std::vector<Combined::Part> parts = c.parts;
  std::ranges::sort(parts, std::greater(), &Combined::Part::standard_uncertainty);
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < std::min(parts.size(), kNamedParts); ++k)
    texts.push_back(parts[k].source + " " + io::percent(c.share(parts[k]), 2));
  return io::joined(texts);
}

// Returns ", the rows of each of 5 lights share an error" if a source states this.
std::string lights_in_words(const RowBudget& rows) {
  const auto of_light = [](const io::BudgetSource& s) { return s.shared_by == io::SharedBy::light; };
  if (std::ranges::none_of(rows.budget->sources, of_light)) return "";
  return rows.lights == 1 ? ", all rows have one light"
                          : ", the rows of each of " + std::to_string(rows.lights) + " lights share errors";
}

}  // namespace

std::string uncertainty_text(const std::string& name, double value, const Combined& c) {
  return "standard uncertainty of " + name + ": " + io::short_number(c.standard_uncertainty, 4) + " (" +
         relative_text(c.standard_uncertainty, value) + "); shares of the variance: " + largest_parts(c);
}

bool has_intervals(const FormFit& fit) {
  return std::ranges::any_of(fit.estimates, [](const Estimate& e) { return !std::isnan(e.low); });
}

std::string scope_of_intervals(const FormFit& fit) {
  if (!fit.budget) return std::string("intervals: ") + kScatterOnly;
  return "intervals: the budget " + io::file_name(fit.budget->budget->file) + " is in them";
}

std::vector<std::string> budget_in_words(const FormFit& fit) {
  std::vector<std::string> lines;
  if (!fit.budget) return lines;
  const RowBudget& rows = *fit.budget;
  const RowSummary all = summary_of(rows);
  lines.push_back("budget of a row: combined relative standard uncertainty " +
                  io::short_number(all.median, 5) + " (median of " + io::plural(all.values, "value") + "; " +
                  io::short_number(all.least, 5) + " to " + io::short_number(all.largest, 5) + "), " +
                  io::plural(rows.budget->sources.size(), "source") + lights_in_words(rows));
  if (rows.beyond_first_order > 0)
    lines.push_back("the budget is of first order: for " + io::plural(rows.beyond_first_order, "value") +
                    " the curvature of f over an angle's error adds more than a tenth, so that their "
                    "uncertainty is too small");
  for (const Estimate& e : fit.estimates)
    if (const NamedParameter parameter = named(fit, e); e.budget && !parameter.repeats)
      lines.push_back(uncertainty_text(label(parameter.symbol, e.channel), e.value, *e.budget));
  for (const DerivedUncertainty& d : derived_uncertainties(fit))
    lines.push_back(uncertainty_text(d.quantity + (d.channel.empty() ? "" : " (" + d.channel + ")"), d.value,
                                     d.uncertainty));
  return lines;
}

std::vector<DerivedUncertainty> derived_uncertainties(const FormFit& fit) {
  std::vector<DerivedUncertainty> out;
  const Knowledge known = knowledge_of(fit);
  if (!fit.budget || !known.has_budget()) return out;
  constexpr double kAlbedoAngle = 8, kViewAngle = 45;  // degrees: hemispherical and 0:45 colour instruments
  struct Quantity {
    std::string name;
    Derived value;
  };
  const std::array quantities{
      Quantity{"albedo at 8 degrees",
               [&](const Material& m) { return albedos_at(m, std::span(&kAlbedoAngle, 1)); }},
      Quantity{"f at 0:45", [&](const Material& m) {
                 std::vector<double> all(m.channels.size());
                 eval(m, direction(degrees(0), degrees(0)), direction(degrees(kViewAngle), degrees(0)), all);
                 return all;
               }}};
  const std::vector<std::string>& channels = fit.material.channels;
  for (const Quantity& q : quantities) {
    const std::vector<double> values = q.value(fit.material);
    const auto found = combined(fit.material, *known.covariance, values, q.value);
    for (std::size_t c = 0; found && c < values.size(); ++c)
      out.push_back({q.name, channels.size() > 1 ? channels[c] : "", values[c], (*found)[c]});
  }
  return out;
}

namespace {

io::Json rows_json(const RowBudget& rows, const std::vector<std::string>& channels,
                   const io::SampleTable& table) {
  std::vector<std::size_t> order(rows.row.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::sort(order, {}, [&](std::size_t k) { return rows.row[k]; });
  io::Json out = io::Json::array();
  for (const std::size_t k : order)
    for (std::size_t c = 0; c < channels.size(); ++c) {
      if (out.size() == kMostRows) return out;
      const std::size_t row = rows.row[k];
      io::Json shares = io::Json::object();
      const double u = rows.combined(c, k);
      for (const io::BudgetSource& source : rows.budget->sources)
        shares[source.name] = io::finite_or_null(u > 0 ? square(rows.error(source, c, k) / u) : 0);
      out.push_back({{"row", row + 1},
                     {"channel", channels[c]},
                     {"theta_i", table.theta_i[row]},
                     {"phi_i", table.phi_i[row]},
                     {"theta_o", table.theta_o[row]},
                     {"phi_o", table.phi_o[row]},
                     {"S_theta_i", io::finite_or_null(rows.theta_i[c][k])},
                     {"S_theta_o", io::finite_or_null(rows.theta_o[c][k])},
                     {"u_rel", io::finite_or_null(u)},
                     {"shares", std::move(shares)}});
    }
  return out;
}

}  // namespace

io::Json budget_json(const FormFit& fit, const io::SampleTable* table) {
  if (!fit.budget) return nullptr;
  const RowBudget& rows = *fit.budget;
  io::Json j{{"file", rows.budget->file}, {"sources", io::Json::array()}};
  for (const io::BudgetSource& s : rows.budget->sources)
    j["sources"].push_back({{"source", s.name},
                            {"standard_uncertainty", s.standard_uncertainty},
                            {"unit", name_of(s.unit)},
                            {"shared_by", name_of(s.shared_by)}});
  const RowSummary all = summary_of(rows);
  j["u_rel"] = {{"least", all.least}, {"median", all.median}, {"largest", all.largest}};
  j["beyond_first_order"] = rows.beyond_first_order;
  j["derived"] = io::Json::array();
  for (const DerivedUncertainty& d : derived_uncertainties(fit))
    j["derived"].push_back({{"quantity", d.quantity},
                            {"channel", d.channel},
                            {"value", io::finite_or_null(d.value)},
                            {"standard_uncertainty", io::finite_or_null(d.uncertainty.standard_uncertainty)},
                            {"sources", parts_json(d.uncertainty)}});
  if (table) j["rows"] = rows_json(rows, fit.material.channels, *table);
  return j;
}

}  // namespace brdf::fit
