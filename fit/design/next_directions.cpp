#include "fit/design/next_directions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "fit/assess/paired.h"
#include "fit/assess/reported.h"
#include "fit/assess/select.h"
#include "fit/candidates.h"
#include "fit/choice.h"
#include "fit/design/chosen.h"
#include "fit/design/forecast.h"
#include "fit/stepwise.h"
#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kMostStart = 400;  // measured rows that are taken one by one
constexpr std::size_t kExamined = 64;    // rows that are chosen at least, to see where a row stops to pay
constexpr std::size_t kDraws = 20;
constexpr std::size_t kSizes[] = {4, 8, 16, 32};
constexpr double kNothingToTell = 0.5;  // of the logarithm of the likelihood ratio

std::vector<std::size_t> sizes_for(std::size_t rows, std::size_t most) {
  std::set<std::size_t> out(std::begin(kSizes), std::end(kSizes));
  out.insert(rows);
  std::erase_if(out, [&](std::size_t n) { return n > most; });
  return {out.begin(), out.end()};
}

std::span<const std::size_t> first_of(const std::vector<std::size_t>& order, std::size_t count) {
  return {order.data(), std::min(count, order.size())};
}

// Returns the number of rows after which no number of further rows lowers the error by kLeastGain per row on
// average: a single row may lower it by more. `errors`: after each number of rows. Returns std::nullopt if
// there is no such number.
std::optional<std::size_t> worthwhile_rows(const std::vector<double>& errors) {
  for (std::size_t n = 0; n + 1 < errors.size(); ++n) {
    bool pays = false;
    double least = errors[n];
    for (std::size_t j = n + 1; j < errors.size() && !pays; ++j)
      pays = errors[j] <= (least *= 1 - NextDirections::kLeastGain);
    if (!pays) return n;
  }
  return std::nullopt;
}

void add_forecast(const Solved& solved, const Rows& rows, const Rows& few, double repeats,
                  const Chosen& chosen, const std::vector<std::vector<std::size_t>>& draws,
                  NextDirections& out) {
  const Forecast all(solved, rows.start, repeats, rows.candidates, rows.hemisphere, out.known),
      part(solved, few.start, repeats, few.candidates, few.hemisphere, out.known);
  const std::size_t count = out.rows.size();
  const std::vector<ExpectedWidth> now = all.widths({}), after = all.widths(first_of(chosen.order, count));
  for (std::size_t k = 0; k < now.size(); ++k) out.widths.push_back({now[k], after[k], 0, true});
  for (const auto& draw : draws) {
    const std::vector<ExpectedWidth> random = all.widths(first_of(draw, count));
    for (std::size_t k = 0; k < random.size(); ++k) {
      out.widths[k].random += random[k].error / double(draws.size());
      out.widths[k].random_determined = out.widths[k].random_determined && random[k].determined;
    }
  }
  std::vector<double> errors;  // after each number of rows
  for (std::size_t n = 0; n <= chosen.order.size(); ++n)
    errors.push_back(part.prediction_error(first_of(chosen.order, n)));
  out.error_now = errors[0];
  for (std::size_t k = 0; k < count; ++k) out.rows[k].error = errors[k + 1];
  if (out.aim == Aim::prediction) out.worthwhile = worthwhile_rows(errors);
  for (const std::size_t n : sizes_for(count, chosen.order.size())) {
    NextForecast f{n, errors[n], 0};
    for (const auto& draw : draws)
      f.random += part.prediction_error(first_of(draw, n)) / double(draws.size());
    out.errors.push_back(f);
  }
}

void add_ratios(const Rows& a, const Rows& b, const Chosen& chosen,
                const std::vector<std::vector<std::size_t>>& draws, NextDirections& out) {
  std::vector<double> random(chosen.order.size(), 0.0);
  for (const auto& draw : draws) {
    Rivals rivals = rivals_of(a, b, out.known);
    double sum = 0;
    for (std::size_t k = 0; k < draw.size(); ++k) {
      sum += rivals.gains()[draw[k]];
      rivals.read(draw[k]);
      random[k] += sum / double(draws.size());
    }
  }
  double sum = 0;
  const std::vector<std::size_t> sizes = sizes_for(out.rows.size(), chosen.order.size());
  for (std::size_t k = 0; k < chosen.order.size(); ++k) {
    sum += chosen.gains[k];
    if (!out.decisive && sum >= std::log(NextDirections::kDecisive)) out.decisive = k + 1;
    if (std::ranges::find(sizes, k + 1) != sizes.end()) out.ratios.push_back({k + 1, sum, random[k]});
  }
}

