#include "fit/report/first_screen.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/report/page.h"
#include "fit/report/page_values.h"
#include "fit/report/plain_words.h"
#include "fit/report/states.h"
#include "io/colour/channel_colours.h"
#include "io/colour/in_colour.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "sheet/checks.h"

namespace brdf::fit {
namespace {

using io::Mark;

// Returns the value of the first of these keys that the header has, in any case of its letters.
std::string stated(const io::SampleTable& table, const std::vector<std::string_view>& keys) {
  constexpr std::size_t kLongest = 80;
  for (const std::string_view key : keys)
    for (const auto& [name, value] : table.metadata)
      // A value in braces is the JSON of a synthetic material, not a name.
      if (io::lower_case(name) == key && !value.empty() && !value.starts_with('{'))
        return value.size() > kLongest ? io::printable(value, kLongest) + " ..." : io::printable(value);
  return "";
}

// Returns "2,885".
std::string with_commas(std::size_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string channels_text(const std::vector<std::string>& channels) {
  constexpr std::size_t kListed = 4;
  std::vector<double> bands;
  for (const std::string& channel : channels)
    if (const auto nm = io::wavelength_of(channel)) bands.push_back(*nm);
  const bool spectral = bands.size() == channels.size();
  if (spectral && channels.size() > kListed) {
    const auto [low, high] = std::ranges::minmax_element(bands);
    return std::to_string(channels.size()) + " wavelengths, " + io::short_number(*low) + " to " +
           io::short_number(*high) + " nm";
  }
  std::vector<std::string> names(channels.begin(),
                                 channels.begin() + std::ptrdiff_t(std::min(channels.size(), kListed)));
  if (channels.size() > kListed) names.emplace_back("...");
  return io::plural(channels.size(), spectral ? "wavelength" : "channel") + " (" + io::joined(names) + ")";
}

std::string rows_text(const io::SampleTable& table) {
  std::string text = with_commas(table.rows()) + (table.rows() == 1 ? " measurement" : " measurements");
  if (table.rows() == 0) return text;
  if (sheet::is_of_cells(table)) return text + " in cells of half angles";
  std::vector<double> angles = table.theta_i;
  std::ranges::sort(angles);
  constexpr double kSameAngle = 1e-4;  // degrees
  angles.erase(
      std::unique(angles.begin(), angles.end(), [](double a, double b) { return b - a < kSameAngle; }),
      angles.end());
  const std::string low = io::short_number(angles.front()), high = io::short_number(angles.back());
  return text +
         (angles.size() == 1
              ? ", 1 angle of incidence, " + low
              : ", " + with_commas(angles.size()) + " angles of incidence, " + low + " to " + high) +
         "\u00b0";
}

std::string median_text(double error) {
  constexpr double kLeastShown = 1e-11;
  return error < kLeastShown ? "below 1e-9 %" : io::percent(error, 2);
}

// Returns the angle of incidence, in degrees, at which the measurements leave the energy undecided by the
// largest margin; std::nullopt if no integral exists.
std::optional<double> undecided_incidence(const sheet::DataSheet& sheet) {
  std::optional<double> worst;
  double most = 1;
  for (const sheet::MeasuredAlbedo& a : sheet.albedo)
    for (std::size_t c = 0; c < a.value.size(); ++c)
      if (const double bound = a.value[c] + a.bound[c]; bound > most) {
        most = bound;
        worst = a.theta_i;
      }
  return worst;
}

const sheet::Finding* energy_of_measurements(const FitResult& result) {
  const auto found = std::ranges::find(result.sheet.findings, "energy", &sheet::Finding::check);
  return found == result.sheet.findings.end() ? nullptr : &*found;
}

bool is_undecided(const sheet::Finding* finding) {
  return finding && finding->outcome == sheet::Outcome::undecided;
}

// The box judges again in the browser. Its sentence has the parts of tolerance_sentence(); a browser test
// compares the two.
constexpr std::string_view kToleranceScript = R"(
for (const box of document.querySelectorAll(".tolerance")) {
  const input = box.querySelector("input"), said = box.querySelector("output");
  const errors = JSON.parse(box.dataset.errors), median = Number(box.dataset.value);
  const judge = () => {
    const limit = input.valueAsNumber / 100;
    if (!(limit > 0)) {
      said.className = "";
      said.textContent = "Enter a tolerance in percent to judge this fit.";
      return;
    }
    const within = errors.filter((e) => e <= limit).length, good = median <= limit;
    const share = within === 0 ? 0 : Math.round(100 * (within - 1) / (errors.length - 1));
    said.className = good ? "good" : "bad";
    said.textContent = (good ? "Within" : "Outside") + " the tolerance: the median error (fitted), " + box.dataset.median
      + ", is " + (good ? "at most " : "above ") + Number(input.value) + " %.";
    box.querySelector(".share").textContent = share + " % of the measured values have an error of at most "
      + Number(input.value) + " %.";
  };
  input.addEventListener("input", judge);
  judge();
}
)";

void add_tolerance(io::HtmlReport& report, const FitResult& result, const io::SampleTable& table,
                   const FitOptions& options, std::optional<double> tolerance) {
  const FormFit& best = result.ranking.front();
  const ErrorQuantiles quantiles = error_quantiles(best, table, options);
  if (quantiles.errors.empty()) return;
  std::string list;
  for (const double error : quantiles.errors)
    list += (list.empty() ? "[" : ",") + io::short_number(std::min(error, 1e6), 4);
  const std::string value = tolerance ? " value=\"" + io::short_number(100 * *tolerance) + "\"" : "";
  report.script(kToleranceScript);
  std::string said;
  if (tolerance)
    said = "<output class=\"" + std::string(is_within(best, *tolerance) ? "good" : "bad") + "\">" +
           io::html_escaped(tolerance_sentence(best, *tolerance)) + "</output>";
  else
    said = "<output></output>";
  report.raw("<p class=\"tolerance\" data-errors=\"" + list + "]\" data-value=\"" +
             io::to_text(best.median_relative_error) + "\" data-median=\"" +
             median_text(best.median_relative_error) +
             "\"><label>Tolerance <input type=\"number\" min=\"0\" max=\"100\" step=\"any\"" + value +
             "> %</label>" + said + " <span class=\"share\"></span></p>");
}

}  // namespace

std::vector<io::Fact> facts_of(const io::SampleTable& table) {
  return {{"material", stated(table, {"sample", "material", "sample_name", "specimen", "name"})},
          {"instrument", stated(table, {"instrument", "device", "setup", "apparatus"})},
          {"date", stated(table, {"date", "measured_on", "measurement_date", "measured"})},
          {"operator", stated(table, {"operator", "measured_by", "technician", "author"})},
          {"", channels_text(table.channels)},
          {"", rows_text(table)}};
}

ErrorQuantiles error_quantiles(const FormFit& fit, const io::SampleTable& table, const FitOptions& options) {
  const auto fitted = fitted_values(fit.material, unit_directions(table).view(), aperture_of(table, options));
  std::vector<double> errors;
  for (std::size_t c = 0; c < fitted.size(); ++c)
    for (std::size_t k = 0; k < table.rows(); ++k)
      if (const double g = table.values[c][k]; g > 0 && !table.is_beyond(k, options.max_theta))
        errors.push_back(std::abs(fitted[c][k] - g) / g);
  ErrorQuantiles out;
  if (errors.empty()) return out;
  std::ranges::sort(errors);
  for (int step = 0; step <= ErrorQuantiles::kSteps; ++step)
    out.errors.push_back(
        errors[std::min(errors.size() * std::size_t(step) / ErrorQuantiles::kSteps, errors.size() - 1)]);
  return out;
}

double tolerance_of(const std::string& text) {
  std::string_view number = io::trimmed(text);
  const bool is_percent = number.ends_with('%');
  if (is_percent) number = io::trimmed(number.substr(0, number.size() - 1));
  double value = 0;
  const bool is_number = io::parse_number(number, value);
  if (is_percent) value /= 100;
  if (!is_number || !(value > 0 && value <= 1))
    throw InputError("--tolerance: " + io::shown(text) +
                     " is not a share above 0 and at most 100 %; write 5% or 0.05");
  return value;
}

bool is_within(const FormFit& fit, double tolerance) {
  return fit.solved() && fit.median_relative_error <= tolerance;
}

std::string tolerance_sentence(const FormFit& fit, double tolerance) {
  const bool good = is_within(fit, tolerance);
  if (!fit.solved()) return "Outside the tolerance: no form could be fitted.";
  return std::string(good ? "Within" : "Outside") + " the tolerance: the median error (fitted), " +
         median_text(fit.median_relative_error) + ", is " + (good ? "at most " : "above ") +
         io::short_number(100 * tolerance) + " %.";
}

std::vector<io::Remark> energy_remarks(const FitResult& result) {
  std::vector<io::Remark> remarks;
  const FormFit& best = result.ranking.front();
  if (best.solved() && best.largest_albedo && !best.has_free_scale && !best.largest_albedo->breaks_energy())
    remarks.push_back(
        {Mark::good,
         "Energy: the largest albedo of the fitted material at ten or more angles of incidence up "
         "to 85 degrees is " +
             io::percent(best.largest_albedo->value) + " (at " +
             io::short_number(best.largest_albedo->theta) + " degrees)."});
  if (const sheet::Finding* const energy = energy_of_measurements(result);
      is_undecided(energy) && !energy->is_suspicion)
    remarks.push_back({Mark::unknown, "Energy of the measurements: undecided, " + energy->statement + "."});
  return remarks;
}

std::string next_step(const FitResult& result) {
  const FormFit& best = result.ranking.front();
  if (!best.solved()) return "try other forms with --form all";
  if (!usable(best.verdict))
    return result.ranking.size() == 1 ? "try other forms with --form all"
                                      : "try a sum of forms with --form auto";
  if (is_undecided(energy_of_measurements(result))) {
    const std::optional<double> theta = undecided_incidence(result.sheet);
    return theta ? "measure more viewing directions at incidence " + io::short_number(*theta, 3) +
                       " degrees, so that the energy is decided"
                 : std::string(
                       "measure viewing directions outside the plane of incidence, so that the energy is "
                       "decided");
  }
  for (const Condition condition : conditions_of(best)) {
    if (condition == Condition::hidden_highlight)
      return "measure more densely around the mirror direction, where a highlight may be hidden";
    if (condition == Condition::few_lights || condition == Condition::interpolates)
      return "measure more angles of incidence, so that the held-out error tests predictions";
    if (condition == Condition::scatter_unknown)
      return best.lack_of_fit.judged() ? "rotate the sample, so that isotropy is tested"
                                       : "repeat some measurements, so that the measurement noise is known";
    if (condition == Condition::roughly)
      return result.ranking.size() == 1 ? "try other forms with --form all"
                                        : "try a sum of forms with --form auto";
  }
  return "";
}

void add_first_screen(io::HtmlReport& report, const FitResult& result, const io::SampleTable& table,
                      const FitOptions& options, std::optional<double> tolerance,
                      const std::string& command) {
  report.facts(facts_of(table));
  add_verdict(report, result);
  if (result.ranking.front().solved()) add_tolerance(report, result, table, options, tolerance);
  const std::string next = next_step(result);
  if (next.empty() && command.empty()) return;
  report.raw("<p class=\"next\">Next: " + io::html_escaped(next.empty() ? "look at it" : next) +
             (command.empty() ? "." : (next.empty() ? ":" : "; look at it:")) +
             (command.empty() ? "" : "<code>" + io::html_escaped(command) + "</code>") + "</p>");
}

}  // namespace brdf::fit
