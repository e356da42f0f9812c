#include "fit/solved.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "fit/assess/assess.h"
#include "fit/assess/derived.h"
#include "fit/assess/errors.h"
#include "fit/assess/lack_of_fit.h"
#include "fit/assess/propagation.h"
#include "fit/assess/reported.h"
#include "fit/assess/verdict.h"
#include "fit/model/constraints.h"
#include "fit/solve/cutting_planes.h"
#include "fit/solve/minima.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/parallel.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kListedMinima = 10;
constexpr double kStrongEvidence = 6;  // a difference of BIC (Kass and Raftery 1995)

std::string energy_text(const LargestAlbedo& a, const Extent& interval, const FitOptions& options) {
  const bool beyond = interval.low > LargestAlbedo::kMost;
  return "violates energy conservation: directional albedo " + io::percent_to_tenths(a.value) + " at " +
         io::short_number(a.theta) + " degrees (" + a.channel + ")" +
         (beyond ? "" : "; its confidence interval includes 100 %") +
         (options.physical == Physical::off ? "; --physical bounds the weights" : "");
}

// Returns the interval of the albedo at the angle of the largest albedo, or the value itself if the
// interval is unknown.
Extent interval_of_albedo(const FormFit& f, const LargestAlbedo& a) {
  const std::vector<double> value{a.value};
  const auto found = intervals(f.material, knowledge_of(f), value, [&](const Material& m) {
    return std::vector<double>{albedo_at(m, a.theta).value};
  });
  return found ? found->front() : Extent{a.value, a.value};
}

// Rejects a material that reflects more light than it receives at a measured angle, if the interval of the
// albedo confirms this.
void judge_energy(const FitOptions& options, FormFit& out) {
  if (out.has_free_scale || !out.largest_measured_albedo->breaks_energy()) return;
  const Extent interval = interval_of_albedo(out, *out.largest_measured_albedo);
  out.findings.push_back(energy_text(*out.largest_measured_albedo, interval, options));
  if (usable(out.verdict) && interval.low > LargestAlbedo::kMost) out.verdict = Verdict::breaks_energy;
}

double information_criterion(const SampleStream& stream, const Minimum& m) {
  double free = 0;
  for (int b : m.at_bound) free += b == 0;
  const double n = double(stream.data().rows() * stream.data().channels.size());
  return n * std::log(std::max(2 * m.cost / n, 1e-300)) + free * std::log(n);
}

// Clamps the weights to their ranges. Two unknowns of one weight can each reach the maximum of the weight.
void keep_in_range(Material& m) {
  for (Term& term : m.terms)
    for (std::vector<double>& weights : term.weights)
      for (std::size_t k = 0; k < weights.size(); ++k) {
        const ParameterInfo& p = info(term.form).weights[k];
        weights[k] = std::clamp(weights[k], p.min, p.max);
      }
}

// Draws the conclusions about a form from the uncertainty of its solution.
void conclude(const Uncertainty& u, const FitOptions& options, Solved& s) {
  FormFit& out = s.fit;
  if (out.verdict != Verdict::interrupted) out.verdict = verdict_of(s.minimum, u, s.misfit);
  out.findings = s.before;
  if (out.verdict == Verdict::diverged) out.findings.push_back("the solver failed: " + s.minimum.message);
  if (s.misfit.misfit) out.findings.push_back(s.misfit.finding);
  out.findings.insert(out.findings.end(), u.findings.begin(), u.findings.end());
  out.findings.insert(out.findings.end(), s.after.begin(), s.after.end());
  out.light_is_off = out.verdict == Verdict::misfit && s.misfit.light_is_off;
  out.few_rows_decide = u.few_rows_decide;
  out.estimates = u.estimates;
  out.smooth = u.smooth;
  out.correlations = u.correlations;
  out.covariance = u.covariance;
  out.budget = u.budget;
  out.prediction_error = u.prediction_error;
  out.condition = u.condition;
  out.intervals = u.profiled ? IntervalsBy::profile : IntervalsBy::curvature;
  out.ends.clear();
  for (const EndOfInterval& end : u.ends) {
    out.ends.push_back({s.model.material(end.p), end.open});
    keep_in_range(out.ends.back().material);
  }
  judge_energy(options, out);
  if (s.below_zero.empty()) return;
  out.findings.insert(out.findings.begin(), s.below_zero);
  if (usable(out.verdict)) out.verdict = Verdict::misfit;
}

