#include "validate/numerics/error_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "brdf/integrals.h"
#include "brdf/random.h"
#include "io/files/parallel.h"
#include "validate/numerics/integral_cases.h"
#include "validate/search/degrees.h"
#include "validate/search/subject.h"

namespace brdf::validate {
namespace {

struct Way {
  Rule rule;
  double tolerance;
};
constexpr double kTight = 1e-12;
constexpr std::array<Way, 6> kWays{{{Rule::automatic, 1e-4},
                                    {Rule::automatic, 1e-6},
                                    {Rule::automatic, kTight},
                                    {Rule::pole, 1e-6},
                                    {Rule::slope, 1e-6},
                                    {Rule::adaptive, 1e-6}}};
constexpr std::size_t kPairsPerCase = kWays.size() * (kWays.size() - 1) / 2;

struct Case {
  IntegralCase integral;
  Fixed fixed;
};

double polar_angle(Random& random) {
  const double kind = random.uniform();
  if (kind < 0.1) return 0;
  if (kind < 0.12) return kPi / 2;
  return kind < 0.5 ? random.uniform(0, kPi / 2) : in_radians(90 - random.log_uniform(0.1, 10));
}

Case random_case(const Reflectance& form, Random& random) {
  const ReflectanceInfo& f = info(form);
  Term term = make_term(form, 1);
  for (std::size_t k = 0; k < f.shape.size(); ++k) {
    const bool end = random.uniform() < 0.15;
    const double x = random.uniform();
    term.shape[0][k] = parameter_value(f.shape[k], end ? std::round(x) : x, f.shape[k].max);
  }
  if (const auto [along, across] = f.axes(); across >= 0) {
    double &x = term.shape[0][std::size_t(along)], &y = term.shape[0][std::size_t(across)];
    const double kind = random.uniform();
    if (kind < 0.25) y = x;
    if (kind > 0.75 && f.shape_index(Role::width) == along) {  // as in typical materials
      x = random.log_uniform(0.02, 0.8);
      y = random.log_uniform(0.02, 0.8);
    }
  }
  if (random.uniform() < 0.5)
    for (std::size_t k = 0; k < f.weights.size(); ++k)
      term.weights[0][k] = random.uniform() < 0.3 ? 0 : std::min(1.0, f.weights[k].max) * random.uniform();
  const double theta = polar_angle(random), phi = random.uniform() < 0.2 ? 0 : random.uniform(0, 2 * kPi);
  return {{term, theta, phi}, random.uniform() < 0.7 ? Fixed::light : Fixed::viewer};
}

std::array<AlbedoResult, kWays.size()> integrate(const Case& c) {
  std::array<AlbedoResult, kWays.size()> results;
  for (std::size_t k = 0; k < kWays.size(); ++k) {
    AlbedoOptions options;
    options.rule = kWays[k].rule;
    options.tolerance = kWays[k].tolerance;
    options.fixed = c.fixed;
    options.max_evaluations = 1'000'000;
    results[k] =
        directional_albedo(c.integral.term, 0, radians(c.integral.theta), radians(c.integral.phi), options);
  }
  return results;
}

// Adds the pairs of one case to the row.
void compare(const Case& c, IntegratorRow& row) {
  const auto results = integrate(c);
  const auto usable = [&](std::size_t k) { return results[k].converged || kWays[k].tolerance == kTight; };
  for (std::size_t i = 0; i < kWays.size(); ++i) {
    row.unconverged += !results[i].converged;
    row.mean_evaluations += double(results[i].evaluations);
    for (std::size_t j = i + 1; j < kWays.size(); ++j) {
      if (!usable(i) || !usable(j)) continue;
      ++row.cases;
      const double apart = std::abs(results[i].value - results[j].value),
                   allowed = results[i].error_bound + results[j].error_bound;
      row.wrong += !(apart <= allowed);
      if (apart == 0 || apart / allowed <= row.worst) continue;
      row.worst = apart / allowed;
      row.worst_case = place_of(c.integral) + (c.fixed == Fixed::light ? "" : " fixed=o") + ": " +
                       std::string(name_of(kWays[i].rule)) + " against " +
                       std::string(name_of(kWays[j].rule));
    }
  }
}

}  // namespace

std::vector<IntegratorRow> check_bounds(std::uint64_t seed, std::size_t pairs,
                                        const std::function<void(const IntegratorRow&)>& progress) {
  std::vector<IntegratorRow> rows;
  // A tenth more cases than needed, because results that did not converge contribute no pairs.
  const std::size_t share = catalogue().size() * kPairsPerCase, cases = (pairs * 11 / 10 + share - 1) / share;
  for (const Reflectance& form : catalogue()) {
    IntegratorRow total{"bounds_" + std::string(info(form).name), 1e-6, 0, 0, 0, 0, 0, {}};
    const auto measure = [&](int k) {
      Random random(1'000'003 * seed + 1000 * rows.size() + std::size_t(k));
      IntegratorRow one{};
      compare(random_case(form, random), one);
      return one;
    };
    const auto add = [&](const IntegratorRow& one) {
      total.cases += one.cases;
      total.wrong += one.wrong;
      total.unconverged += one.unconverged;
      total.mean_evaluations += one.mean_evaluations / double(cases * kWays.size());
      if (one.worst <= total.worst) return;
      total.worst = one.worst;
      total.worst_case = one.worst_case;
    };
    io::parallel_in_order(int(cases), int(io::all_processors()), {}, measure, add);
    rows.push_back(std::move(total));
    if (progress) progress(rows.back());
  }
  return rows;
}

}  // namespace brdf::validate
