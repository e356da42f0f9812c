#include "fit/report/report.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "fit/assess/reported.h"
#include "fit/report/budget.h"
#include "fit/report/plain_words.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kListedChannels = 8;

std::string error_text(double error) {
  if (!std::isfinite(error)) return "-";
  if (error > 0 && error < 1e-11) return "< 1e-9 %";
  return error < 10 ? io::percent(error) : std::to_string(std::llround(100 * error)) + " %";
}

// Returns the value with its interval and, if the model has lack of fit, the interval that includes it.
std::string estimate_text(const Estimate& e, const std::string& name, bool wrong) {
  switch (e.status) {
    case Status::unidentified:
      return name + " not identifiable" +
             (e.low_open && e.high_open ? "" : " (" + extent_text(interval_of(e)) + ")");
    case Status::fixed:
      return name + " " + io::short_number(e.value) + " (fixed)";
    case Status::at_bound:
      return name + " " + io::short_number(e.value) + "  (" + extent_text(interval_of(e)) + ", at its bound)";
    default:
      break;
  }
  std::string text = name + " " + io::short_number(e.value) + "  (" + extent_text(interval_of(e));
  if (wrong && std::isfinite(e.with_lack_of_fit.low))
    text += " statistical, " + extent_text(interval_with_lack_of_fit(e)) + " with lack of fit";
  if (wrong && std::isfinite(e.other_metrics.low))
    text += "; by other metrics " + extent_text(e.other_metrics);
  if (std::isfinite(e.bootstrap.low)) text += "; bootstrap " + extent_text(e.bootstrap);
  return text + (e.budget ? ", with the budget)" : ")");
}

// Returns the text in the colour of its mark.
std::string shown(const std::string& text, io::Mark mark, const TextStyle& style) {
  if (!style.colours) return text;
  return std::string(io::look_of(mark).terminal) + text + "\x1b[0m";
}

// A column of the ranking: its heading, then its cells.
struct Column {
  int width;  // minimum, including the blanks before the next column
  std::string heading;
  std::vector<std::string> cells;
  int dropped = 0;  // order of removal if a terminal is too narrow; 0: never removed
  int needed() const {
    std::size_t widest = heading.size();
    for (const std::string& cell : cells) widest = std::max(widest, cell.size());
    return std::max(width, int(widest) + 2);
  }
};

// Prints the ranked forms. If the terminal is too narrow for all columns, some are omitted, with a note.
void print_ranking(std::ostream& out, const FitResult& result, const TextStyle& style) {
  const bool held_out =
      std::ranges::any_of(result.ranking, [](const FormFit& f) { return f.left_out.has_value(); });
  // The widths are minima. `dropped` gives the order of removal if the terminal is too narrow; the least
  // important column goes first.
  std::vector<Column> table{{0, "form", {}},       {0, "verdict", {}},      {10, "held out", {}, 3},
                            {9, "median", {}},     {8, "90 %", {}, 2},      {10, "off by 2", {}, 1},
                            {11, "x scatter", {}}, {0, "parameters", {}, 4}};
  if (style.columns == 0) table[0].width = 28, table[1].width = 17;  // enough for most names; sums are longer
  for (const FormFit& fit : result.ranking) {
    // A column never mixes fitted and held-out errors.
    const RelativeErrors e = !held_out ? fit.errors : fit.left_out ? fit.left_out->errors : RelativeErrors{};
    const double value = fit.left_out ? fit.left_out->value : kUnknown,
                 over = fit.lack_of_fit.residual_over_scatter.value_or(kUnknown);
    const std::string cells[] = {fit.form,
                                 std::string(name_of(fit.verdict)),
                                 std::isfinite(value) ? io::short_number(value, 3) : "-",
                                 error_text(e.median),
                                 error_text(e.ninth_decile),
                                 error_text(e.off_by_two),
                                 std::isfinite(over) ? times_text(over) : "-",
                                 std::to_string(fit.parameters)};
    for (std::size_t k = 0; k < table.size(); ++k) table[k].cells.push_back(cells[k]);
  }
  int width = 0;
  for (const Column& column : table) width += column.needed();
  const int all = width;
  std::size_t missing = 0;
  for (int next = 1; next <= 4 && style.columns > 0 && width > style.columns; ++next) {
    const auto goes = std::ranges::find(table, next, &Column::dropped);
    width -= goes->needed();
    table.erase(goes);
    ++missing;
  }
  out << std::left;
  for (std::size_t row = 0; row <= result.ranking.size(); ++row) {
    out << "  ";
    for (const Column& column : table) {
      const bool last = &column == &table.back();
      const std::string& cell = row == 0 ? column.heading : column.cells[row - 1];
      const bool marked = row > 0 && column.heading == "verdict";
      const FormFit* const fit = marked ? &result.ranking[row - 1] : nullptr;
      out << (fit ? shown(cell, mark_in_ranking(*fit, result.ranking.front()), style) : cell);
      if (!last) out << std::string(std::size_t(std::max(column.needed() - int(cell.size()), 0)), ' ');
    }
    out << '\n';
  }
  if (missing > 0)
    out << "  a terminal of " << all << " columns, or --json, shows " << io::plural(missing, "more column")
        << '\n';
  out << "  median, 90 % and off by 2: errors of the rows " << (held_out ? "held out" : "fitted") << '\n';
}

}  // namespace

