#include "validate/numerics/integrators.h"

#include <algorithm>
#include <cmath>

#include "brdf/integrals.h"
#include "io/files/parallel.h"

namespace brdf::validate {
namespace {

constexpr int kTruthOrder = 192;
constexpr long kConfirmed = 100;       // cases of a set for which the second rule must confirm the truth
constexpr double kTruthError = 1e-12;  // of the truth itself: the rounding of its sum

AlbedoResult truth_of(const IntegralCase& c) {
  AlbedoOptions options;
  options.order = kTruthOrder;
  return directional_albedo(c.term, 0, radians(c.theta), radians(c.phi), options);
}

// Counts the results that differ from the truth by more than the allowed error.
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
    io::parallel_for(cases.size(), [&](std::size_t k) { truth[k] = truth_of(cases[k]).value; });
    for (const double tolerance : {1e-4, 1e-6, 1e-10}) {
      std::vector<AlbedoResult> results(cases.size());
      io::parallel_for(cases.size(), [&](std::size_t k) {
        AlbedoOptions options;
        options.tolerance = tolerance;
        results[k] =
            directional_albedo(cases[k].term, 0, radians(cases[k].theta), radians(cases[k].phi), options);
      });
      report(compare(sets[s], tolerance, cases, truth, results));
    }
    // The truth itself, compared with a rule of another kind.
    const std::vector<IntegralCase> few(cases.begin(), cases.begin() + kConfirmed);
    std::vector<AlbedoResult> second(few.size());
    io::parallel_for(few.size(), [&](std::size_t k) {
      AlbedoOptions options;
      options.tolerance = 1e-7;
      options.max_evaluations = 40'000'000;
      const bool equal = !is_anisotropic({{}, {few[k].term}});
      for (const Rule rule : {Rule::slope, Rule::adaptive}) {
        if (rule == Rule::slope && !equal) continue;  // this rule computed the truth
        options.rule = rule;
        second[k] = directional_albedo(few[k].term, 0, radians(few[k].theta), radians(few[k].phi), options);
        if (second[k].converged) break;
      }
    });
    report(compare("second_rule_" + sets[s], 1e-7, few, truth, second));
  }
  return rows;
}

}  // namespace brdf::validate
