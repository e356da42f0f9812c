#include "validate/integrators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>

#include "validate/parallel.h"

namespace brdf::validate {
namespace {

constexpr int kTruthOrder = 192;
constexpr long kConfirmed = 100;       // cases of a set whose truth the second rule must confirm
constexpr double kTruthError = 1e-12;  // of the truth itself: rounding of its sum

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // The library's distributions differ between implementations; this does not.
  double uniform() { return double(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }

 private:
  std::mt19937_64 engine_;
};

// One channel, the lobe alone: full specular weight, F = 1 or Schlick's with f0 = 0.04 where the form has f0.
Term lobe_of(const AnyForm& form, std::vector<double> shape, bool schlick) {
  Term term = make_term(form, 1);
  term.shape = {std::move(shape)};
  const FormInfo& f = info(form);
  for (std::size_t k = 0; k < f.weights.size(); ++k)
    term.weights[0][k] = f.weights[k].name == "kd" ? 0 : f.weights[k].name == "f0" && schlick ? 0.04 : 1;
  return term;
}

// Half of the angles over the whole range, half within ten degrees of its end.
double half_grazing(Random& random) {
  const bool grazing = random.uniform() < 0.5;
  const double degrees = grazing ? 90 - random.log_uniform(0.1, 10) : random.uniform(0, 89.9);
  return degrees * kPi / 180;
}

std::vector<double> shape_with(const AnyForm& form, double alpha_x, double alpha_y) {
  std::vector<double> shape;
  for (const ParameterInfo& p : info(form).shape)
    shape.push_back(p.name == "alpha_x" ? alpha_x : p.name == "alpha_y" ? alpha_y : p.initial);
  return shape;
}

struct Settled {
  double value;
  std::string place;
};

std::string place_of(const IntegralCase& c) {
  std::ostringstream text;
  text << info(c.term.form).name;
  text.precision(10);
  for (std::size_t k = 0; k < c.term.shape[0].size(); ++k)
    text << ' ' << info(c.term.form).shape[k].name << '=' << c.term.shape[0][k];
  text << " theta=" << c.theta * 180 / kPi << " phi=" << c.phi * 180 / kPi;
  return text.str();
}

AlbedoResult truth_of(const IntegralCase& c) {
  AlbedoOptions options;
  options.order = kTruthOrder;
  return directional_albedo(c.term, 0, c.theta, c.phi, options);
}

// Counts the results that are farther from the truth than they may be.
IntegratorRow compare(std::string set, double tolerance, const std::vector<IntegralCase>& cases,
                      const std::vector<double>& truth, const std::vector<AlbedoResult>& results) {
  IntegratorRow row{std::move(set), tolerance, cases.size(), 0, 0, 0, 0, {}};
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const AlbedoResult& r = results[k];
    const double allowed = (r.converged ? tolerance : r.error_bound / std::abs(truth[k])) + kTruthError;
    const double error = std::abs(r.value - truth[k]) / (std::abs(truth[k]) * allowed);
    row.wrong += !(error <= 1);
    row.unconverged += !r.converged;
    row.mean_evaluations += double(r.evaluations) / double(cases.size());
    if (!(error <= row.worst)) {
      row.worst = error;
      row.worst_case = place_of(cases[k]);
    }
  }
  return row;
}

}  // namespace

std::vector<std::string> integral_sets() {
  std::vector<std::string> sets{"isotropic", "grazing", "anisotropic", "ward"};
  if (find_form("cook_torrance_vcavity")) sets.push_back("v_cavity");
  return sets;
}

std::vector<IntegralCase> integral_cases(const std::string& set, std::uint64_t seed) {
  Random random(seed);
  std::vector<IntegralCase> cases;
  const std::size_t count = set == "isotropic" ? 1500 : set == "grazing" || set == "anisotropic" ? 500 : 300;
  for (std::size_t k = 0; k < count; ++k) {
    const bool schlick = k % 2;
    const double phi = random.uniform(0, 2 * kPi), theta = half_grazing(random);
    double ax = random.log_uniform(1e-4, 1), ay = ax;
    AnyForm form = cook_torrance{};
    double polar = theta;
    if (set == "grazing") {
      polar = std::acos(random.log_uniform(1e-5, 1));
    } else if (set == "anisotropic") {  // any two widths up to 1:1000
      ay = random.log_uniform(std::max(1e-4, ax / 1000), std::min(1.0, ax * 1000));
    } else if (set == "ward") {
      form = ward{};
      if (k % 4 == 3) ay = random.log_uniform(std::max(1e-4, ax / 1000), std::min(1.0, ax * 1000));
    } else if (set == "v_cavity") {
      form = find_form("cook_torrance_vcavity").value();
      if (k % 4 == 3) ay = random.log_uniform(std::max(1e-4, ax / 1000), std::min(1.0, ax * 1000));
    }
    cases.push_back({lobe_of(form, shape_with(form, ax, ay), schlick), polar, phi});
  }
  return cases;
}

std::vector<IntegratorRow> check_integrators(std::uint64_t seed,
                                             const std::function<void(const IntegratorRow&)>& progress) {
  std::vector<IntegratorRow> rows;
  const auto report = [&](IntegratorRow row) {
    rows.push_back(std::move(row));
    if (progress) progress(rows.back());
  };
  const std::vector<std::string> sets = integral_sets();
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const std::vector<IntegralCase> cases = integral_cases(sets[s], seed + s);
    std::vector<double> truth(cases.size());
    parallel_for(cases.size(), [&](std::size_t k) { truth[k] = truth_of(cases[k]).value; });
    for (const double tolerance : {1e-4, 1e-6, 1e-10}) {
      std::vector<AlbedoResult> results(cases.size());
      parallel_for(cases.size(), [&](std::size_t k) {
        AlbedoOptions options;
        options.tolerance = tolerance;
        results[k] = directional_albedo(cases[k].term, 0, cases[k].theta, cases[k].phi, options);
      });
      report(compare(sets[s], tolerance, cases, truth, results));
    }
    // The truth itself, by a rule of another kind.
    const std::vector<IntegralCase> few(cases.begin(), cases.begin() + kConfirmed);
    std::vector<AlbedoResult> second(few.size());
    parallel_for(few.size(), [&](std::size_t k) {
      AlbedoOptions options;
      options.tolerance = 1e-7;
      options.max_evaluations = 40'000'000;
      const bool equal = few[k].term.shape[0][0] == few[k].term.shape[0][1];
      for (const Rule rule : {Rule::slope, Rule::adaptive}) {
        if (rule == Rule::slope && !equal) continue;  // it gave the truth
        options.rule = rule;
        second[k] = directional_albedo(few[k].term, 0, few[k].theta, few[k].phi, options);
        if (second[k].converged) break;
      }
    });
    report(compare("second_rule_" + sets[s], 1e-7, few, truth, second));
  }
  return rows;
}

}  // namespace brdf::validate
