// The uncertainty budget on the page of a fit.
#include <algorithm>
#include <cmath>

#include "fit/assess/reported.h"
#include "fit/report/budget.h"
#include "fit/report/plain_words.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

using io::Mark;

constexpr std::size_t kMostListedRows = 400;

void add_sources(io::HtmlReport& report, const io::Budget& budget) {
  std::vector<io::Row> rows;
  for (const io::BudgetSource& s : budget.sources)
    rows.push_back({{s.name, Mark::none, true},
                    {io::short_number(s.standard_uncertainty)},
                    {std::string(name_of(s.unit))},
                    {std::string(name_of(s.shared_by))}});
  report.table({"source", "standard uncertainty", "unit", "one error for each"}, rows);
}

// A quantity with its parts, as a row of the table of parts.
struct Line {
  std::string name;
  double value;
  const Combined* combined;
};

void add_parts(io::HtmlReport& report, const std::vector<Line>& lines) {
  std::vector<std::string> sources;
  for (const Line& line : lines)
    for (const Combined::Part& part : line.combined->parts)
      if (std::ranges::find(sources, part.source) == sources.end()) sources.push_back(part.source);
  std::vector<std::string> heading{"quantity", "value", "standard uncertainty", "relative",
                                   "1.96 standard uncertainties"};
  heading.insert(heading.end(), sources.begin(), sources.end());
  constexpr double kCoverage = 1.96;
  std::vector<io::Row> rows;
  for (const Line& line : lines) {
    const double u = line.combined->standard_uncertainty;
    io::Row row{{line.name, Mark::none, true},
                {io::short_number(line.value, 6)},
                {io::short_number(u, 3)},
                {line.value != 0 ? io::percent(std::abs(u / line.value), 3) : "-"},
                {io::short_number(kCoverage * u, 3)}};
    for (const std::string& source : sources) {
      const auto part = std::ranges::find(line.combined->parts, source, &Combined::Part::source);
      const bool is_there = part != line.combined->parts.end() && u > 0;
      row.push_back({is_there ? io::percent(line.combined->share(*part), 2) : "-"});
    }
    rows.push_back(std::move(row));
  }
  report.table(heading, rows);
}

void add_rows(io::HtmlReport& report, const RowBudget& budget, const std::vector<std::string>& channels,
              const io::SampleTable& table) {
  std::vector<std::string> heading{"theta_i", "phi_i", "theta_o", "phi_o", "channel", "relative"};
  for (const io::BudgetSource& s : budget.budget->sources) heading.push_back(s.name);
  std::vector<io::Row> rows;
  for (std::size_t k = 0; k < budget.row.size(); ++k)
    for (std::size_t c = 0; c < channels.size() && rows.size() < kMostListedRows; ++c) {
      const std::size_t row = budget.row[k];
      const double u = budget.combined(c, k);
      io::Row& cells = rows.emplace_back();
      for (const double angle : {table.theta_i[row], table.phi_i[row], table.theta_o[row], table.phi_o[row]})
        cells.push_back({io::short_number(angle)});
      cells.push_back({channels[c]});
      cells.push_back({io::percent(u, 4)});
      for (const io::BudgetSource& s : budget.budget->sources)
        cells.push_back({io::percent(u > 0 ? square(budget.error(s, c, k) / u) : 0, 2)});
    }
  report.begin_fold("Combined relative standard uncertainty of every row");
  report.paragraph("The columns of the sources are shares of the variance.");
  report.table(heading, rows);
  if (const std::size_t all = budget.row.size() * channels.size(); all > rows.size())
    report.paragraph("The first " + std::to_string(rows.size()) + " of " + std::to_string(all) +
                     " values are shown; the JSON has more of them.");
  report.end_fold();
}

}  // namespace

void add_budget(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table) {
  if (!fit.budget) return;
  report.heading("Uncertainty budget");
  report.paragraph("The budget " + io::file_name(fit.budget->budget->file) +
                   " is in the intervals of this page. An error that several rows share moves these rows "
                   "together, so that more rows do not reduce it.");
  add_sources(report, *fit.budget->budget);
  const std::vector<DerivedUncertainty> derived = derived_uncertainties(fit);
  std::vector<Line> lines;
  for (const Estimate& e : fit.estimates)
    if (const NamedParameter parameter = named(fit, e); e.budget && !parameter.repeats)
      lines.push_back({label(parameter.symbol, e.channel), e.value, &*e.budget});
  for (const DerivedUncertainty& d : derived)
    lines.push_back({label(d.quantity, d.channel), d.value, &d.uncertainty});
  report.paragraph(
      "Standard uncertainties, and the share of each source in the variance. 1.96 standard uncertainties are "
      "a 95 % interval if the errors are normal and the scatter is well known; the intervals above do not "
      "assume the latter.");
  add_parts(report, lines);
  if (fit.budget->beyond_first_order > 0)
    report.paragraph("The budget is of first order. For " +
                     io::plural(fit.budget->beyond_first_order, "value") +
                     " the curvature of f over an angle's error adds more than a tenth, so that their "
                     "uncertainty is too small.");
  add_rows(report, *fit.budget, fit.material.channels, table);
}

}  // namespace brdf::fit