// Returns whether the second form of a ranking is within a standard error of the first, by the rows that
// were left out.
bool is_close(const FitResult& ranked) {
  if (ranked.ranking.size() < 2) return false;
  const FormFit &first = ranked.ranking[0], &second = ranked.ranking[1];
  if (!first.left_out || !second.left_out || !second.solved()) return false;
  const PairedTest test =
      paired_test(ranked.groups.groups, second.left_out->by_group, first.left_out->by_group);
  return second.left_out->value - first.left_out->value <= test.standard_error;
}

void require_enough(const FitData& data, const Solved& solved, const std::string& source) {
  const std::size_t values = data.rows() * data.channels.size();
  if (values >= solved.model.size()) return;
  throw InputError(source + ": " + io::plural(values, "value") + " cannot determine the " +
                   io::plural(solved.model.size(), "parameter") + " of " + solved.model.name() +
                   ": measure more rows first, name a simpler form, or hold parameters with --fix");
}

// The solved models, best first.
struct RankedModels {
  Candidates candidates;
  FitResult result;
  std::vector<std::size_t> order;

  const Solved& at(std::size_t place) const { return candidates.all[order[place]]; }
};

RankedModels solve_ranked(const Prepared& p, std::vector<std::vector<Reflectance>> models,
                          const std::string& source, const Progress& progress) {
  if (models.empty()) models = models_of(fit_stepwise(p, progress).ranking.front().form);
  FitOptions options = p.options;
  options.profiles = false;
  options.cross_validation = options.cross_validation && models.size() > 1;
  RankedModels out{solve_candidates(p, models, options, progress), {}, {}};
  out.result = out.candidates.about;
  for (const Solved& s : out.candidates.all) out.result.ranking.push_back(s.fit);
  out.order = rank(out.result);
  if (!out.at(0).fit.solved()) throw InputError(source + ": no form could be fitted");
  require_enough(p.data, out.at(0), source);
  return out;
}

// Decides what the further rows are for.
Aim aim_of(const RankedModels& ranked, const NextOptions& next) {
  const bool has_rival = ranked.order.size() > 1 && ranked.at(1).fit.solved();
  if (next.aim == Aim::forms && !has_rival)
    throw InputError(
        "--aim forms: needs two forms that can be fitted: name both, as in --form ward "
        "--form cook_torrance");
  if (next.aim != Aim::automatic) return next.aim;
  return has_rival && is_close(ranked.result) ? Aim::forms : Aim::prediction;
}

void add_findings(const Solved& solved, NextDirections& out) {
  const FormFit& f = solved.fit;
  if (f.verdict == Verdict::misfit)
    out.findings.push_back(
        "the form does not fit the samples: the choice is for this form, and another form "
        "may need other directions");
  std::vector<std::string> unknown;
  for (const NextWidth& w : out.widths)
    if (!w.now.determined) unknown.push_back(label(w.now.name, w.now.channel));
  if (!unknown.empty())
    out.findings.push_back("the measured rows do not determine " + listed(unknown) +
                           ": the choice assumes that each parameter alone may change the logarithm of the "
                           "values by 1 (root mean square over the hemisphere)");
}

// States which part of the measured rows and channels the choice uses.
void add_shortcuts(const FitData& measured, const FitData& start, const Rows& few, NextDirections& out) {
  if (start.rows() < measured.rows())
    out.findings.push_back("the choice takes " + std::to_string(start.rows()) + " of the " +
                           std::to_string(measured.rows()) +
                           " measured rows, spread over all, each for several");
  if (few.start.channels() < measured.channels.size())
    out.findings.push_back("the choice uses " + io::plural(few.start.channels(), "channel") + " of " +
                           std::to_string(measured.channels.size()) +
                           ": the first, the middle and the last one");
}

void note_rows(const Chosen& chosen, const Reachable& within, const io::SampleTable& reach, std::size_t count,
               NextDirections& out) {
  out.examined = chosen.order.size();
  for (std::size_t k = 0; k < std::min(count, chosen.order.size()); ++k) {
    const std::size_t row = within.rows[chosen.order[k]];
    NextRow next{row, reach.theta_i[row], reach.phi_i[row], reach.theta_o[row], reach.phi_o[row]};
    next.for_parameters = k < chosen.for_parameters;
    next.gain = chosen.gains[k];
    if (!chosen.differences.empty()) next.difference = chosen.differences[k];
    out.rows.push_back(next);
  }
}

