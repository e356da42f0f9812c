#include <algorithm>
#include <cmath>

#include "fit/between/round_robin_report.h"
#include "fit/between/shared_report.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"

namespace brdf::fit {
namespace {

constexpr double kTwice = 2;  // standard uncertainties that a bar reaches to either side

// Returns a value of the scale of the uncertainties in the quantity's own unit.
double natural(const RoundRobinQuantity& q, double value) {
  return q.logarithmic ? std::exp(value) : value;
}

// Returns the plot of the values with the consensus and its interval.
io::Plot plot_of(const RoundRobin& result, const RoundRobinQuantity& q) {
  io::Plot plot;
  plot.title = q.name + ": values of the tables and the consensus";
  plot.x_label = "number of the table";
  plot.y_label = q.name;
  const double last = double(q.values.size()) + 0.5;
  io::Series mean{"consensus with its 95 % interval", {0.5, last}, {}, io::Series::Style::line};
  mean.y.assign(2, q.consensus_value());
  mean.low.assign(2, q.consensus_value(-1));
  mean.high.assign(2, q.consensus_value(1));
  mean.colour = 1;
  plot.series.push_back(std::move(mean));
  io::Series points{"values with twice their standard uncertainty", {}, {}, io::Series::Style::points};
  points.colour = 0;
  for (std::size_t t = 0; t < q.values.size(); ++t) {
    const double x = double(t + 1), reach = kTwice * q.values[t].uncertainty;
    points.x.push_back(x);
    points.y.push_back(q.natural[t]);
    points.names.push_back(io::file_name(result.fits.tables[t].name));
    io::Series bar{"", {x, x}, {}, io::Series::Style::line};
    bar.y = {natural(q, q.values[t].value - reach), natural(q, q.values[t].value + reach)};
    bar.colour = 0;
    plot.series.push_back(std::move(bar));
  }
  plot.series.push_back(std::move(points));
  plot.caption = "Numbers of the tables as in the table below.";
  return plot;
}

void add_degrees(io::HtmlReport& page, const RoundRobin& result, const RoundRobinQuantity& q) {
  std::vector<io::Row> rows;
  for (std::size_t t = 0; t < q.values.size(); ++t) {
    const Equivalence& d = q.consensus->degrees[t];
    rows.push_back({{.text = std::to_string(t + 1)},
                    {.text = io::file_name(result.fits.tables[t].name)},
                    {.text = io::short_number(q.natural[t], 5)},
                    {.text = amount_text(q.values[t].uncertainty, q.logarithmic)},
                    {.text = signed_amount_text(d.difference, q.logarithmic),
                     .mark = d.is_far() ? io::Mark::warn : io::Mark::none,
                     .note = d.is_far() ? "more than twice its uncertainty" : ""},
                    {.text = amount_text(d.uncertainty, q.logarithmic)}});
  }
  page.table({"number", "table", "value", "standard uncertainty", "degree of equivalence",
              "standard uncertainty of the degree"},
             rows);
}

void add_quantity(io::HtmlReport& page, const RoundRobin& result, const RoundRobinQuantity& q) {
  page.heading(q.name);
  page.paragraph(in_words(q) + ".");
  if (!q.consensus) return;
  const std::string spread = spread_in_words(q);
  page.paragraph(char(std::toupper(static_cast<unsigned char>(spread[0]))) + spread.substr(1) + ".");
  page.plot(plot_of(result, q));
  add_degrees(page, result, q);
}

std::string headline(const RoundRobin& result) {
  for (const RoundRobinQuantity& q : result.quantities)
    if (q.consensus) return in_words(q) + ".";
  return result.quantities.empty() ? "No quantity." : in_words(result.quantities.front()) + ".";
}

io::Mark mark_of_all(const RoundRobin& result) {
  const bool any = std::ranges::any_of(result.quantities,
                                       [](const RoundRobinQuantity& q) { return q.consensus.has_value(); });
  if (!any) return io::Mark::unknown;
  return result.is_decided() && result.fits.have_budgets() ? io::Mark::good : io::Mark::warn;
}

}  // namespace

std::string html_page(const RoundRobin& result) {
  io::HtmlReport page("Consensus of " + io::plural(result.fits.tables.size(), "table"));
  page.explain("degree of equivalence", "The value of a table minus the consensus.");
  page.facts({{"form", result.fits.form},
              {"channels", io::joined(result.fits.channels)},
              {"tables", std::to_string(result.fits.tables.size())},
              {"budgets", result.fits.have_budgets() ? "of every table" : ""}});
  page.verdict(mark_of_all(result), headline(result));
  const auto sentence = [](std::string text) {
    text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
    return text + ".";
  };
  const bool roughly = std::ranges::any_of(
      result.fits.tables, [](const FittedTable& t) { return t.fit.lack_of_fit.beyond_scatter; });
  page.remarks(
      {{result.fits.have_budgets() ? io::Mark::none : io::Mark::warn, sentence(about_budgets(result))},
       {roughly ? io::Mark::warn : io::Mark::none, sentence(about_form(result))}});
  for (const RoundRobinQuantity& q : result.quantities) add_quantity(page, result, q);
  page.paragraph(
      "The consensus is the mean weighted by 1/(u^2 + tau^2), with tau the standard deviation between "
      "laboratories (Mandel and Paule). The interval is Student's t with one degree of freedom less than "
      "tables. Errors that all tables share, such as that of the form at directions that were not measured, "
      "are not in it.");
  add_fits(page, result.fits);
  for (const FittedTable& t : result.fits.tables) page.footnote("samples", t.name);
  return page.document(io::provenance());
}

}  // namespace brdf::fit
