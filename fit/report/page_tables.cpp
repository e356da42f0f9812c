// The verdict and the tables on the page of a fit.
#include <algorithm>
#include <cmath>

#include "fit/assess/reported.h"
#include "fit/report/budget.h"
#include "fit/report/first_screen.h"
#include "fit/report/page.h"
#include "fit/report/plain_words.h"
#include "fit/report/report.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

using io::Cell;
using io::Mark;

// Returns the value with its interval, which is the wider one if the form has lack of fit.
Cell value_cell(const FormFit& fit, const Estimate& e, const std::vector<std::string>& weak) {
  switch (e.status) {
    case Status::unidentified:
      return {.text = "not identifiable", .mark = Mark::bad};
    case Status::fixed:
      return {.text = io::short_number(e.value), .note = "fixed"};
    case Status::at_bound:
      return {.text = io::short_number(e.value),
              .mark = Mark::warn,
              .note = extent_text(interval_of(e)) + ", at a bound of its range"};
    default:
      break;
  }
  const bool wrong = fit.lack_of_fit.beyond_scatter && !std::isnan(e.with_lack_of_fit.low);
  const NamedParameter parameter = named(fit, e);
  const bool is_weak = std::ranges::any_of(weak, [&](const std::string& w) {
    const std::size_t bracket = w.find(" (");
    if (w.substr(0, bracket) != parameter.symbol) return false;
    if (bracket == w.npos || e.channel.empty()) return true;
    return (", " + w.substr(bracket + 2, w.size() - bracket - 3) + ",").find(", " + e.channel + ",") !=
           w.npos;
  });
  return {.text = io::short_number(e.value),
          .mark = is_weak ? Mark::warn : Mark::none,
          .note = extent_text(wrong ? interval_with_lack_of_fit(e) : interval_of(e))};
}

void add_intervals(io::HtmlReport& report, const FormFit& f) {
  std::vector<std::string> heading{
      "parameter",      "value",         "95 % (statistical)", "95 % with lack of fit",
      "folds held out", "other metrics", "standard error",     "status"};
  if (f.replicates > 0)
    heading.insert(heading.end() - 1, "95 % of " + std::to_string(f.replicates) + " bootstrap replicates");
  std::vector<io::Row> rows;
  for (const Estimate& e : f.estimates) {
    const NamedParameter parameter = named(f, e);
    if (parameter.repeats) continue;
    const std::string name = label(parameter.symbol, e.channel);
    const bool free = e.status == Status::free;
    const auto if_free = [&](const std::string& text) { return Cell{free ? text : "-"}; };
    rows.push_back({{name, Mark::none, true},
                    {e.status == Status::unidentified ? "-" : io::short_number(e.value)},
                    {e.status == Status::fixed ? "-" : extent_text(interval_of(e))},
                    if_free(extent_text(interval_with_lack_of_fit(e))),
                    if_free(extent_text(e.left_out)),
                    if_free(extent_text(e.other_metrics)),
                    if_free(io::short_number(e.standard_error, 2)),
                    {std::string(name_of(e.status)), free                               ? Mark::good
                                                     : e.status == Status::unidentified ? Mark::bad
                                                                                        : Mark::warn}});
    if (f.replicates > 0) rows.back().insert(rows.back().end() - 1, if_free(extent_text(e.bootstrap)));
  }
  report.begin_fold("All intervals");
  report.table(heading, rows);
  report.end_fold();
}