// Says that the weights of a basis were limited, and how much the fit lost by it.
void note_limits(const CuttingPlanes& limited, double rms_before, const SampleStream& stream,
                 const Minimum& best, Solved& s) {
  if (!limited.open.empty()) s.below_zero = "the weights can be used by no renderer: " + limited.open;
  if (limited.cuts == 0 || !limited.open.empty()) return;  // nothing is promised of limits that are not met
  const auto angle = [](const Vec3<double>& w) {
    return io::short_number(radians(std::acos(std::clamp(w.z, 0.0, 1.0))).degrees(), 3);
  };
  std::string text = "the weights were bounded in " + io::plural(limited.cuts, "direction") + ", so that ";
  if (limited.free_value < 0)
    text += "f is not below 0 (without a bound f reaches " + io::short_number(limited.free_value, 3) +
            " /sr in " + limited.channel + " at theta_i " + angle(limited.wi) + " and theta_o " +
            angle(limited.wo) + " degrees)";
  else if (!limited.limits_albedo)
    text += "f is shown not to be below 0";
  if (limited.limits_albedo)
    text += std::string(limited.free_value < 0 ? " and " : "") + "the albedo is not above 1";
  s.after.push_back(text + ": the rms relative error is " +
                    io::percent(rms_error(stream.data(), stream.values(best.p))) + " instead of " +
                    io::percent(rms_before));
}

Solved fit_model(const FitData& data, const std::vector<Reflectance>& forms, const FitOptions& options,
                 std::optional<double> noise) {
  Solved solved{
      {}, Model(forms, data.channels, options), chosen_residual(data, options), {}, {}, {}, {}, {}, {}, {}};
  Model& model = solved.model;
  if (model.size() == 0)
    throw InputError("--fix: every parameter of " + model.name() +
                     " is held, so that nothing is left to fit");
  Residual& residual = solved.residual;
  SearchResult search = find_minima(data, model, residual, options);
  FormFit& out = solved.fit;
  out.form = model.name();
  out.starts = search.starts;
  out.iterations = search.iterations;
  out.passes = search.passes;
  out.parameters = model.size();
  if (search.minima.empty()) {
    out.material = model.material(model.initial());
    out.verdict = search.interrupted ? Verdict::interrupted : Verdict::diverged;
    out.findings.push_back("the cost was not finite at any starting point");
    return solved;
  }
  residual.loss.scale = out.loss_scale = search.loss_scale;
  const SampleStream stream(data, model, residual, options.resolved_aperture());
  Minimum& best = search.minima[0];
  const double rms_before = model.is_signed() ? rms_error(data, stream.values(best.p)) : 0;
  if (const auto limited = keep_within_limits(data, model, residual, options, best))
    note_limits(*limited, rms_before, stream, best, solved);
  drop_negligible_lobes(stream, best);
  solved.p = best.p;
  solved.minimum = best;
  const std::vector<std::vector<double>> values = stream.values(best.p);
  out.metrics = measure(data, values);
  out.errors = relative_errors(data, values, {0, data.rows()});
  out.median_relative_error = out.errors.median;
  solved.misfit = judge(data, values, noise);
  out.lack_of_fit = lack_of_fit(stream, values, noise);
  out.solver_status = name_of(best.termination);
  out.solver_message = best.message;
  if (search.interrupted) {
    out.verdict = Verdict::interrupted;
    solved.before.push_back("interrupted: these are the best parameters so far");
  }
  if (search.minima.size() > 1 && search.minima[1].cost <= (1 + kSameCost) * search.minima[0].cost)
    solved.after.push_back("another local minimum has the same cost: " +
                           shape_text(model.material(search.minima[1].p)));
  out.material = model.material(best.p);
  const LargestAlbedos albedos = largest_albedos(out.material, measured_lights(data));
  out.largest_albedo = albedos.anywhere;
  out.largest_measured_albedo = albedos.measured;
  out.has_free_scale = options.free_scale;
  out.bic = information_criterion(stream, best);
  for (std::size_t k = 0; k < std::min(search.minima.size(), kListedMinima); ++k) {
    out.minima.push_back({search.minima[k].cost, search.minima[k].basin, model.material(search.minima[k].p)});
    if (k > 0) solved.other_minima.push_back(search.minima[k].p);
  }
  conclude(uncertainty(stream, best), options, solved);
  return solved;
}

// Keeps the results of refits and of other metrics for a parameter when its interval changes. The interval
// with lack of fit becomes at least as wide as the new interval.
void keep_movement(const Estimate& from, Estimate& to) {
  to.left_out = from.left_out;
  to.other_metrics = from.other_metrics;
  to.bootstrap = from.bootstrap;
  to.bootstrap_error = from.bootstrap_error;
  to.with_lack_of_fit = {std::min(from.with_lack_of_fit.low, to.low),
                         std::max(from.with_lack_of_fit.high, to.high)};
  if (std::isnan(from.with_lack_of_fit.low)) to.with_lack_of_fit = {};
}