std::string times_text(double factor) {
  return factor < 100 ? io::short_number(factor, 2) : std::to_string(std::llround(factor));
}

std::string in_words(const LackOfFit& lack) {
  if (lack.exact) return "not detectable: the residuals are below 1e-9 of the values";
  if (!lack.residual_over_scatter) return "cannot be judged, because the measurement noise is not known";
  std::string text = "residuals " + times_text(*lack.residual_over_scatter) + " times the measurement noise";
  if (!lack.beyond_scatter) return text + ": consistent with the noise";
  if (const auto& w = lack.worst)
    text += "; worst at " + to_text(w->range) + " (" + io::plural(w->rows, "row") + ", " +
            io::percent(w->share, 2) + " of the cost): measured values are typically " +
            io::short_number(w->ratio, 3) + " times the fitted ones";
  return text;
}

std::string others_in_words(const LackOfFit& lack) {
  std::string text;
  for (const WorstRegion& w : lack.others)
    text += (text.empty() ? "other large residuals: at " : "; at ") + to_text(w.range) + " (" +
            io::plural(w.rows, "row") + ", " + io::percent(w.share, 2) +
            " of the cost): " + io::short_number(w.ratio, 3) + " times";
  return text;
}

std::string in_words(const SmoothCurve& curve) {
  std::string text =
      curve.parameter + " over wavelength: " +
      (curve.scale == "identity" ? curve.parameter : curve.scale + "(" + curve.parameter + ")") + " = ";
  for (std::size_t k = 0; k < curve.coefficients.size(); ++k) {
    text += (k ? " + (" : "(") + io::short_number(curve.coefficients[k]) + " +- " +
            io::short_number(curve.standard_errors[k], 2) + ")";
    if (k > 0) text += k > 1 ? " x^" + std::to_string(k) : " x";
  }
  return text + ", x = 1000 nm/wavelength";
}

std::string in_words(const Step& step) {
  const std::string start =
      step.added + ": " + step.model + ", held-out error " + io::short_number(step.left_out, 3);
  if (step.difference == 0 && step.kept) return start;
  return start + (step.difference < 0 ? ", higher by " : ", lower by ") +
         io::short_number(std::abs(step.difference), 3) + " +- " + io::short_number(step.standard_error, 2) +
         " (p " + io::short_number(step.p, 2) +
         (step.tried > 1 ? ", best of " + std::to_string(step.tried) : std::string()) + "): " +
         (step.kept ? "kept"
          : step.refused_halving()
              ? "not kept: it would halve the error, but with these held-out groups that may be chance"
              : "not kept");
}

std::string recommendation(const FitResult& result) {
  const FormFit &best = result.ranking.front(), &chosen = result.ranking[result.recommended];
  if (&chosen == &best) return "";
  if (best.verdict == Verdict::breaks_energy)
    return "recommended: " + chosen.form + ", the first form that conserves energy";
  return "recommended: " + chosen.form + ", which is " + (usable(best.verdict) ? "simpler" : "usable") +
         " and has no larger held-out error";
}

std::vector<std::string> sheet_in_words(const FitResult& result) {
  constexpr std::size_t kMost = 5;
  std::vector<std::string> lines;
  for (const sheet::Finding* f : result.sheet.faults()) {
    if (lines.size() == kMost) {
      lines.back() += " (and others: brdf validate lists all)";
      break;
    }
    lines.push_back(f->check + (f->outcome == sheet::Outcome::fail ? " fails: " : " is undecided: ") +
                    f->statement);
  }
  return lines;
}

