#include "fit/design/next_report.h"

#include <cmath>
#include <iomanip>
#include <ostream>

#include "fit/assess/reported.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

constexpr double kStatedNoise = 0.01;  // the noise of the column for comparison

std::string noise_words(const NoiseAndError& known) {
  const std::string size = "noise of a reading: " + io::percent(known.noise) + " ";
  switch (known.noise_from) {
    case NoiseFrom::option:
      return size + "(--noise)";
    case NoiseFrom::stated:
      return size + "(the median of the columns of sigma)";
    case NoiseFrom::table:
      return size + "(from the samples themselves: rows that must agree)";
    case NoiseFrom::residuals:
      return size + "(from the residuals of the fit, " + io::short_number(known.freedom) +
             (known.freedom == 1 ? " degree of freedom)" : " degrees of freedom)");
  }
  return size;
}

std::string error_words(const NoiseAndError& known) {
  const std::string size = "error of the form: ";
  switch (known.error_from) {
    case ErrorFrom::option:
      return size + io::percent(known.error) + " (--model-error)";
    case ErrorFrom::residuals:
      return size + io::percent(known.error) + " (neighbouring residuals agree more than noise does)";
    case ErrorFrom::undetected:
      return size +
             "not detected in the residuals, taken as 0; if the form is in doubt, state an error, as in "
             "--model-error 0.02";
    case ErrorFrom::assumed:
      return size + "cannot be seen with fewer than " + io::short_number(kFewValues) +
             " values per parameter; assumed to be " + io::short_number(kAssumedError) +
             " times the noise, " + io::percent(known.error);
  }
  return size;
}

std::string aim_words(const NextDirections& n) {
  if (n.aim == Aim::forms)
    return "chosen to tell " + n.form + " from " + n.rival +
           ": the largest difference after either form is refitted, in first order, to the other's values";
  const std::string values =
      "the expected error of the values over the hemisphere (integrated variance, weighted by cosines)";
  if (n.known.error > 0) return "chosen to lower " + values;
  return "chosen to determine the parameters together, with one row more than there are parameters, then to "
         "lower " +
         values +
         (n.known.error_from == ErrorFrom::undetected
              ? ", with an error of the form as large as the noise, which residuals would not show"
              : "");
}

std::string left_out_words(const NextDirections& n) {
  std::vector<std::string> parts;
  if (n.already_measured > 0) parts.push_back(std::to_string(n.already_measured) + " measured or repeated");
  if (n.beyond_max_theta > 0) parts.push_back(std::to_string(n.beyond_max_theta) + " beyond --max-theta");
  if (n.dark > 0) parts.push_back(std::to_string(n.dark) + " without a value above 0 in the form");
  return parts.empty() ? "" : " (left out: " + io::joined(parts) + ")";
}

void print_rows(std::ostream& out, const NextDirections& n) {
  const bool forms = n.aim == Aim::forms;
  out << "\n  row   theta_i     phi_i   theta_o     phi_o  "
      << (forms ? "ln of the ratio  difference" : "expected error  chosen for") << '\n';
  for (std::size_t k = 0; k < n.rows.size(); ++k) {
    const NextRow& r = n.rows[k];
    out << std::setw(5) << k + 1;
    for (const double angle : {r.theta_i, r.phi_i, r.theta_o, r.phi_o})
      out << std::setw(10) << io::short_number(angle, 6);
    if (forms)
      out << std::setw(17) << io::short_number(r.gain, 3) << std::setw(12) << io::percent(r.difference);
    else
      out << std::setw(16) << io::percent(r.error) << (r.for_parameters ? "  parameters" : "  values");
    out << '\n';
  }
}

std::string relative(const ExpectedWidth& w, double error, bool determined) {
  if (!determined) return "unknown";
  return w.value != 0 ? io::percent(error / std::abs(w.value)) : io::short_number(error, 3);
}

void print_widths(std::ostream& out, const NextDirections& n) {
  out << "\nstandard error that `brdf fit` is expected to report, from the noise alone:\n  " << std::left
      << std::setw(20) << "parameter" << std::right << std::setw(12) << "value" << std::setw(10) << "now"
      << std::setw(12) << ("+" + io::plural(n.rows.size(), "row")) << std::setw(14) << "the same at"
      << std::setw(12) << "at random" << '\n'
      << "  " << std::setw(68) << "1 % noise" << '\n';
  for (const NextWidth& w : n.widths)
    out << "  " << std::left << std::setw(20) << label(w.now.name, w.now.channel) << std::right
        << std::setw(12) << io::short_number(w.now.value) << std::setw(10)
        << relative(w.now, w.now.error, w.now.determined) << std::setw(12)
        << relative(w.after, w.after.error, w.after.determined) << std::setw(14)
        << relative(w.after, w.after.error * kStatedNoise / n.known.noise, w.after.determined)
        << std::setw(12) << relative(w.after, w.random, w.random_determined) << '\n';
}

void print_forecasts(std::ostream& out, const NextDirections& n) {
  out << "\nexpected error of the refitted form over the hemisphere, now " << io::percent(n.error_now)
      << " (at random: mean of " << n.draws << " draws, seed " << n.seed
      << "):\n  rows    chosen  at random\n";
  for (const NextForecast& f : n.errors)
    out << std::setw(6) << f.rows << std::setw(10) << io::percent(f.chosen) << std::setw(11)
        << io::percent(f.random) << '\n';
  if (n.aim == Aim::forms) {
    out << "\nexpected logarithm of the likelihood ratio of the two forms:\n  rows    chosen  at random\n";
    for (const NextForecast& f : n.ratios)
      out << std::setw(6) << f.rows << std::setw(10) << io::short_number(f.chosen, 3) << std::setw(11)
          << io::short_number(f.random, 3) << '\n';
  }
}