// Fits the weights of a dielectric if the samples do not contradict them, otherwise weights with a bounded
// sum.
Solved fit_physical(const FitData& data, const std::vector<Reflectance>& forms, const FitOptions& given,
                    std::optional<double> noise) {
  FitOptions options = given;
  const Constraints constraints = resolve(forms, data.channels, options);
  // The weights of a basis are no shares of the light, so that no sum with one is divided like a dielectric.
  const bool has_basis =
      std::ranges::any_of(forms, [](const Reflectance& form) { return form.info().basis != nullptr; });
  if (has_basis || !can_be_dielectric(forms, constraints)) {
    options.physical = Physical::bounded;
    return fit_model(data, forms, options, noise);
  }
  options.physical = Physical::dielectric;
  Solved dielectric = fit_model(data, forms, options, noise);
  if (must_be_dielectric(forms, constraints)) return dielectric;
  options.physical = Physical::bounded;
  Solved bounded = fit_model(data, forms, options, noise);
  const bool keeps = dielectric.fit.solved() && !(bounded.fit.bic < dielectric.fit.bic - kStrongEvidence);
  const std::string of_others = io::short_number(bounded.fit.bic), own = io::short_number(dielectric.fit.bic);
  Solved chosen = std::move(keeps ? dielectric : bounded);
  chosen.after.push_back(
      keeps ? "--physical: the material is assumed to be a dielectric with a specular weight of 1 (BIC " +
                  own + "); with weights that add up to at most 1 BIC is " + of_others
            : "--physical: the material is not assumed to be a dielectric with a specular weight of 1: BIC "
              "would be " +
                  own + " instead of " + of_others);
  chosen.fit.findings.push_back(chosen.after.back());
  return chosen;
}

}  // namespace

std::string physical_in_words(const FitData& data, const FitOptions& options, const Solved& s) {
  std::vector<Reflectance> forms;
  for (const TermModel& term : s.model.terms()) forms.push_back(term.form);
  FitOptions bounded = options;
  bounded.physical = Physical::either;
  try {
    const Solved physical = fit_physical(data, forms, bounded, s.fit.about.scatter);
    if (!physical.fit.solved()) return "with --physical the fit fails";
    return "with --physical the median error is " + io::percent(physical.fit.median_relative_error, 2) +
           " and the largest directional albedo " + io::percent(physical.fit.largest_albedo->value, 3);
  } catch (const InputError&) {
    return "--physical cannot be used with these options";
  }
}

bool profile_intervals(const FitData& data, const FitOptions& options, const Progress& progress, Solved& s) {
  if (!options.profiles || !s.fit.solved() || s.fit.verdict == Verdict::interrupted || options.stop())
    return false;
  if (s.fit.intervals == IntervalsBy::profile || data.rows() > kManyRows) return false;
  if (progress) progress("intervals of " + s.fit.form);
  const SampleStream stream(data, s.model, s.residual, options.resolved_aperture());
  const ProfileOptions profiles{s.other_minima, options.threads, options.interrupted};
  const Uncertainty u = uncertainty(stream, s.minimum, Detail::profiles, nullptr, profiles);
  if (!u.profiled) return false;
  const std::vector<Estimate> before = std::move(s.fit.estimates);
  conclude(u, options, s);
  for (std::size_t k = 0; k < before.size(); ++k) keep_movement(before[k], s.fit.estimates[k]);
  return true;
}

std::vector<Solved> fit_models(const FitData& data, const std::vector<std::vector<Reflectance>>& models,
                               const FitOptions& options, std::optional<double> noise,
                               const Progress& progress) {
  const auto fitted = options.physical == Physical::either ? fit_physical : fit_model;
  std::vector<std::optional<Solved>> found(models.size());
  std::mutex speaking;
  const auto fit_one = [&](std::size_t k) {
    if (options.stop() && k > 0) return;
    if (progress) {
      const std::lock_guard lock(speaking);
      progress(name_of_sum(models[k]));
    }
    found[k] = fitted(data, models[k], options, noise);
  };
  io::parallel_for(models.size(), fit_one, options.threads);
  std::vector<Solved> all;
  for (std::optional<Solved>& s : found)
    if (s) all.push_back(std::move(*s));
  return all;
}

}  // namespace brdf::fit