void add_correlations(io::HtmlReport& report, const FormFit& f) {
  constexpr std::size_t kMostShown = 16;
  const Correlations& c = f.correlations;
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < c.names.size(); ++k) {
    const auto e = std::ranges::find_if(
        f.estimates, [&](const Estimate& estimate) { return label(estimate) == c.names[k]; });
    if (e == f.estimates.end() || !named(f, *e).repeats) shown.push_back(k);
  }
  const std::size_t all = shown.size();
  if (all < 2) return;
  shown.resize(std::min(all, kMostShown));
  report.begin_fold("Correlations of the parameters");
  report.paragraph(
      "Near 1 or -1 two parameters can replace each other: only a combination of the two is identifiable.");
  std::vector<std::string> header{""};
  std::vector<io::Row> rows;
  for (const std::size_t i : shown) {
    header.push_back(c.names[i]);
    io::Row row{{c.names[i], Mark::none, true}};
    for (const std::size_t j : shown) {
      const double r = c.matrix(i, j);
      if (i == j)
        row.push_back({""});
      else
        row.push_back(
            {io::short_number(std::round(100 * r) / 100, 3), std::abs(r) > 0.95 ? Mark::warn : Mark::none});
    }
    rows.push_back(std::move(row));
  }
  report.table(header, rows);
  if (all > kMostShown)
    report.paragraph("The first " + std::to_string(kMostShown) + " of " + std::to_string(all) +
                     " parameters are shown; the JSON lists all.");
  report.end_fold();
}

void add_minima(io::HtmlReport& report, const FormFit& f) {
  report.begin_fold("Local minima");
  report.paragraph("The solver was started from " + std::to_string(f.starts) +
                   " points and converged to these minima. If there is only one, the result does not depend "
                   "on the starting point.");
  std::vector<io::Row> rows;
  for (const MinimumReport& m : f.minima)
    rows.push_back({{io::short_number(m.cost, 6)}, {std::to_string(m.basin)}, {shape_text(m.material)}});
  report.table({"cost", "starts", "shape"}, rows);
  report.end_fold();
}

}  // namespace

void add_verdict(io::HtmlReport& report, const FitResult& result) {
  const FormFit& best = result.ranking.front();
  const std::vector<std::string> faults = sheet_in_words(result);
  report.verdict(faults.empty() ? mark_of(best) : std::max(mark_of(best), Mark::warn),
                 verdict_sentence(best));
  std::vector<io::Remark> remarks;
  for (const std::string& fault : faults) remarks.push_back({Mark::warn, "The measurements: " + fault + "."});
  for (io::Remark& remark : remarks_on(best)) remarks.push_back(std::move(remark));
  for (io::Remark& remark : energy_remarks(result)) remarks.push_back(std::move(remark));
  report.remarks(remarks);
  if (std::string text = recommendation(result); !text.empty()) {
    text[0] = 'R';
    report.paragraph(text + ".");
  }
}

void add_parameters(io::HtmlReport& report, const FormFit& fit) {
  report.heading("Parameters");
  const std::vector<std::string>& channels = fit.material.channels;
  const bool one = channels.size() == 1;
  const std::vector<std::string> weak = weakly_determined(fit);
  io::Matrix matrix{.properties = "", .subjects = {"symbol"}, .rows = {}, .fold_notes = false};
  matrix.subjects.push_back(one ? "value" : "all channels");
  if (!one) matrix.subjects.insert(matrix.subjects.end(), channels.begin(), channels.end());
  for (const Estimate& e : fit.estimates) {
    const NamedParameter parameter = named(fit, e);
    if (parameter.repeats) continue;
    report.explain(parameter.plain, parameter.meaning + ".");
    const auto is_row = [&](const io::Matrix::Property& row) {
      return row.cells[0].text == parameter.symbol;
    };
    auto row = std::ranges::find_if(matrix.rows, is_row);
    if (row == matrix.rows.end()) {
      row = matrix.rows.insert(row, {parameter.plain, io::Row(matrix.subjects.size())});
      row->cells[0] = {parameter.symbol, Mark::none, true};
    }
    const auto channel = std::ranges::find(channels, e.channel);
    const std::size_t column =
        one || channel == channels.end() ? 1 : 2 + std::size_t(channel - channels.begin());
    row->cells[column] = value_cell(fit, e, weak);
  }
  report.matrix(matrix);
  report.paragraph(fit.lack_of_fit.beyond_scatter ? "Small print: 95 % confidence intervals with lack of "
                                                    "fit, because the form does not fit within the noise."
                                                  : "Small print: 95 % confidence intervals.");
  if (has_intervals(fit)) report.paragraph("Scope of the " + scope_of_intervals(fit) + ".");
  if (fit.intervals == IntervalsBy::curvature)
    report.paragraph("These intervals are approximate: they are derived from the curvature at the minimum.");
  add_intervals(report, fit);
}

