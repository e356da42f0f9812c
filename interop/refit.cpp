#include "interop/refit.h"

#include <algorithm>
#include <cmath>

#include "validate/search/search.h"

namespace brdf::interop {
namespace {

double blended(double a, double b, double t, bool logarithmic) {
  return logarithmic && a > 0 && b > 0 ? a * std::pow(b / a, t) : a + t * (b - a);
}

// Returns the parameters at fraction t of the way from the copy to the fitted parameters.
Material blend(const Material& copy, const Material& fitted, double t) {
  Material out = copy;
  Term& term = out.terms[0];
  const Term& to = fitted.terms[0];
  const ReflectanceInfo& form = info(term.form);
  term.shape.resize(std::max(term.shape.size(), to.shape.size()), term.shape[0]);
  for (std::size_t c = 0; c < term.weights.size(); ++c)
    for (std::size_t k = 0; k < form.weights.size(); ++k)
      term.weights[c][k] = blended(term.weights[c][k], to.weights[c][k], t, false);
  for (std::size_t s = 0; s < term.shape.size(); ++s)
    for (std::size_t k = 0; k < form.shape.size(); ++k)
      term.shape[s][k] =
          blended(term.shape[s][k], to.shape[to.shape.size() == 1 ? 0 : s][k], t, form.shape[k].log_scale);
  return out;
}

// Parameters that move together, in a range around their present value.
struct Knob {
  std::vector<double*> values;
  double low, high;
  bool logarithmic;

