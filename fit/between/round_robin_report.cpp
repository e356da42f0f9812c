#include "fit/between/round_robin_report.h"

#include <algorithm>
#include <ostream>

#include "fit/between/shared_report.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

io::Json laboratory_json(const RoundRobin& result, const RoundRobinQuantity& q, std::size_t t) {
  io::Json json{{"samples", result.fits.tables[t].name},
                {"value", io::finite_or_null(q.natural[t])},
                {"standard_uncertainty", io::finite_or_null(q.values[t].uncertainty)}};
  if (!q.consensus) return json;
  const Equivalence& degree = q.consensus->degrees[t];
  json["degree_of_equivalence"] = io::finite_or_null(degree.difference);
  json["degree_uncertainty"] = io::finite_or_null(degree.uncertainty);
  return json;
}

io::Json quantity_json(const RoundRobin& result, const RoundRobinQuantity& q) {
  io::Json json{{"name", q.name}, {"relative", q.logarithmic}};
  if (q.consensus) {
    const Consensus& c = *q.consensus;
    json["consensus"] = {{"value", q.consensus_value()},
                         {"low", q.consensus_value(-1)},
                         {"high", q.consensus_value(1)},
                         {"standard_uncertainty", c.uncertainty},
                         {"half_width", c.half_width},
                         {"between", c.between},
                         {"chi_square", io::finite_or_null(c.chi_square)},
                         {"p", io::finite_or_null(c.probability)}};
  } else {
    json["consensus"] = nullptr;
    json["reason"] = q.obstacle;
  }
  json["laboratories"] = io::Json::array();
  for (std::size_t t = 0; t < q.values.size(); ++t)
    json["laboratories"].push_back(laboratory_json(result, q, t));
  return json;
}

std::size_t widest_name(const RoundRobin& result) {
  std::size_t width = 5;
  for (const FittedTable& t : result.fits.tables) width = std::max(width, io::printable(t.name).size());
  return width;
}

// Prints a row of cells; the first cell is `first` characters wide.
void print_row(std::ostream& out, std::size_t first, const std::vector<std::string>& cells) {
  constexpr std::size_t kWidth = 13;
  std::string line = "  ";
  for (std::size_t k = 0; k < cells.size(); ++k) {
    line += cells[k];
    const std::size_t width = k == 0 ? first : kWidth;
    if (k + 1 < cells.size())
      line += std::string(std::max(width + 2, cells[k].size() + 2) - cells[k].size(), ' ');
  }
  out << line << '\n';
}

}  // namespace

std::string about_budgets(const RoundRobin& result) {
  if (result.fits.have_budgets())
    return "the uncertainties u of the tables contain their budgets and the scatter of their rows";
  return "no budget: the uncertainties u of the tables are scatter alone; scale and zero errors are not in "
         "them, and appear as the standard deviation between laboratories (--budget)";
}

std::string about_form(const RoundRobin& result) {
  const std::string always = "an error of the form " + result.fits.form + " is not in u";
  const FittedTable* worst = nullptr;
  const auto ratio = [](const FittedTable& t) { return t.fit.lack_of_fit.residual_over_scatter.value_or(0); };
  for (const FittedTable& t : result.fits.tables)
    if (t.fit.lack_of_fit.beyond_scatter && (!worst || ratio(t) > ratio(*worst))) worst = &t;
  if (!worst) return always;
  return always + ", and " + result.fits.form + " describes " + worst->name +
         " only roughly: its residuals are " + io::short_number(ratio(*worst), 2) +
         " times the noise, so that the consensus may miss the true value by more than its interval; choose "
         "another form";
}

std::string in_words(const RoundRobinQuantity& q) {
  if (!q.consensus) return q.name + ": undecided: " + q.obstacle;
  const Consensus& c = *q.consensus;
  return q.name + ": consensus " + io::short_number(q.consensus_value(), 5) + " (" +
         io::short_number(q.consensus_value(-1), 5) + " to " + io::short_number(q.consensus_value(1), 5) +
         "), standard uncertainty " + amount_text(c.uncertainty, q.logarithmic) + ", +- " +
         amount_text(c.half_width, q.logarithmic) + " (95 %)";
}

std::string spread_in_words(const RoundRobinQuantity& q) {
  if (!q.consensus) return {};
  const Consensus& c = *q.consensus;
  if (!(c.between > 0))
    return "the values deviate by no more than the uncertainties of the tables: between laboratories 0";
  const std::string beyond = "between laboratories " + amount_text(c.between, q.logarithmic) +
                             ": the values deviate by more than the uncertainties of the tables";
  return c.probability < kSignificance
             ? beyond + " (p " + probability_text(c.probability) + ")"
             : beyond + ", which may be chance (p " + probability_text(c.probability) + ")";
}

void print(std::ostream& out, const RoundRobin& result) {
  out << io::plural(result.fits.tables.size(), "table") << ", "
      << io::plural(result.fits.channels.size(), "channel") << ": " << form_and_metric(result.fits) << '\n';
  for (const FittedTable& t : result.fits.tables)
    if (t.fit.verdict != Verdict::converged)
      out << "  " << io::printable(t.name) << ": " << name_of(t.fit.verdict)
          << (t.fit.findings.empty() ? "" : ": " + io::printable(t.fit.findings.front())) << '\n';
  out << "  " << about_budgets(result) << '\n' << "  " << io::printable(about_form(result)) << '\n';
  const std::size_t first = widest_name(result);
  for (const RoundRobinQuantity& q : result.quantities) {
    out << io::printable(in_words(q)) << '\n';
    if (!q.consensus) continue;
    out << "  " << spread_in_words(q) << '\n';
    print_row(out, first, {"table", "value", "u", "degree", "u of degree"});
    for (std::size_t t = 0; t < q.values.size(); ++t) {
      const Equivalence& d = q.consensus->degrees[t];
      print_row(out, first,
                {io::printable(result.fits.tables[t].name), io::short_number(q.natural[t], 5),
                 amount_text(q.values[t].uncertainty, q.logarithmic),
                 signed_amount_text(d.difference, q.logarithmic),
                 amount_text(d.uncertainty, q.logarithmic) + (d.is_far() ? "  more than 2 u" : "")});
    }
  }
}

io::Json to_json(const RoundRobin& result) {
  io::Json json = fits_json(result.fits);
  json["about_budgets"] = about_budgets(result);
  json["about_form"] = about_form(result);
  json["quantities"] = io::Json::array();
  for (const RoundRobinQuantity& q : result.quantities)
    json["quantities"].push_back(quantity_json(result, q));
  json["provenance"] = io::to_json(io::provenance());
  return json;
}

}  // namespace brdf::fit