std::string scatter_text(const FitResult& result) {
  if (!result.noise_floor)
    return "measurement noise: not known (" +
           (result.refuted_noise.empty() ? "rows are too few, too far apart or too smooth"
                                         : result.refuted_noise) +
           ")";
  const auto rows =
      std::ranges::find(result.sheet.scatter.agreements, *result.noise_floor, &sheet::Agreement::value);
  std::string text =
      rows != result.sheet.scatter.agreements.end()
          ? "measurement noise: " + io::percent(*result.noise_floor) + ", estimated from " +
                std::string(rows->rows) + " rows" +
                (rows->needs_isotropy && result.sheet.scatter.isotropy == sheet::Isotropy::unknown
                     ? " as if the sample were isotropic"
                     : "")
          : "measurement noise: " + io::percent(*result.noise_floor) + ", scatter about a smooth surface";
  if (result.channels.size() == 1 || result.channels.size() > kListedChannels) return text;
  std::string channels;
  for (std::size_t c = 0; c < result.channels.size(); ++c)
    channels += (c ? ", " : "") + result.channels[c] + " " +
                (result.channel_noise[c] ? io::percent(*result.channel_noise[c]) : "not known");
  return text + " (" + channels + ")";
}

void print(std::ostream& out, const FitResult& result, const io::SampleTable& table,
           const FitOptions& options, const TextStyle& style) {
  out << io::printable(table.source) << ": " << io::plural(result.rows, "row") << ", "
      << io::plural(result.channels.size(), "channel") << ", residual " << name_of(result.metric.metric)
      << '\n';
  if (!result.metric.asked)
    out << "  metric: " << name_of(result.metric.metric) << " (chosen: " << result.metric.reason << ")\n";
  if (result.beyond_max_theta)
    out << "  " << io::plural(result.beyond_max_theta, "row") << " beyond " << options.max_theta
        << " degrees left out (--max-theta)\n";
  if (result.outside_domain)
    out << "  " << io::plural(result.outside_domain, "row")
        << " left out: negative values, for which this metric has no residual\n";
  if (options.free_scale)
    out << "  values divided by the scale " << io::short_number(table.scale, 6)
        << ", which is not known: weights are relative\n";
  for (const std::string& fault : sheet_in_words(result))
    out << "  the measurements: " << io::printable(fault) << '\n';
  out << "  " << scatter_text(result) << '\n';
  if (result.interrupted) out << "  interrupted: these are the results so far\n";
  for (const Step& step : result.steps) out << "  " << in_words(step) << '\n';
  print_ranking(out, result, style);
  if (result.ranking.empty()) return;
  const FormFit& best = result.ranking.front();
  const io::Mark mark = mark_of(best);
  out << best.form << ", " << shown(std::string(name_of(best.verdict)), mark, style) << ": "
      << shown(std::string(io::look_of(mark).word), mark, style) << '\n';
  out << "  " << shown(verdict_sentence(best), mark, style) << '\n';
  for (const std::string& finding : best.findings) out << "  " << finding << '\n';
  for (const Condition condition : conditions_of(best))
    if (const std::string text = sentence_of(condition, best); !text.empty()) out << "  " << text << '\n';
  if (const std::string weak = weakness_text(best); !weak.empty()) out << "  " << weak << '\n';
  if (best.solved()) out << "  lack of fit: " << in_words(best.lack_of_fit) << '\n';
  if (const std::string others = others_in_words(best.lack_of_fit); !others.empty())
    out << "  " << others << '\n';
  for (const Estimate& e : best.estimates)
    if (const NamedParameter parameter = named(best, e); !parameter.repeats)
      out << "  " << estimate_text(e, label(parameter.symbol, e.channel), best.lack_of_fit.beyond_scatter)
          << '\n';
  for (const SmoothCurve& curve : best.smooth) out << "  " << in_words(curve) << '\n';
  if (has_intervals(best)) out << "  " << io::printable(scope_of_intervals(best)) << '\n';
  for (const std::string& line : budget_in_words(best)) out << "  " << io::printable(line) << '\n';
  if (const std::string text = recommendation(result); !text.empty()) out << text << '\n';
}

}  // namespace brdf::fit
