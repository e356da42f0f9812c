#include "interop/project.h"

#include <algorithm>
#include <iterator>

#include "fit/fit.h"
#include "fit/model/constraints.h"
#include "interop/pairs.h"
#include "interop/refit.h"
#include "io/files/parallel.h"

namespace brdf::interop {
namespace {

bool is_zero(const Term& term, std::size_t weight) {
  return std::ranges::all_of(term.weights, [&](const auto& w) { return w[weight] == 0; });
}

bool has_no_diffuse(const Term& copy) {
  const ReflectanceInfo& target = info(copy.form);
  const int diffuse = target.weight_index(Role::diffuse);
  return target.weight_index(Role::specular) >= 0 && diffuse >= 0 && is_zero(copy, std::size_t(diffuse));
}

// Returns true if the program's control has one value only.
bool has_one_value(const fit::NamedRange& bound) {
  return bound.low == bound.high;
}

bool is_held(const TargetRules& rules, std::string_view name) {
  return std::ranges::any_of(
      rules.bounds, [&](const fit::NamedRange& bound) { return has_one_value(bound) && bound.name == name; });
}

// Uses the copy's values as the first starting point of the fit. Absent parts (a diffuse part, a lobe) stay
// at 0.
void start_at(const Term& copy, const TargetRules& rules, fit::FitOptions& options) {
  const ReflectanceInfo& target = info(copy.form);
  const bool several = copy.weights.size() > 1;
  const bool without_diffuse = has_no_diffuse(copy);
  for (std::size_t k = 0; k < target.weights.size(); ++k) {
    const ParameterInfo& p = target.weights[k];
    if (p.min == p.max) continue;
    fit::NamedValues values{std::string(p.name), {}};
    for (const auto& w : copy.weights) values.values.push_back(w[k]);
    const bool tied = std::ranges::find(options.tie, p.name) != options.tie.end();
    if (tied) values.values.resize(1);
    if (p.role == Role::diffuse && without_diffuse)
      options.fix.push_back({values.name, {0}});
    else
      options.start.push_back(std::move(values));
  }
  for (std::size_t k = 0; k < target.shape.size(); ++k) {
    if (int(k) == target.axes().across && !options.anisotropic) continue;
    fit::NamedValues values{std::string(target.shape[k].name), {}};
    for (const auto& shape : copy.shape) values.values.push_back(shape[k]);
    const bool of_nothing = (target.shape[k].role == Role::slope && without_diffuse) ||
                            int(k) == superfluous(copy) || is_held(rules, values.name);
    if (of_nothing || std::ranges::find(options.tie, values.name) != options.tie.end())
      values.values.resize(1);
    (of_nothing ? options.fix : options.start).push_back(std::move(values));
  }
  if (!several)
    for (fit::NamedValues& start : options.start) start.values.resize(1);
}

fit::FitOptions options_for(const Wanted& wanted, const TargetRules& rules, const Term& copy) {
  const ReflectanceInfo& target = info(rules.target);
  fit::FitOptions options;
  options.cross_validation = options.profiles = false;
  // The copy is near, and the values have no noise. A few random starting points in addition to the copy
  // find the same minima as a grid of hundreds.
  options.grid_starts = false;
  options.random_starts = 4;
  options.threads = io::all_processors();
  options.anisotropic = is_anisotropic(wanted.material) && target.anisotropic();
  options.per_channel = copy.shape.size() > 1;
  std::remove_copy_if(rules.bounds.begin(), rules.bounds.end(), std::back_inserter(options.bounds),
                      has_one_value);
  const auto name = [&](int shape) { return std::string(target.shape[std::size_t(shape)].name); };
  for (std::size_t k = 0; options.per_channel && k < target.shape.size(); ++k) {
    const Role role = target.shape[k].role;
    const bool held = (int(k) == target.axes().across && !options.anisotropic) ||
                      (role == Role::slope && has_no_diffuse(copy)) || int(k) == superfluous(copy) ||
                      is_held(rules, target.shape[k].name);
    const bool coloured = std::ranges::find(rules.copy.coloured, role) != rules.copy.coloured.end();
    if (!coloured && !held) options.tie.push_back(name(int(k)));
  }
  if (rules.copy.grey_lobe) {
    const std::string lobe(target.weights[std::size_t(target.weight_index(Role::specular))].name);
    if (copy.weights.size() > 1) options.tie.push_back(lobe);
    if (!rules.sum_to_one) options.bounds.push_back({lobe, 0, 1});
  }
  if (rules.copy.most_lobe < 1)
    options.bounds.push_back(
        {std::string(target.weights[std::size_t(target.weight_index(Role::specular))].name), 0,
         rules.copy.most_lobe});
  if (rules.sum_to_one) options.physical = fit::Physical::bounded;
  if (options.anisotropic) options.fix.push_back({std::string(fit::kTangentInfo.name), {0}});
  start_at(copy, rules, options);
  return options;
}

// Clamps parameters to the ranges of the program's controls.
void bring_within(const std::vector<fit::NamedRange>& bounds, Term& copy) {
  for (const fit::NamedRange& bound : bounds)
    if (const int k = info(copy.form).shape_index(bound.name); k >= 0)
      for (std::vector<double>& shape : copy.shape)
        shape[std::size_t(k)] = std::clamp(shape[std::size_t(k)], bound.low, bound.high);
}

}  // namespace

Material shown_by(const TargetRules& rules, const Material& of_target) {
  return rules.shown ? rules.shown(of_target) : of_target;
}

Projection project(const Wanted& wanted, const TargetRules& rules, bool naive) {
  Projection out;
  out.material = copied(wanted, rules.target, rules.copy);
  bring_within(rules.bounds, out.material.terms[0]);
  if (naive) return out;
  const Comparison comparison(wanted.material);
  const Loss of_copy = comparison.loss_of(shown_by(rules, out.material));
  if (of_copy.none_found() && !exceeds(out.material.terms[0], rules)) return out;
  const io::SampleTable table = values_about(wanted.material, Pairs::fitted);
  Refit refit(comparison, rules, table, out.material, of_copy);
  fit::FitOptions options = options_for(wanted, rules, out.material.terms[0]);
  // Fits f cos_i first, then relative differences.
  for (const fit::Metric metric : {fit::Metric::log, fit::Metric::log_relative}) {
    options.metric = metric;
    if (metric == fit::Metric::log_relative) options.random_starts = 0;
    const fit::FormFit best = fit::fit(table, {{rules.target}}, options).ranking.front();
    if (best.solved()) refit.between(best.material);
    if (refit.improved()) break;
  }
  refit.polish();
  if (!refit.improved()) return out;
  out.material = refit.best();
  out.refitted = true;
  return out;
}

}  // namespace brdf::interop
