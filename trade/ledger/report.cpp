#include "trade/ledger/report.h"

#include <algorithm>

#include "io/files/numbers.h"
#include "io/files/shell.h"
#include "io/page/html_report.h"
#include "trade/ledger/conclusion.h"
#include "trade/ledger/number.h"

namespace brdf::trade {
namespace {

std::vector<std::string> questions_of(const Ledger& ledger, Unit unit) {
  std::vector<std::string> names;
  for (const LedgerRow& row : ledger.rows)
    if (row.unit == unit && std::ranges::find(names, row.question) == names.end())
      names.push_back(row.question);
  return names;
}

std::vector<const LedgerRow*> rows_of(const Ledger& ledger, const std::string& question) {
  std::vector<const LedgerRow*> rows;
  for (const LedgerRow& row : ledger.rows)
    if (row.question == question) rows.push_back(&row);
  return rows;
}

// Plots the front with names, and dominated rows as hollow circles. Exact rows lie on the bottom edge.
io::Plot front_plot(const std::string& question, const std::vector<const LedgerRow*>& rows) {
  const LedgerRow& first = *rows.front();
  io::Plot plot;
  plot.title = "Error against cost";
  plot.x_label = "cost, relative to " + first.exact;
  plot.y_label = "mean error (" + std::string(name_of(first.error.measure)) + ") of " + first.quantity;
  plot.log_x = plot.log_y = true;
  plot.bottom_edge = io::BottomEdge{"exact", kExact};
  plot.caption =
      "Domain: " + first.domain + ". Cheaper choices are on the left, more accurate choices are below.";
  plot.command = "brdf trade --only " + io::shell_word(question);
  io::Series front{"front: no choice is both cheaper and as accurate", {}, {}, io::Series::Style::points};
  io::Series dominated{"dominated", {}, {}, io::Series::Style::faint_points};
  std::vector<const LedgerRow*> by_cost = rows;
  std::ranges::stable_sort(by_cost, {}, &LedgerRow::cost_ratio);
  for (const LedgerRow* row : by_cost) {
    io::Series& series = row->dominated_by.empty() ? front : dominated;
    series.x.push_back(row->cost_ratio);
    series.y.push_back(row->error.mean);
    series.names.push_back(row->choice);
  }
  front.colour = 0;
  io::Series line{"", front.x, front.y, io::Series::Style::faint};
  for (io::Series* s : {&line, &dominated, &front})
    if (!s->x.empty()) plot.series.push_back(std::move(*s));
  return plot;
}

std::string error_text(double error) {
  return error <= kExact ? "exact" : number(error);
}

io::Cell error_cell(double error) {
  return {.text = error_text(error), .sorted_by = error <= kExact ? 0 : error};
}

io::Cell choice_cell(const LedgerRow& row) {
  return {.text = row.choice, .note = row.note};
}

void add_choices(io::HtmlReport& report, const std::vector<const LedgerRow*>& rows) {
  std::vector<io::Row> cells;
  for (const LedgerRow* row : rows)
    cells.push_back(
        {choice_cell(*row),
         row->dominated_by.empty()
             ? io::Cell{.text = "on the front", .mark = io::Mark::good}
             : io::Cell{.text = "dominated", .mark = io::Mark::absent, .note = "by " + row->dominated_by},
         {number(row->cost_ratio)},
         error_cell(row->error.mean),
         error_cell(row->error.p99),
         error_cell(row->error.max),
         row->image_error ? error_cell(*row->image_error) : io::Cell{"-"}});
  report.table({"choice", "front", "cost", "mean", "p99", "max", "image error"}, cells, true);
}

void add_question(io::HtmlReport& report, const std::string& question,
                  const std::vector<const LedgerRow*>& rows) {
  constexpr std::size_t kMostShown = 12;
  report.subheading(question);
  report.paragraph(conclusion(rows));
  report.plot(front_plot(question, rows));
  std::vector<const LedgerRow*> shown = rows;
  if (rows.size() > kMostShown)
    std::erase_if(shown, [](const LedgerRow* row) { return !row->dominated_by.empty(); });
  add_choices(report, shown);
  if (shown.size() < rows.size()) {
    report.begin_fold("All " + std::to_string(rows.size()) + " choices");
    add_choices(report, rows);
    report.end_fold();
  }
  report.begin_fold("Times and worst places");
  std::vector<io::Row> cells;
  for (const LedgerRow* row : rows)
    cells.push_back({{row->choice},
                     {number(row->cost.seconds * 1e9)},
                     {io::percent(row->cost.spread)},
                     {.text = row->error.where, .mark = io::Mark::none}});
  report.table({"choice", "ns", "spread", "worst at"}, cells);
  report.end_fold();
}

void add_extremes(io::HtmlReport& report, const Ledger& ledger) {
  std::vector<io::Row> all, far;
  for (const LedgerRow& row : ledger.rows)
    for (const Extreme& extreme : row.extremes) {
      const bool warn = extreme.max > 10 * row.error.max && extreme.max > 1e-3;
      const io::Row cells{{row.question},
                          {row.choice},
                          error_cell(row.error.max),
                          {.text = extreme.max >= 1e30 ? "not finite" : error_text(extreme.max),
                           .mark = warn ? io::Mark::warn : io::Mark::none,
                           .sorted_by = std::min(extreme.max, 1e30)},
                          {extreme.domain}};
      all.push_back(cells);
      if (warn) far.push_back(cells);
    }
  if (all.empty()) return;
  const std::vector<std::string> header{"question", "choice", "everyday", "extreme", "where"};
  report.heading("Extremes");
  report.paragraph(
      "At extreme parameters or directions, the errors of these choices are more than ten times those of the "
      "usual domain.");
  report.table(header, far);
  report.begin_fold("All " + std::to_string(all.size()) + " extremes");
  report.table(header, all, true);
  report.end_fold();
}

std::string exact_name(const std::vector<const LedgerRow*>& rows) {
  const std::string& name = rows.front()->exact;
  return name == "exact" ? name : name + " (exact)";
}

// Adds one line per question with the recommended choice.
void add_summary(io::HtmlReport& report, const std::vector<std::string>& questions, const Ledger& ledger) {
  std::vector<io::Row> cells;
  std::size_t gained = 0;
  for (const std::string& question : questions) {
    const std::vector<const LedgerRow*> rows = rows_of(ledger, question);
    const LedgerRow* best = cheapest_within(rows, 1e-2);
    gained += best != nullptr;
    const LedgerRow& taken = best ? *best : *rows.front();
    cells.push_back({{question},
                     {best ? best->choice : exact_name(rows)},
                     {best ? number(taken.cost_ratio) : "1"},
                     error_cell(best ? taken.error.mean : 0),
                     error_cell(best ? taken.error.max : 0)});
  }
  report.verdict(
      io::Mark::none,
      "In " + std::to_string(gained) + " of " + std::to_string(questions.size()) +
          " questions a cheaper choice has a mean error below 0.01; in the others use the exact method.");
  report.heading("Recommended choices for a mean error below 0.01");
  report.table({"question", "choice", "cost", "mean", "max"}, cells, true);
}

io::Mark mark_of(const Claim& claim) {
  switch (claim.standing) {
    case Standing::holds:
      return io::Mark::good;
    case Standing::on_condition:
      return io::Mark::warn;
    case Standing::fails:
      break;
  }
  return io::Mark::bad;
}

void add_claims(io::HtmlReport& report, const Ledger& ledger) {
  if (ledger.claims.empty()) return;
  report.heading("Claims of the documents");
  std::vector<io::Row> cells;
  for (const Claim& c : ledger.claims)
    cells.push_back({{.text = c.claim, .note = c.source},
                     {.text = c.verdict, .mark = mark_of(c), .note = c.evidence},
                     {.text = c.question, .note = c.choice}});
  report.table({"claim", "verdict, with the evidence", "row"}, cells);
}

}  // namespace

std::string to_html(const Ledger& ledger) {
  io::HtmlReport report("Speed against accuracy");
  report.explain("spread", "Half of the repeated runs are within this share of the time.");
  std::vector<std::string> all;
  for (std::size_t unit = 0; unit < kNames<Unit>.size(); ++unit)
    for (const std::string& question : questions_of(ledger, Unit(unit))) all.push_back(question);
  add_summary(report, all, ledger);
  if (!ledger.left_out.empty()) report.remarks({{io::Mark::warn, ledger.left_out}});
  report.begin_fold("Method of measurement");
  report.paragraph(ledger.machine.processor + ", " + ledger.machine.compiler + ", " + ledger.machine.flags +
                   (ledger.quick ? ". A quick run: fewer points." : "."));
  report.paragraph(
      "Times are lower quartiles of interleaved runs; costs are medians of pairs of neighbouring runs, and "
      "cost 1 is the exact method. A choice is dominated if another choice is not more expensive and no "
      "error of it is larger. Errors up to 1e-14 are called exact, because they are the rounding of double "
      "precision.");
  report.end_fold();
  add_claims(report, ledger);
  for (std::size_t unit = 0; unit < kNames<Unit>.size(); ++unit) {
    const std::vector<std::string> questions = questions_of(ledger, Unit(unit));
    if (questions.empty()) continue;
    report.heading("Cost of " + std::string(kNames<Unit>[unit]));
    for (const std::string& question : questions) add_question(report, question, rows_of(ledger, question));
  }
  add_extremes(report, ledger);
  return report.document(io::provenance());
}

}  // namespace brdf::trade
