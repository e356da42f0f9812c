// Directional albedos and average albedos: selection of the rule, and error control.
#include <algorithm>
#include <array>
#include <cmath>

#include "brdf/quadrature.h"
#include "libbrdf/src/integrals/convergence.h"
#include "libbrdf/src/integrals/functions.h"
#include "libbrdf/src/integrals/integrand.h"

namespace brdf {
namespace integrals {
namespace {

constexpr std::array kOrders{6, 8, 12, 16, 24, 32, 48, 64, 96, 128};
constexpr int kFirstAccepted = 12;
constexpr double kNodesPerFold = 1.25;  // with fewer, two orders may agree because both miss the same part

using PanelRule = Sums (*)(const Integrand&, const FixedDirection&, int);

std::vector<AlbedoResult> escalate(PanelRule rule, Rule name, const Integrand& integrand,
                                   const FixedDirection& fixed, const AlbedoOptions& options) {
  std::vector<AlbedoResult> results(integrand.outputs());
  std::vector<History> history(integrand.outputs());
  const bool kinked = integrand.features().kink == Kink::v_cavity;
  const Fall fall = kinked || name == Rule::slope ? Fall::slow : Fall::fast;
  long evaluations = 0;
  for (const int n : kOrders) {
    const Sums sums = rule(integrand, fixed, n);
    evaluations += sums.evaluations;
    const std::vector<double> values = integrand.combine(sums.columns);
    const double rounding = rounding_of(integrand, fixed, sums.evaluations);
    bool all = true;
    for (std::size_t k = 0; k < results.size(); ++k) {
      history[k].add(values[k]);
      const double floor = rounding * std::abs(values[k]);
      const double error = truncation_error(history[k], fall, floor) + floor;
      results[k] = {values[k], error, evaluations,
                    n >= std::max(double(kFirstAccepted), kNodesPerFold * sums.folds) &&
                        error <= options.tolerance * std::abs(values[k]),
                    name};
      if (values[k] == 0 && error == 0) results[k].converged = true;
      all = all && results[k].converged;
    }
    // The next order costs about twice as many evaluations.
    if (all || evaluations + 2 * sums.evaluations > options.max_evaluations) break;
  }
  return results;
}

std::vector<AlbedoResult> fixed_order(PanelRule rule, Rule name, const Integrand& integrand,
                                      const FixedDirection& fixed, int n) {
  const Sums sums = rule(integrand, fixed, n);
  std::vector<AlbedoResult> results;
  for (const double value : integrand.combine(sums.columns))
    results.push_back({value, HUGE_VAL, sums.evaluations, false, name});
  return results;
}

// Returns the requested rule or a rule that can replace it. `pole` requires isotropic lobes. At the horizon
// itself lobes of the half vector also need `slope`, because the width of a row goes to 0 with its
// elevation. `slope` requires lobes of the half vector. A kink at an unknown location requires bisection.
Rule applicable(const Features& features, const FixedDirection& fixed, Rule asked) {
  if (asked == Rule::adaptive || features.kink == Kink::unplaced) return Rule::adaptive;
  const bool half_vector = features.about_half_vector();
  if (half_vector && (asked == Rule::slope || fixed.elevation < kGrazing)) return Rule::slope;
  if (!features.anisotropic()) return Rule::pole;
  return half_vector ? Rule::slope : Rule::adaptive;
}

}  // namespace

// Directions are stored in double precision. Near grazing, a lobe of width a covers a range of a cos
// (at the horizon a^2) in the components of the half vector, each rounded to 1e-16. The errors average out
// over many points.
double rounding_of(const Integrand& integrand, const FixedDirection& fixed, long evaluations) {
  constexpr double kRounding = 4e-15;  // of a sum of ten thousand terms with one sign
  const double width = std::min(integrand.features().width_x, integrand.features().width_y);
  const double stored =
      1e-15 / (width * std::max(integrals::sin(fixed.elevation), width / 4) * std::sqrt(double(evaluations)));
  return kRounding + stored;
}

std::vector<AlbedoResult> integrate(const Integrand& integrand, const FixedDirection& fixed,
                                    const AlbedoOptions& options) {
  const Rule name = applicable(integrand.features(), fixed, options.rule);
  if (name == Rule::adaptive)
    return adaptive_rule(integrand, fixed, options.tolerance, options.max_evaluations);
  const PanelRule rule = name == Rule::slope ? slope_rule : pole_rule;
  if (options.order > 0) return fixed_order(rule, name, integrand, fixed, options.order);
  return escalate(rule, name, integrand, fixed, options);
}

}  // namespace integrals

namespace {

using integrals::FixedDirection;
using integrals::Integrand;

FixedDirection fixed_direction(Angle theta, Angle phi) {
  return {std::max(kPi / 2 - theta.radians(), 0.0), phi.radians()};
}

// Adds the albedo of the term to the results of its channels.
void add_term(const Term& term, Angle theta, Angle phi, const AlbedoOptions& options,
              std::vector<AlbedoResult>& results) {
  for (const auto& group : integrals::groups_of_one_shape(term)) {
    const Integrand integrand(term, group, options.fixed);
    const auto found =
        integrals::integrate(integrand, fixed_direction(theta, phi - term.tangent_phi), options);
    for (std::size_t k = 0; k < group.size(); ++k) {
      AlbedoResult& r = results[group[k]];
      r.value += found[k].value;
      r.error_bound += found[k].error_bound;
      r.evaluations += found[k].evaluations;
      r.converged = r.converged && found[k].converged;
      r.rule = found[k].rule;
    }
  }
}

}  // namespace

AlbedoResult directional_albedo(const Term& term, std::size_t channel, Angle theta, Angle phi,
                                const AlbedoOptions& options) {
  const Integrand integrand(term, {channel}, options.fixed);
  return integrals::integrate(integrand, fixed_direction(theta, phi - term.tangent_phi), options).front();
}

std::vector<AlbedoResult> directional_albedo(const Material& material, Angle theta, Angle phi,
                                             const AlbedoOptions& options) {
  std::vector<AlbedoResult> results(material.channels.size(), {0, 0, 0, true, options.rule});
  for (const Term& term : material.terms) add_term(term, theta, phi, options, results);
  return results;
}

std::vector<AlbedoResult> lobe_albedos(const Reflectance& form, std::span<const double> shape, Angle theta,
                                       Angle phi, const AlbedoOptions& options) {
  const Integrand integrand(form, shape, options.fixed);
  if (integrand.columns() == 0) return {};
  return integrals::integrate(integrand, fixed_direction(theta, phi), options);
}

AlbedoResult average_albedo(const Term& term, std::size_t channel, const AlbedoOptions& options) {
  const Integrand integrand(term, {channel}, options.fixed);
  const bool anisotropic = integrand.features().anisotropic();
  AlbedoOptions inner = options;
  inner.tolerance = options.tolerance / 4;
  inner.order = 0;
  AlbedoResult result;
  double previous = 0;
  for (const int n : {8, 12, 16, 24, 32, 48, 64}) {
    const auto& rule = quadrature::gauss_legendre(n);
    double sum = 0, bound = 0;
    bool converged = true;
    for (std::size_t k = 0; k < rule.node.size(); ++k) {
      // Elevation e = pi/2 v^2: the albedo varies like a root of the cosine at the horizon. For every form
      // of the catalogue the four quadrants are equal; a quarter turn of azimuths is therefore sufficient.
      const double v = rule.node[k], e = kPi / 2 * v * v;
      const double weight = 2 * integrals::sin(e) * integrals::cos(e) * kPi * v * rule.weight[k];
      const int turns = anisotropic ? n : 1;
      for (int j = 0; j < turns; ++j) {
        const double phi = anisotropic ? kPi / 2 * rule.node[std::size_t(j)] : 0;
        const double share = anisotropic ? rule.weight[std::size_t(j)] : 1;
        const auto r = integrals::integrate(integrand, {e, phi}, inner).front();
        sum += weight * share * r.value;
        bound += weight * share * r.error_bound;
        converged = converged && r.converged;
        result.evaluations += r.evaluations;
        result.rule = r.rule;
      }
    }
    result.error_bound = std::abs(sum - previous) + bound;
    result.value = sum;
    result.converged = n > 8 && converged && result.error_bound <= options.tolerance * std::abs(sum);
    if (result.converged || result.evaluations > 50 * options.max_evaluations) break;
    previous = sum;
  }
  return result;
}

}  // namespace brdf
