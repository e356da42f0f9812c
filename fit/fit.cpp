#include "fit/fit.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/assess.h"
#include "fit/assess/reported.h"
#include "fit/assess/select.h"
#include "fit/solve/minima.h"
#include "io/error.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kListedMinima = 10;
constexpr double kNegligible = 1e-7;  // share of a lobe in the model below which it is absent

Residual residual_of(const FitData& data, const FitOptions& options) {
  Residual r;
  r.metric = options.metric;
  if (options.metric == Metric::cube_root) {
    if (options.loss != Loss::none)
      throw InputError("--robust does not go with --metric cube_root, which is robust by itself");
    // The cube root of a square has an infinite slope at 0: it is rounded off below a thousandth of the data.
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t c = 0; c < data.values.size(); ++c)
      for (std::size_t k = 0; k < data.rows(); ++k, ++count)
        sum += std::pow(data.values[c][k] * data.wi_z[k] / (data.sigma.empty() ? 1 : data.sigma[c][k]), 2);
    r.loss.kind = LossFunction::Kind::cube_root;
    r.loss.scale = std::max(1e-3 * std::sqrt(sum / double(count)), 1e-12);
    return r;
  }
  if (options.loss == Loss::huber) r.loss.kind = LossFunction::Kind::huber;
  if (options.loss == Loss::cauchy) r.loss.kind = LossFunction::Kind::cauchy;
  r.loss.scale = options.loss_scale;
  return r;
}

// Linear unknowns whose lobe adds next to nothing are exactly 0 and held there.
void drop_negligible_lobes(const SampleStream& stream, Minimum& m) {
  const Model& model = stream.model();
  const NormalEquations n = stream.normal_equations(m.p);
  for (std::size_t k = model.shape_slots(); k < model.size(); ++k) {
    const Slot& slot = model.slots()[k];
    if (slot.low != 0 || m.p[k] == 0) continue;
    double all = 0;
    for (std::size_t i = model.shape_slots(); i < model.size(); ++i)
      if (model.slots()[i].group == slot.group) all += m.p[i] * m.p[i] * n.hessian(i, i);
    if (m.p[k] * m.p[k] * n.hessian(k, k) <= kNegligible * kNegligible * all) {
      m.p[k] = 0;
      m.at_bound[k] = -1;
    }
  }
}

Verdict verdict_of(const Minimum& m, const SearchResult& search, const Uncertainty& u, const Misfit& misfit) {
  if (search.interrupted) return Verdict::interrupted;
  if (m.termination != Termination::converged || !std::isfinite(m.cost)) return Verdict::diverged;
  const auto any = [&](Status s) {
    return std::any_of(u.estimates.begin(), u.estimates.end(),
                       [&](const Estimate& e) { return e.status == s; });
  };
  // What the directions cannot tell is said first; how uncertain a wrong model's parameters are, last.
  if (u.singular) return Verdict::not_identifiable;
  if (misfit.misfit) return Verdict::misfit;
  if (any(Status::unidentified)) return Verdict::not_identifiable;
  if (any(Status::at_bound)) return Verdict::at_bound;
  return Verdict::converged;
}

double information_criterion(const SampleStream& stream, const Minimum& m) {
  double free = 0;
  for (int b : m.at_bound) free += b == 0;
  const double n = double(stream.data().rows() * stream.data().channels.size());
  return n * std::log(std::max(2 * m.cost / n, 1e-300)) + free * std::log(n);
}

FormFit fit_model(const FitData& data, const std::vector<Reflectance>& forms, const FitOptions& options,
                  std::optional<double> noise) {
  const Model model(forms, data.channels, options);
  Residual residual = residual_of(data, options);
  SearchResult search = find_minima(data, model, residual, options);
  FormFit out;
  out.form = model.name();
  out.starts = search.starts;
  out.iterations = search.iterations;
  out.passes = search.passes;
  out.parameters = model.size();
  if (search.minima.empty()) {
    out.material = model.material(model.initial());
    out.verdict = search.interrupted ? Verdict::interrupted : Verdict::diverged;
    out.findings.push_back("no start gave a finite cost");
    return out;
  }
  residual.loss.scale = out.loss_scale = search.loss_scale;
  const SampleStream stream(data, model, residual, options.aperture);
  Minimum& best = search.minima[0];
  drop_negligible_lobes(stream, best);
  const std::vector<std::vector<double>> values = stream.values(best.p);
  out.metrics = measure(data, values);
  out.median_relative_error = median_relative_error(data, values);
  const Uncertainty u = uncertainty(stream, best);
  const Misfit misfit = judge_misfit(data, values, noise);
  out.verdict = verdict_of(best, search, u, misfit);
  out.solver_message = best.message;
  if (out.verdict == Verdict::interrupted) out.findings.push_back("interrupted: the best parameters so far");
  if (out.verdict == Verdict::diverged) out.findings.push_back("the solver gave up: " + best.message);
  if (misfit.misfit) out.findings.push_back(misfit.finding);
  out.findings.insert(
      misfit.misfit && out.verdict == Verdict::not_identifiable ? out.findings.begin() : out.findings.end(),
      u.findings.begin(), u.findings.end());
  if (search.minima.size() > 1 && search.minima[1].cost <= (1 + kSameCost) * search.minima[0].cost)
    out.findings.push_back("another minimum has the same cost: " +
                           shape_text(model.material(search.minima[1].p)));
  out.material = model.material(best.p);
  out.estimates = u.estimates;
  out.correlations = u.correlations;
  out.condition = u.condition;
  out.bic = information_criterion(stream, best);
  for (std::size_t k = 0; k < std::min(search.minima.size(), kListedMinima); ++k)
    out.minima.push_back({search.minima[k].cost, search.minima[k].basin, model.material(search.minima[k].p)});
  if (options.cross_validation && !options.stop() && out.verdict != Verdict::diverged) {
    const CrossValidation cv = cross_validate(data, model, residual, best.p, options);
    out.cross_validated_error = cv.error;
    out.cross_validated_standard_error = cv.standard_error;
  }
  return out;
}

}  // namespace

FitResult fit(const io::SampleTable& table, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options) {
  const FitData data = prepare(table, options);
  FitResult result;
  result.rows = data.rows();
  result.beyond_max_theta = data.beyond_max_theta;
  result.outside_domain = data.outside_domain;
  result.channels = data.channels;
  result.noise_floor = noise_floor(data);
  for (const auto& forms : models) {
    if (options.stop() && !result.ranking.empty()) break;
    result.ranking.push_back(fit_model(data, forms, options, result.noise_floor));
  }
  result.interrupted = options.stop();
  rank(result);
  return result;
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