double sum_of_first(const std::vector<double>& gains, std::size_t count) {
  double sum = 0;
  for (std::size_t k = 0; k < std::min(count, gains.size()); ++k) sum += gains[k];
  return sum;
}

}  // namespace

NextModels next_models(const std::string& forms, NextOptions next) {
  io::require_between("--rows", double(next.rows), 1, double(NextOptions::kMostRows));
  if (next.noise) io::require_between("--noise", *next.noise, NextOptions::kLeastNoise, 1);
  if (next.model_error) io::require_between("--model-error", *next.model_error, 0, 1);
  NextModels out{models_of(forms), std::move(next)};
  if (forms.find(',') != forms.npos && out.next.aim == Aim::automatic) out.next.aim = Aim::forms;
  return out;
}

NextDirections next_directions(const Samples& samples, const io::SampleTable& reach,
                               std::vector<std::vector<Reflectance>> models, const FitOptions& options,
                               const NextOptions& next, const Progress& progress) {
  NextDirections out;
  const Prepared p = prepared(samples, options);
  const Reachable within = reachable(reach, p.data, options, out);
  const RankedModels ranked = solve_ranked(p, std::move(models), samples.table.name(), progress);
  const Solved& best = ranked.at(0);
  const FitData start = thinned(p.data, kMostStart);
  const double repeats = double(p.data.rows()) / double(start.rows());
  Rows rows = rows_of(best, start, within.data, p.options);
  out.known = known_of(p, start, rows.start, samples.table.name(), next);
  weigh(within.data, start, out.known.noise, rows);
  std::vector<bool> free = rows.candidates.usable;
  out.dark = std::size_t(std::ranges::count(free, false));
  const std::size_t possible = free.size() - out.dark, count = std::min(next.rows, possible);
  if (possible == 0)
    throw InputError(reach.name() +
                     ": no direction can be chosen: each is beyond --max-theta, is measured "
                     "already, or has no value above 0 in the fitted form");
  out.form = best.model.name();
  out.measured = p.data.rows();
  out.parameters = best.model.size();
  out.reach_has_values = !reach.channels.empty();
  out.seed = options.seed;
  out.draws = kDraws;
  out.aim = aim_of(ranked, next);
  const Rows few = of_few_channels(rows);
  const std::size_t examined = std::min(std::max(next.rows, kExamined), possible);
  Chosen chosen;
  Rows other;
  if (out.aim == Aim::forms) {
    const Solved& rival = ranked.at(1);
    other = of_few_channels(rows_of(rival, start, within.data, p.options));
    std::vector<bool> of_both = free;
    for (std::size_t k = 0; k < free.size(); ++k) of_both[k] = free[k] && other.candidates.usable[k];
    const auto left = std::size_t(std::ranges::count(of_both, true));
    chosen = choose_for_forms(few, other, out.known, of_both, std::min(examined, left));
    if (next.aim == Aim::automatic && sum_of_first(chosen.gains, count) < kNothingToTell) {
      out.findings.push_back(best.model.name() + " and " + rival.model.name() +
                             " predict so nearly the same that " + io::plural(count, "row") +
                             " of the directions cannot distinguish them: the rows are "
                             "chosen for the prediction");
      out.aim = Aim::prediction;
    } else {
      out.rival = rival.model.name();
      free = of_both;
    }
  }
  if (out.aim == Aim::prediction) chosen = choose_for_prediction(few, repeats, out.known, free, examined);
  note_rows(chosen, within, reach, count, out);
  if (out.rows.size() < next.rows)
    out.findings.push_back(io::plural(next.rows, "row") + " were asked for, but " + reach.name() +
                           " has only " + io::plural(out.rows.size(), "direction") + " that can be chosen");
  Random random(options.seed);
  std::vector<std::vector<std::size_t>> draws;
  for (std::size_t k = 0; k < kDraws; ++k) draws.push_back(drawn(free, chosen.order.size(), random));
  add_forecast(best, rows, few, repeats, chosen, draws, out);
  if (out.aim == Aim::forms) add_ratios(few, other, chosen, draws, out);
  add_findings(best, out);
  add_shortcuts(p.data, start, few, out);
  return out;
}

}  // namespace brdf::fit
