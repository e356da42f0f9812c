// A goniometer with a wrong scale, wrong zeros of its angles and noise, and its budget.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <set>

#include "brdf/integrals.h"
#include "fit/assess/derived.h"
#include "fit/fit.h"

namespace brdf::fit {

// Standard uncertainties: relative, degrees, degrees, relative.
struct Instrument {
  double scale = 0.008, zero_i = 0.12, zero_o = 0.12, noise = 0.006;
};

inline std::shared_ptr<const io::Budget> budget_of(const Instrument& i) {
  using io::BudgetEffect, io::BudgetUnit, io::SharedBy;
  io::Budget budget{.file = "goniometer.csv", .text = {}, .sources = {}};
  budget.sources = {
      {"reference_standard", i.scale, BudgetUnit::relative, SharedBy::table, BudgetEffect::scale},
      {"zero_theta_i", i.zero_i, BudgetUnit::degree, SharedBy::table, BudgetEffect::theta_i},
      {"zero_theta_o", i.zero_o, BudgetUnit::degree, SharedBy::table, BudgetEffect::theta_o},
      {"repeatability", i.noise, BudgetUnit::relative, SharedBy::row, BudgetEffect::scale}};
  return std::make_shared<const io::Budget>(std::move(budget));
}

inline constexpr double kGlossyKd = 0.3;

inline Material glossy() {
  Material m = make_material(*find_form("cook_torrance"), {"f"});
  m.terms[0].shape[0] = {0.22, 0.22};
  m.terms[0].weights[0] = {kGlossyKd, 0.9, 0.05};
  return m;
}

inline Material matt(double kd) {
  Material m = make_material(*find_form("lambert"), {"f"});
  m.terms[0].weights[0] = {kd};
  return m;
}

// Reads a surface with errors that the seed draws; seed 0 draws none. The instrument divides by the cosine of
// the nominal viewing angle.
inline io::SampleTable read_by(const Instrument& i, const Material& surface, std::uint64_t seed = 0) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&](double u) { return seed == 0 ? 0 : u * normal(random); };
  const double scale = draw(i.scale), zero_i = draw(i.zero_i), zero_o = draw(i.zero_o);
  io::SampleTable table;
  table.set_channels({"f"});
  std::vector<double> value(1);
  for (const double theta_i : {0., 20., 40., 60.})
    for (double theta_o = 0; theta_o < 76; theta_o += 6)
      for (const double phi_o : {0., 90., 180.}) {
        table.add_directions(theta_i, 180, theta_o, phi_o);
        const auto turned = [](double theta, double phi) {
          return theta < 0 ? direction(degrees(-theta), degrees(phi + 180))
                           : direction(degrees(theta), degrees(phi));
        };
        const Vec3<double> wo = turned(theta_o + zero_o, phi_o);
        eval(surface, turned(theta_i + zero_i, 180), wo, value);
        const double cosine = std::cos(degrees(theta_o).radians());
        table.values[0].push_back(value[0] * wo.z / cosine * std::exp(scale + draw(i.noise)));
      }
  return table;
}

// Fits tables of as many simulated instruments and returns the shares of 95 % intervals that hold the truth.
inline std::map<std::string, double> covered_by_budget(int instruments, std::uint64_t seed) {
  const Instrument instrument;
  const Material truth = glossy();
  const auto albedo = [](const Material& m) {
    AlbedoOptions options;
    options.tolerance = 1e-8;
    return std::vector<double>{directional_albedo(m, degrees(8), {}, options)[0].value};
  };
  const double true_albedo = albedo(truth)[0];
  FitOptions options{.metric = Metric::log_relative, .fix = {{"f0", {truth.terms[0].weights[0][2]}}}};
  options.cross_validation = options.profiles = false;
  options.budget = budget_of(instrument);
  std::map<std::string, double> held;
  for (int k = 0; k < instruments; ++k) {
    const FormFit f =
        fit(read_by(instrument, truth, seed + std::uint64_t(k)), {{truth.terms[0].form}}, options)
            .ranking.front();
    for (const auto& [name, value] :
         {std::pair{"alpha_x", truth.terms[0].shape[0][0]}, std::pair{"kd", truth.terms[0].weights[0][0]},
          std::pair{"ks", truth.terms[0].weights[0][1]}}) {
      const Estimate& e = *std::ranges::find(f.estimates, std::string(name), &Estimate::name);
      held[name] += (e.low <= value && value <= e.high) / double(instruments);
    }
    const std::vector<double> value = albedo(f.material);
    const auto found = intervals(f.material, f.covariance.value(), value, albedo);
    held["albedo"] +=
        ((*found)[0].low <= true_albedo && true_albedo <= (*found)[0].high) / double(instruments);
  }
  return held;
}

}  // namespace brdf::fit
