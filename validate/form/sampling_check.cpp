// Compares Monte Carlo integration with the form's own sampler against the form's integral: the mean of f
// cos_i / pdf, with its standard error.
#include <algorithm>
#include <cmath>

#include "brdf/integrals.h"
#include "brdf/random.h"
#include "io/files/text.h"
#include "validate/form/checks.h"
#include "validate/search/degrees.h"
#include "validate/search/pair_search.h"
#include "validate/search/search.h"

namespace brdf::validate {
namespace {

constexpr double kDeviations = 4.5;  // standard errors; exceeded by chance once in 150 000 cases

struct Mean {
  double value, error;
  int count;
};

// Half the square of kDeviations, about: minus the logarithm of the probability of a false alarm.
constexpr double kLogarithm = 13.3;

// Returns the largest weight f cos / density that a search finds. A narrow peak that no sample has met is in
// no sample variance, but in the range of the weights.
double largest_weight(const Term& term, const Vec3<double>& wo) {
  const std::span<const double> shape = term.shape_of(0);
  const auto weight_at = [&](std::span<const double> x) {
    const Vec3<double> wi = at_cosine(std::clamp(x[0], 1e-6, 1.0), 2 * kPi * x[1]);
    double f = 0;
    term.form->eval_cos(term.values(0), one_pair(wi, wo), &f);
    const double density = term.form->pdf(shape, wi, wo);
    return density > 0 ? f / density : f > 0 ? HUGE_VAL : 0;
  };
  SearchOptions how;
  how.cover = 4000;
  how.starts = 12;
  const double turn = std::atan2(wo.y, wo.x) / (2 * kPi), across = turn < 0 ? turn + 1 : turn;
  const auto opposite = [](double t) { return t < 0.5 ? t + 0.5 : t - 0.5; };
  return maximise(weight_at, 2, how, {{wo.z, across}, {wo.z, opposite(across)}, {1, 0}}).value;
}

// Returns whether samples that missed a rare large weight explain that their mean is below the truth.
// Bernstein's inequality with the variance of the samples (Maurer and Pontil 2009).
bool may_have_missed(const Term& term, const Vec3<double>& wo, const Mean& mean, double truth) {
  if (mean.value >= truth) return false;  // weights are not below 0, so that rare ones only lower the mean
  const double range = largest_weight(term, wo);
  return truth - mean.value <=
         std::sqrt(2 * kLogarithm) * mean.error + 7 * range * kLogarithm / (3 * double(mean.count - 1));
}

Mean estimate(const Term& term, const Vec3<double>& wo, int count, std::uint64_t seed) {
  const std::span<const double> shape = term.shape_of(0);
  Random random(seed);
  double sum = 0, sum2 = 0;
  for (int k = 0; k < count; ++k) {
    const double u1 = random.uniform(), u2 = random.uniform(), u3 = random.uniform();
    const Vec3<double> wi = term.form->sample(shape, u1, u2, u3, wo);
    const double density = term.form->pdf(shape, wi, wo);
    double f = 0;
    if (wi.z > 0 && density > 0) term.form->eval_cos(term.values(0), one_pair(wi, wo), &f);
    const double x = f == 0 ? 0 : f / density;
    sum += x;
    sum2 += x * x;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(sum2 / count - mean * mean, 0.0) / (count - 1)), count};
}

// Restricts the shape to wide lobes. A form without a sampler of its own uses cosine sampling, which misses
// narrow lobes.
void widen(const ReflectanceInfo& form, std::span<const double> x, std::vector<double>& shape) {
  for (std::size_t k = 0; k < form.shape.size(); ++k) {
    const ParameterInfo& p = form.shape[k];
    if (p.role == Role::exponent || p.role == Role::exponent_across)
      shape[k] = std::clamp(40 * x[k], p.min, p.max);
    if (p.role == Role::width || p.role == Role::width_across)
      shape[k] = std::clamp(0.15 + 0.85 * x[k], p.min, p.max);
  }
}

// The reason why cosine sampling may miss the lobe of a form that has no sampler; empty if it does not.
std::string cannot_be_judged(const ReflectanceInfo& form) {
  if (form.follows_lobe) return {};
  for (const ParameterInfo& p : form.shape)
    if (p.role == Role::other && p.map == Map::none)
      return "the form has no sampler, and the width of the lobe that " + std::string(p.name) +
             " sets is not known";
  return {};
}

}  // namespace

Finding check_sampling(const Subject& subject, const CheckOptions& options) {
  if (!subject.of_form())
    return not_applicable(subject.name(), "sampling", "sampling is a property of forms");
  const ReflectanceInfo& form = info(*subject.of_form());
  if (const std::string why = cannot_be_judged(form); !why.empty())
    return not_applicable(subject.name(), "sampling", why);
  Finding finding{subject.name(), "sampling"};
  finding.bound = kDeviations;
  const bool full = options.effort == Effort::full;
  const int cases = full ? 12 : 4, count = full ? 40000 : 8000;
  int missed = 0;  // cases in which the samples may have missed a part of the albedo
  for (int k = 0; k < cases; ++k) {
    const std::vector<double> x = cover_point(std::size_t(k), subject.dimensions() + 2, options.seed);
    Material m = subject.at(x);
    Term& term = m.terms.front();
    widen(form, x, term.shape.front());
    const Angle theta = radians(in_radians(x[x.size() - 2] * 80)), phi = radians(x.back() * 2 * kPi);
    const double theta_o = in_degrees(theta.radians()), phi_o = in_degrees(phi.radians());
    AlbedoOptions integral;
    integral.fixed = Fixed::viewer;
    integral.tolerance = 1e-6;
    const AlbedoResult truth = directional_albedo(term, 0, theta, phi, integral);
    const Mean mean = estimate(term, direction(theta, phi), count, options.seed + std::uint64_t(k));
    const double z = std::abs(mean.value - truth.value) / (mean.error + 1e-12 + truth.error_bound);
    finding.evaluations += truth.evaluations + count;
    if (!std::isfinite(z)) {
      finding.outcome = Outcome::undecided;
      finding.statement = "some values are not finite numbers, so that their mean is not known";
      return finding;
    }
    if (z > kDeviations && may_have_missed(term, direction(theta, phi), mean, truth.value)) {
      ++missed;
      continue;
    }
    if (!is_worst(z, finding.value)) continue;
    finding.value = z;
    finding.witness = Witness{
        subject.parameters(m),
        {{"theta_o", theta_o}, {"phi_o", phi_o}},
        {},
        subject.command("albedo", m,
                        "--fixed o --theta " + io::to_text(theta_o) + " --phi " + io::to_text(phi_o))};
  }
  finding.conclude(finding.value <= kDeviations, "the mean of the sampler equals the albedo",
                   "the mean of the sampler differs from the albedo");
  finding.statement += ": the worst of " + std::to_string(cases - missed) + " cases differs by " +
                       io::to_text(std::round(100 * finding.value) / 100) + " standard errors";
  if (missed > 0 && finding.outcome == Outcome::pass) {
    finding.outcome = Outcome::undecided;
    finding.statement =
        "the samples are too few: in " + std::to_string(missed) + " of " + std::to_string(cases) +
        " cases they may have missed a narrow part of the albedo, which their variance does not "
        "show";
  }
  return finding;
}

}  // namespace brdf::validate