std::string end_words(const NextDirections& n) {
  if (n.aim == Aim::forms) {
    const std::string ratio = "a likelihood ratio of " + io::short_number(NextDirections::kDecisive);
    return n.decisive ? ratio + " is expected after " + io::plural(*n.decisive, "row")
                      : ratio + " is not expected within " + io::plural(n.examined, "row");
  }
  if (!n.worthwhile && n.is_exhausted())
    return "no direction is left: up to the last of " + io::plural(n.examined, "row") +
           ", further rows lower the expected error by 1 % or more per row on average";
  if (!n.worthwhile)
    return "up to the last of the " + io::plural(n.examined, "row") +
           " that were examined, further rows lower the expected error by 1 % or more per row on average";
  return "after " + io::plural(*n.worthwhile, "row") +
         ", any number of further rows lowers the expected error by less than 1 % per row on average (" +
         io::plural(n.examined, "row") + " examined)";
}

}  // namespace

void print(std::ostream& out, const NextDirections& n, const NextSources& sources) {
  out << n.form << " fitted to " << io::plural(n.measured, "row") << " of " << sources.samples << " ("
      << io::plural(n.parameters, "parameter") << ")\n"
      << io::plural(n.reach, "direction") << " of " << sources.reach << left_out_words(n)
      << (n.reach_has_values ? "; its values are not used" : "") << '\n'
      << noise_words(n.known) << '\n'
      << error_words(n.known) << '\n'
      << aim_words(n) << '\n';
  for (const std::string& finding : n.findings) out << finding << '\n';
  print_rows(out, n);
  print_widths(out, n);
  print_forecasts(out, n);
  out << end_words(n) << '\n';
}

io::Json to_json(const NextDirections& n, const NextSources& sources) {
  const auto forecasts = [](const std::vector<NextForecast>& list) {
    io::Json out = io::Json::array();
    for (const NextForecast& f : list)
      out.push_back({{"rows", f.rows}, {"chosen", f.chosen}, {"random", f.random}});
    return out;
  };
  const auto width = [](double error, bool determined) { return determined ? io::Json(error) : io::Json(); };
  io::Json rows = io::Json::array(), widths = io::Json::array();
  for (const NextRow& r : n.rows) {
    io::Json row = {{"row", r.row},     {"theta_i", r.theta_i}, {"phi_i", r.phi_i}, {"theta_o", r.theta_o},
                    {"phi_o", r.phi_o}, {"gain", r.gain},       {"error", r.error}};
    if (n.aim == Aim::forms)
      row["difference"] = r.difference;
    else
      row["chosen_for"] = r.for_parameters ? "parameters" : "values";
    rows.push_back(std::move(row));
  }
  for (const NextWidth& w : n.widths) {
    io::Json entry = {
        {"parameter", w.now.name},
        {"value", w.now.value},
        {"now", width(w.now.error, w.now.determined)},
        {"after", width(w.after.error, w.after.determined)},
        {"after_at_1_percent_noise", width(w.after.error * kStatedNoise / n.known.noise, w.after.determined)},
        {"random", width(w.random, w.random_determined)}};
    if (!w.now.channel.empty()) entry["channel"] = w.now.channel;
    widths.push_back(std::move(entry));
  }
  io::Json out = {{"samples", sources.samples},
                  {"reach", sources.reach},
                  {"form", n.form},
                  {"aim", name_of(n.aim)},
                  {"measured", n.measured},
                  {"parameters", n.parameters},
                  {"directions",
                   {{"given", n.reach},
                    {"measured_or_repeated", n.already_measured},
                    {"beyond_max_theta", n.beyond_max_theta},
                    {"without_value", n.dark}}},
                  {"noise", {{"value", n.known.noise}, {"from", name_of(n.known.noise_from)}}},
                  {"model_error", {{"value", n.known.error}, {"from", name_of(n.known.error_from)}}},
                  {"rows", std::move(rows)},
                  {"standard_errors", std::move(widths)},
                  {"error_now", n.error_now},
                  {"errors", forecasts(n.errors)},
                  {"random_draws", n.draws},
                  {"examined", n.examined},
                  {"findings", n.findings},
                  {"provenance", io::to_json(io::provenance(n.seed))}};
  if (n.aim == Aim::forms) {
    out["rival"] = n.rival;
    out["log_likelihood_ratios"] = forecasts(n.ratios);
    out["decisive_after"] = n.decisive ? io::Json(*n.decisive) : io::Json();
  } else {
    out["worthwhile"] = n.worthwhile ? io::Json(*n.worthwhile) : io::Json();
  }
  return out;
}

io::SampleTable table_of(const NextDirections& n) {
  io::SampleTable out;
  for (const NextRow& r : n.rows) out.add_directions(r.theta_i, r.phi_i, r.theta_o, r.phi_o);
  out.add_comment("purpose", n.aim == Aim::forms ? "to tell " + n.form + " from " + n.rival
                                                 : "to lower the expected error of " + n.form);
  return out;
}

}  // namespace brdf::fit