void add_ranking(io::HtmlReport& report, const FitResult& result) {
  if (result.ranking.size() > 1) report.heading("All forms, best first");
  const bool held_out =
      std::ranges::any_of(result.ranking, [](const FormFit& f) { return f.left_out.has_value(); });
  std::vector<io::Row> rows, more;
  for (const FormFit& f : result.ranking) {
    // A column never mixes fitted and held-out errors.
    const RelativeErrors errors = !held_out ? f.errors : f.left_out ? f.left_out->errors : RelativeErrors{};
    const auto& over = f.lack_of_fit.residual_over_scatter;
    const auto share = [&](double x) {
      return Cell{f.solved() && std::isfinite(x) ? io::percent(x) : std::string("-")};
    };
    rows.push_back({{f.form, Mark::none, true},
                    {std::string(name_of(f.verdict)), mark_in_ranking(f, result.ranking.front())},
                    {f.left_out ? io::short_number(f.left_out->value, 3) : "-"},
                    share(f.median_relative_error),
                    share(errors.ninth_decile),
                    share(errors.off_by_two),
                    {over ? times_text(*over) : "-"},
                    {std::to_string(f.parameters)}});
    if (held_out) rows.back().insert(rows.back().begin() + 4, share(errors.median));
    more.push_back({{f.form, Mark::none, true},
                    {f.lack_of_fit.worst ? to_text(f.lack_of_fit.worst->range) : "-"},
                    {f.lack_of_fit.worst ? io::short_number(f.lack_of_fit.worst->ratio, 3) : "-"},
                    {io::short_number(f.bic, 6)},
                    {io::short_number(f.metrics.log, 3)},
                    {io::short_number(f.metrics.cosine_l2, 3)},
                    {io::short_number(f.metrics.cube_root, 3)},
                    {io::short_number(f.metrics.log_relative, 3)}});
  }
  if (result.ranking.size() == 1) report.heading("Errors");
  const std::string of = held_out ? " (held out)" : " (fitted)";
  std::vector<std::string> header{"form",      "verdict",       "held out",  "median error (fitted)",
                                  "90 %" + of, "off by 2" + of, "x scatter", "parameters"};
  if (held_out) header.insert(header.begin() + 4, "median error (held out)");
  report.table(header, rows, rows.size() > 1);
  report.begin_fold("Worst region of each form, BIC and the four metrics");
  report.table({"form", "worst at", "ratio there", "BIC", "log", "cosine L2", "cube root", "log-relative"},
               more, more.size() > 1);
  report.end_fold();
}

void add_samples(io::HtmlReport& report, const FitResult& result, const io::SampleTable& table,
                 const FitOptions& options) {
  report.heading("The measurements");
  std::string residual(name_of(result.metric.metric));
  if (!result.metric.asked) residual += ", chosen: " + result.metric.reason;
  std::vector<io::Row> rows{
      {{"file"}, {io::file_name(table.name())}},
      {{"channels"}, {io::joined(table.channels)}},
      {{"fitted"},
       {std::to_string(result.rows) + " of " + std::to_string(table.rows()) +
        " rows, both polar angles at most " + io::short_number(options.max_theta) + " degrees"}},
      {{"residual"}, {residual}},
      {{"scatter"}, {scatter_text(result)}}};
  if (options.free_scale)
    rows.push_back({{"scale"},
                    {"values divided by " + io::short_number(table.scale, 6) +
                     ", which is not known: weights are relative"}});
  report.table({}, rows);
}

void add_workings(io::HtmlReport& report, const FitResult& result) {
  const FormFit& best = result.ranking.front();
  if (!result.steps.empty()) {
    report.begin_fold("How the form was chosen, step by step");
    for (const Step& step : result.steps) report.paragraph(in_words(step) + ".");
    report.end_fold();
  }
  add_correlations(report, best);
  add_minima(report, best);
}

}  // namespace brdf::fit
