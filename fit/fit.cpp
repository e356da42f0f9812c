#include "fit/fit.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "fit/assess/hidden_lobe.h"
#include "fit/assess/lack_of_fit.h"
#include "fit/assess/left_out.h"
#include "fit/assess/refits.h"
#include "fit/assess/select.h"
#include "fit/candidates.h"
#include "fit/stepwise.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/parallel.h"

namespace brdf::fit {
namespace {

constexpr double kRoundingShare = 1e-18;  // of a squared residual, relative to that of a black surface

// Returns the solutions of a model's refits `numbers`, in order, or std::nullopt if the run was
// interrupted.
std::optional<RefitSolutions> refits_of(const Solved& s, const SampleStream& stream, RowRange numbers,
                                        const FitOptions& options) {
  RefitSolutions out(numbers.rows);
  std::atomic<bool> stopped{false};
  const auto solve = [&](std::size_t k) {
    if (options.stop()) stopped = true;
    if (!stopped) out[k] = refit(stream, s.p, numbers.first + k, options);
  };
  io::parallel_for(out.size(), solve, options.threads);
  if (stopped || options.stop()) return std::nullopt;
  return out;
}

// Evaluates the refits of a solved model.
void judge_by(RefitSolutions solutions, const SampleStream& stream, double loss_scale,
              const FitOptions& options, Solved& s) {
  const std::size_t folds = count_folds(stream.data().groups, options);
  const auto first = solutions.begin() + std::ptrdiff_t(folds);
  const RefitSolutions replicates(std::make_move_iterator(first), std::make_move_iterator(solutions.end()));
  solutions.resize(folds);
  add_bootstrap(s.model, replicates, s.fit.estimates);
  s.fit.replicates = replicates.size();
  if (folds == 0) return;
  s.fit.left_out = leave_out(stream, std::move(solutions), loss_scale, options);
  add_movement(s.model, s.p, s.fit.left_out->solutions, under_other_metrics(stream, s.p, options),
               s.fit.estimates);
}

// Computes the held-out values and the bootstrap of every form. A robust loss estimates its scale form by
// form. For a fair comparison all forms are judged with one scale, the smallest of these. `known` holds the
// refits of all models one after another, or is null.
void refit_all(const FitData& data, const FitOptions& options, const RefitSolutions* known,
               std::vector<Solved>& all, FitResult& result) {
  double scale = std::numeric_limits<double>::infinity();
  const Solved* tightest = nullptr;
  for (const Solved& s : all)
    if (s.fit.solved() && s.residual.loss.scale < scale) scale = (tightest = &s)->residual.loss.scale;
  if (!tightest) return;
  if (options.cross_validation)
    result.left_out_rounding = kRoundingShare * black_loss(data, tightest->model, tightest->residual);
  const std::size_t count = count_refits(data.groups, options);
  if (count == 0) return;
  const auto refit_model = [&](std::size_t k) {
    Solved& s = all[k];
    if (!s.fit.solved()) return;
    const SampleStream stream(data, s.model, s.residual, options.resolved_aperture());
    if (known) {
      const auto first = known->begin() + std::ptrdiff_t(k * count);
      judge_by({first, first + std::ptrdiff_t(count)}, stream, scale, options, s);
    } else if (auto solutions = refits_of(s, stream, {0, count}, options)) {
      judge_by(std::move(*solutions), stream, scale, options, s);
    }
  };
  io::parallel_for(all.size(), refit_model, options.threads);
}

// Returns why the residuals of a form refute the noise: residuals hold all of the noise, so a noise far above
// them is the shape of a lobe between rows that are too far apart. Empty if no form refutes it.
std::string refutation(const std::vector<Solved>& all, const FitData& data, double noise) {
  constexpr double kShape = 2, kChance = 2.4;  // as in sheet::Scatter::decisive
  constexpr double kFewest = 12;
  for (const Solved& s : all) {
    const double values = double(data.rows() * data.channels.size()),
                 free = values - double(s.fit.parameters),
                 ratio = s.fit.lack_of_fit.residual_over_scatter.value_or(HUGE_VAL);
    if (!s.fit.solved() || free < kFewest) continue;
    if (kShape * ratio * std::sqrt(values / free) * (1 + kChance / std::sqrt(free)) < 1)
      return "the residuals of " + s.fit.form + ", " + io::percent(ratio * noise) + ", refute a noise of " +
             io::percent(noise);
  }
  return {};
}

// Fits the models with the largest estimate of the noise that their residuals do not refute. Returns the part
// of this noise that is known to be noise.
std::optional<double> fit_with_noise(const Prepared& p, const std::vector<std::vector<Reflectance>>& models,
                                     const FitOptions& options, const Progress& progress, Candidates& out) {
  std::optional<double>& noise = out.about.noise_floor;
  std::optional<double> least = p.least_scatter();
  out.all = fit_models(p.data, models, options, noise, progress);
  while (noise && !options.stop()) {
    const std::string refuted = refutation(out.all, p.data, *noise);
    if (refuted.empty()) break;
    out.about.refuted_noise = refuted;
    // The next lower estimate takes its place, if there is one.
    noise = least && *least < *noise ? least : std::nullopt;
    least = noise;
    out.all = fit_models(p.data, models, options, noise, progress);
  }
  return least;
}

constexpr const char* kChooses = "--form auto: cannot be used with --bootstrap; name a form";

}  // namespace

namespace {

FitResult fit_prepared(const Prepared& p, const io::SampleTable& table,
                       const std::vector<std::vector<Reflectance>>& models, const Progress& progress,
                       const RefitSolutions* known) {
  if (models.empty() && p.options.bootstrap > 0) throw InputError(kChooses);
  if (p.options.bootstrap == 1)
    throw InputError("--bootstrap 1: one replicate has no spread: at least 2 are needed");
  if (models.empty()) return fit_stepwise(p, progress);
  if (known && known->size() != models.size() * count_refits(p.data.groups, p.options))
    throw InputError(table.source +
                     ": the number of solved refits differs from the number that its models need");
  return fit(p, models, p.options, progress, known);
}

}  // namespace

FitResult fit(const Samples& samples, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options, const Progress& progress, const RefitSolutions* known) {
  FitResult result = fit_prepared(prepared(samples, options), samples.table, models, progress, known);
  result.sheet = samples.sheet;
  return result;
}

FitResult fit(const io::SampleTable& table, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options, const Progress& progress, const RefitSolutions* known) {
  return fit_prepared(prepared(table, options), table, models, progress, known);
}

Candidates solve_candidates(const Prepared& p, const std::vector<std::vector<Reflectance>>& models,
                            const FitOptions& options, const Progress& progress,
                            const RefitSolutions* known) {
  const FitData& data = p.data;
  Candidates out;
  FitResult& result = out.about;
  result.noise_floor = p.scatter();
  result.channel_noise = p.noise.neighbours.channels;
  result.metric = p.metric;
  result.rows = data.rows();
  result.beyond_max_theta = data.beyond_max_theta;
  result.outside_domain = data.outside_domain;
  result.channels = data.channels;
  result.groups = data.groups;
  const std::optional<double> least = fit_with_noise(p, models, options, progress, out);
  const Context about{result.noise_floor,
                      least,
                      p.interpolated,
                      data.groups.held_out,
                      data.groups.groups.size(),
                      std::string(data.groups.name()),
                      hidden_width(data, result.noise_floor)};
  for (Solved& s : out.all) s.fit.about = about;
  refit_all(data, options, known, out.all, result);
  result.interrupted = options.stop();
  return out;
}

namespace {

// Profiles take longer than many fits. Therefore only the forms that are reported in full get profiles; the
// ranking then uses the results.
void rank_and_profile(const FitData& data, const FitOptions& options, const Progress& progress,
                      Candidates& candidates, FitResult& result) {
  std::vector<std::size_t> number = rank(result);  // index among the candidates of each entry of the ranking
  for (bool found = true; found;) {
    found = false;
    for (const std::size_t k : {std::size_t(0), result.recommended}) {
      Solved& s = candidates.all[number[k]];
      std::swap(s.fit, result.ranking[k]);
      const bool profiled = profile_intervals(data, options, progress, s);
      std::swap(s.fit, result.ranking[k]);
      found = found || profiled;
    }
    if (!found) break;
    std::vector<std::size_t> moved = rank(result);
    for (std::size_t& place : moved) place = number[place];
    number = std::move(moved);
  }
  FormFit& first = result.ranking.front();
  if (first.verdict != Verdict::breaks_energy || options.physical != Physical::off || options.stop()) return;
  if (progress) progress("trying --physical");
  Solved& s = candidates.all[number.front()];
  std::swap(s.fit, first);
  s.fit.findings.push_back(physical_in_words(data, options, s));
  std::swap(s.fit, first);
}

}  // namespace

FitResult fit(const Prepared& p, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options, const Progress& progress, const RefitSolutions* known) {
  Candidates candidates = solve_candidates(p, models, options, progress, known);
  FitResult result = std::move(candidates.about);
  for (Solved& s : candidates.all) result.ranking.push_back(std::move(s.fit));
  rank_and_profile(p.data, options, progress, candidates, result);
  result.interrupted = options.stop();
  return result;
}

std::size_t count_refits(const io::SampleTable& table, std::size_t models, const FitOptions& options) {
  const Prepared p = prepared(table, options);
  return models * count_refits(p.data.groups, p.options);
}

RefitSolutions solve_refits(const io::SampleTable& table, const std::vector<std::vector<Reflectance>>& models,
                            const FitOptions& options, std::size_t first, std::size_t count) {
  const Prepared p = prepared(table, options);
  const std::size_t of_each = count_refits(p.data.groups, p.options), end = first + count;
  RefitSolutions out;
  for (std::size_t k = 0; k < models.size(); ++k) {
    const std::size_t begins = std::max(first, k * of_each), ends = std::min(end, (k + 1) * of_each);
    if (begins >= ends) continue;
    const std::vector<Solved> all = fit_models(p.data, {models[k]}, p.options, p.noise.neighbours.value, {});
    const Solved& s = all.front();
    RefitSolutions part(ends - begins);
    if (s.fit.solved()) {
      const SampleStream stream(p.data, s.model, s.residual, p.options.resolved_aperture());
      auto solved = refits_of(s, stream, {begins - k * of_each, ends - begins}, p.options);
      if (!solved) return {};
      part = std::move(*solved);
    }
    std::move(part.begin(), part.end(), std::back_inserter(out));
  }
  return out;
}

std::vector<std::vector<Reflectance>> every_model() {
  std::vector<std::vector<Reflectance>> models;
  for (const Reflectance& form : catalogue())
    if (info(form).fittable()) models.push_back({form});
  return models;
}

std::vector<std::vector<Reflectance>> canonical_models() {
  std::vector<std::vector<Reflectance>> models = every_model();
  std::erase_if(models, [](const auto& forms) { return !info(forms[0]).canonical; });
  return models;
}

}  // namespace brdf::fit
