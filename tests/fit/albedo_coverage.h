// Measures how often the confidence interval of a fitted material's albedo covers the true albedo.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include <random>

#include "brdf/integrals.h"
#include "fit/assess/assess.h"
#include "fit/assess/derived.h"
#include "fit/solve/minima.h"
#include "samples.h"

namespace brdf::fit {

struct CoverageCase {
  const char* form;
  std::vector<double> shape, weights;
};

inline std::vector<CoverageCase> coverage_cases() {
  return {{"ward", {0.15, 0.15}, {0.3, 0.2}}, {"cook_torrance", {0.25, 0.25}, {0.2, 0.8, 0.3}}};
}

inline std::vector<double> albedos(const Material& m, const std::vector<double>& angles) {
  AlbedoOptions options;
  options.tolerance = 1e-8;
  std::vector<double> out;
  for (const double theta : angles)
    out.push_back(directional_albedo(m, degrees(theta), {}, options)[0].value);
  return out;
}

struct Covered {
  int inside = 0;
  double sum = 0, square = 0;  // sums of (value - truth) / (half the interval / 1.96) and of its square
};

// Fits `replicates` tables of value * exp(0.05 z), z normal, and counts how their 95 % intervals cover the
// true albedo. Under Metric::log the noise is exp(0.05 z - 0.00125), which has mean 1, because that metric
// does not shift the mean; for the other metrics the exponent has mean 0. Returns the counts by angle of
// incidence in degrees.
inline std::map<double, Covered> covered_albedos(const CoverageCase& c, int replicates, std::uint64_t seed,
                                                 Metric metric = Metric::log) {
  const std::vector<double> angles{0, 45, 70};
  Material truth = make_material(*find_form(c.form), {"f"});
  truth.terms[0].shape[0] = c.shape;
  truth.terms[0].weights[0] = c.weights;
  const std::vector<double> exact = albedos(truth, angles);
  FitOptions options;
  options.metric = metric;
  options.aperture = 0;
  const Residual residual{.metric = metric};
  const double drift = metric == Metric::log ? 0.00125 : 0;
  FitData data = prepare(measured(truth), options);
  const std::vector<double> clean = data.values[0];
  const Model model({truth.terms[0].form}, data.channels, options);
  const std::vector<double> start = find_minima(data, model, residual, options).minima.front().p;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::map<double, Covered> out;
  for (int k = 0; k < replicates; ++k) {
    for (std::size_t j = 0; j < clean.size(); ++j)
      data.values[0][j] = clean[j] * std::exp(0.05 * normal(random) - drift);
    const SampleStream stream(data, model, residual, 0);
    const Solution s = refine(stream, start, {});
    const Uncertainty u = uncertainty(stream, {s.p, s.cost, 1, s.at_bound, s.termination, s.message});
    const Material fitted = model.material(s.p);
    const std::vector<double> values = albedos(fitted, angles);
    const auto found = intervals(fitted, u.covariance.value(), values,
                                 [&](const Material& m) { return albedos(m, angles); });
    for (std::size_t a = 0; a < angles.size(); ++a) {
      const auto [low, high] = (*found)[a];
      out[angles[a]].inside += low <= exact[a] && exact[a] <= high;
      const double z = (values[a] - exact[a]) / ((high - low) / (2 * 1.96));
      out[angles[a]].sum += z;
      out[angles[a]].square += z * z;
    }
  }
  return out;
}

}  // namespace brdf::fit