  void set(double u) const {
    for (double* value : values) *value = blended(low, high, u, logarithmic);
  }
  double place() const {
    const double x = *values[0];
    return logarithmic ? std::log(x / low) / std::log(high / low) : (x - low) / (high - low);
  }
};

// Adds a knob around the present value and within the range. A climb searches this interval.
void add_knob(std::vector<Knob>& knobs, std::vector<double*> values, const ParameterInfo& p, double low,
              double high) {
  const double x = *values[0];
  const bool logarithmic = p.log_scale && x > 0 && low > 0;
  const double reach = 0.4 * std::abs(x) + 0.02;
  const double from = std::max(low, logarithmic ? x / 1.6 : x - reach),
               to = std::min(high, logarithmic ? x * 1.6 : x + reach);
  if (from < to) knobs.push_back({std::move(values), from, to, logarithmic});
}

bool is_coloured(const TargetRules& rules, Role role) {
  return std::ranges::find(rules.copy.coloured, role) != rules.copy.coloured.end();
}

// A weight of 0 in all channels stays 0: the part does not exist.
std::vector<Knob> knobs_of(Term& term, const TargetRules& rules) {
  const ReflectanceInfo& form = info(term.form);
  std::vector<Knob> knobs;
  for (std::size_t k = 0; k < form.weights.size(); ++k) {
    const ParameterInfo& p = form.weights[k];
    const bool together = rules.copy.grey_lobe && p.role == Role::specular;
    const bool absent = std::ranges::all_of(term.weights, [&](const auto& w) { return w[k] == 0; });
    const double most = p.role == Role::specular && (rules.sum_to_one || together) ? rules.copy.most_lobe
                        : rules.sum_to_one                                         ? 1
                                                                                   : p.max;
    if (absent || p.min == p.max) continue;
    if (together) {
      std::vector<double*> all;
      for (std::vector<double>& w : term.weights) all.push_back(&w[k]);
      add_knob(knobs, std::move(all), p, p.min, std::min(most, p.max));
    } else {
      for (std::vector<double>& w : term.weights) add_knob(knobs, {&w[k]}, p, p.min, std::min(most, p.max));
    }
  }
  const auto [along, across] = form.axes();
  const bool tied = across >= 0 && term.shape[0][std::size_t(along)] == term.shape[0][std::size_t(across)];
  for (std::size_t k = 0; k < form.shape.size(); ++k) {
    const ParameterInfo& p = form.shape[k];
    double low = p.min, high = p.max;
    for (const fit::NamedRange& bound : rules.bounds)
      if (form.shape_index(bound.name) == int(k))
        low = std::max(low, bound.low), high = std::min(high, bound.high);
    if ((tied && int(k) == across) || int(k) == superfluous(term) || p.map == Map::metallic) continue;
    std::vector<double*> all;
    for (std::vector<double>& shape : term.shape) {
      all.push_back(&shape[k]);
      if (tied && int(k) == along) all.push_back(&shape[std::size_t(across)]);
      if (is_coloured(rules, p.role)) add_knob(knobs, std::exchange(all, {}), p, low, high);
    }
    if (!all.empty()) add_knob(knobs, std::move(all), p, low, high);
  }
  return knobs;
}

// A mix of shaders requires weights that add up to at most 1.
double excess_of(const Term& term, const TargetRules& rules) {
  if (!rules.mixes) return 0;
  const ReflectanceInfo& form = info(term.form);
  double lobe = 0, diffuse = 0;
  for (const std::vector<double>& w : term.weights)
    for (std::size_t k = 0; k < form.weights.size(); ++k) {
      if (form.weights[k].role == Role::specular) lobe = std::max(lobe, w[k]);
      if (form.weights[k].role == Role::diffuse) diffuse = std::max(diffuse, w[k]);
    }
  return std::max(lobe + diffuse - 1, 0.0);
}

}  // namespace

bool exceeds(const Term& of_target, const TargetRules& rules) {
  return excess_of(of_target, rules) > 1e-12;
}

Refit::Refit(const Comparison& wanted, const TargetRules& rules, const io::SampleTable& table,
             const Material& copy, const Loss& of_copy)
    : wanted_(wanted),
      rules_(rules),
      table_(table),
      directions_(io::unit_directions(table)),
      copy_(copy),
      of_copy_(of_copy),
      best_(copy),
      loss_(of_copy),
      copy_holds_(!exceeds(copy.terms[0], rules)) {
  if (copy_holds_) return;
  loss_.rms = loss_.median = loss_.albedo = loss_.largest.difference = HUGE_VAL;
  of_copy_ = loss_;
}

bool Refit::consider(const Material& candidate) {
  if (exceeds(candidate.terms[0], rules_)) return false;
  const auto loss = wanted_.better_loss_of(shown_by(rules_, candidate), loss_, of_copy_);
  if (!loss) return false;
  best_ = candidate;
  loss_ = *loss;
  return improved_ = true;
}

void Refit::between(const Material& fitted) {
  fitted_.push_back(fitted);
  for (const double t : {1.0, 0.7, 0.45, 0.3, 0.2, 0.1, 0.05})
    if (consider(blend(copy_, fitted, t))) return;
}

Figures Refit::at_fitted_pairs(const Material& of_target) const {
  const Directions<double> d = directions_.view();
  return figures_of(table_.values, values_at(shown_by(rules_, of_target), d), d);
}

bool Refit::climb_from(Material candidate, const Figures& limits, double share) {
  const std::vector<Knob> knobs = knobs_of(candidate.terms[0], rules_);
  if (knobs.empty()) return false;
  std::vector<double> start;
  for (const Knob& knob : knobs) start.push_back(std::clamp(knob.place(), 0.0, 1.0));
  const auto objective = [&](std::span<const double> x) {
    for (std::size_t k = 0; k < knobs.size(); ++k) knobs[k].set(x[k]);
    const Figures f = at_fitted_pairs(candidate);
    const auto above = [&](double figure, double limit) {
      return std::max(figure / (limit + 1e-9) - share, 0.0);
    };
    return -(f.rms / limits.rms + 10 * above(f.median, limits.median) +
             10 * above(f.largest, limits.largest) + 100 * excess_of(candidate.terms[0], rules_));
  };
  validate::SearchOptions options;
  options.cover = 0;
  options.starts = options.polish = 1;
  options.steps = 40;
  options.finest = 1e-3;
  const validate::Best best = validate::maximise(objective, knobs.size(), options, {start});
  for (std::size_t k = 0; k < knobs.size(); ++k) knobs[k].set(best.point[k]);
  return consider(candidate);
}

void Refit::polish() {
  const Figures limits = copy_holds_ ? at_fitted_pairs(copy_) : Figures{1, HUGE_VAL, HUGE_VAL};
  std::vector<Material> starts{best_};
  for (const Material& fitted : fitted_) starts.push_back(blend(copy_, fitted, 0.5));
  for (const Material& start : starts)
    for (const double share : {0.98, 0.85, 0.6})
      if (climb_from(start, limits, share)) break;
}

}  // namespace brdf::interop
