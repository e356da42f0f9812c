#include "trade/ledger/report.h"

#include <algorithm>

#include "io/html_report.h"
#include "io/numbers.h"
#include "io/shell.h"

namespace brdf::trade {
namespace {

constexpr double kLeastShown = 1e-17;  // a logarithmic axis has no 0

std::string number(double x) {
  return io::short_number(x, 3);
}

std::vector<std::string> questions_of(const Ledger& ledger, Unit unit) {
  std::vector<std::string> names;
  for (const LedgerRow& row : ledger.rows)
    if (row.unit == unit && std::find(names.begin(), names.end(), row.question) == names.end())
      names.push_back(row.question);
  return names;
}

std::vector<const LedgerRow*> rows_of(const Ledger& ledger, const std::string& question) {
  std::vector<const LedgerRow*> rows;
  for (const LedgerRow& row : ledger.rows)
    if (row.question == question) rows.push_back(&row);
  return rows;
}

// The front as a line whose every point has its name, what is dominated as faint points.
io::Plot front_plot(const std::string& question, const std::vector<const LedgerRow*>& rows) {
  const LedgerRow& first = *rows.front();
  io::Plot plot{question,
                "cost relative to " + first.exact,
                "mean error (" + std::string(name_of(first.error.measure)) + ")",
                {},
                true,
                true};
  plot.caption =
      "Error of " + first.quantity + " over " + first.domain + ". Exact values are drawn at 1e-17.";
  plot.command = "brdf trade --only " + io::shell_word(question);
  io::Series front{"front", {}, {}, io::Series::Style::faint};
  io::Series dominated{"dominated", {}, {}, io::Series::Style::faint_points};
  std::vector<const LedgerRow*> by_cost = rows;
  std::stable_sort(by_cost.begin(), by_cost.end(),
                   [](const LedgerRow* a, const LedgerRow* b) { return a->cost_ratio < b->cost_ratio; });
  for (const LedgerRow* row : by_cost) {
    const double error = std::max(row->error.mean, kLeastShown);
    if (row->dominated_by.empty()) {
      plot.series.push_back({row->choice, {row->cost_ratio}, {error}, io::Series::Style::points});
      front.x.push_back(row->cost_ratio);
      front.y.push_back(error);
    } else {
      dominated.x.push_back(row->cost_ratio);
      dominated.y.push_back(error);
    }
  }
  if (front.x.size() > 1) plot.series.push_back(std::move(front));
  if (!dominated.x.empty()) plot.series.push_back(std::move(dominated));
  return plot;
}

void add_question(io::HtmlReport& report, const std::string& question,
                  const std::vector<const LedgerRow*>& rows) {
  report.plot(front_plot(question, rows));
  std::vector<std::vector<io::Cell>> cells;
  for (const LedgerRow* row : rows)
    cells.push_back({{row->choice, row->dominated_by.empty() ? io::Mark::good : io::Mark::none},
                     {number(row->cost.seconds * 1e9)},
                     {number(row->cost_ratio)},
                     {io::percent(row->cost.spread)},
                     {number(row->error.max)},
                     {number(row->error.mean)},
                     {number(row->error.p99)},
                     {row->image_error ? number(*row->image_error) : "-"},
                     {row->error.where},
                     {row->dominated_by.empty() ? "on the front" : "dominated by " + row->dominated_by},
                     {row->note}});
  report.table({"choice", "ns", "cost", "spread", "max", "mean", "p99", "image", "worst at", "front", "note"},
               cells);
}

void add_extremes(io::HtmlReport& report, const Ledger& ledger) {
  report.heading("Extremes");
  report.paragraph(
      "The largest error in the everyday domain, and beside it where parameters or directions are extreme.");
  std::vector<std::vector<io::Cell>> cells;
  for (const LedgerRow& row : ledger.rows)
    for (const Extreme& extreme : row.extremes)
      cells.push_back(
          {{row.question},
           {row.choice},
           {number(row.error.max)},
           {extreme.max >= 1e30 ? "not finite" : number(extreme.max),
            extreme.max > 10 * row.error.max && extreme.max > 1e-3 ? io::Mark::warn : io::Mark::none},
           {extreme.domain}});
  report.table({"question", "choice", "everyday", "extreme", "where"}, cells);
}

}  // namespace

std::string to_html(const Ledger& ledger) {
  io::HtmlReport report("Speed against accuracy");
  report.paragraph(ledger.machine.processor + ", " + ledger.machine.compiler + ", " + ledger.machine.flags +
                   (ledger.quick ? ". A quick run: fewer points." : "."));
  report.paragraph(
      "Times are lower quartiles of interleaved runs, costs medians of pairs of neighbouring runs; cost 1 is "
      "the exact way. A choice is dominated where another is not dearer and in no error worse.");
  if (!ledger.left_out.empty()) report.paragraph(ledger.left_out);
  if (!ledger.claims.empty()) {
    report.heading("The documents' claims");
    std::vector<std::vector<io::Cell>> cells;
    for (const Claim& c : ledger.claims)
      cells.push_back({{c.source}, {c.claim}, {c.verdict}, {c.evidence}, {c.question + ": " + c.choice}});
    report.table({"source", "claim", "verdict", "evidence", "row"}, cells);
  }
  for (std::size_t unit = 0; unit < kNames<Unit>.size(); ++unit) {
    const std::vector<std::string> questions = questions_of(ledger, Unit(unit));
    if (questions.empty()) continue;
    report.heading("The price of " + std::string(kNames<Unit>[unit]));
    for (const std::string& question : questions) add_question(report, question, rows_of(ledger, question));
  }
  add_extremes(report, ledger);
  return report.document(io::provenance());
}

}  // namespace brdf::trade
