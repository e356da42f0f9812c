// Tables that laboratories measure of one surface, with their own errors.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "brdf/aperture.h"
#include "fit/between/tables.h"
#include "samples.h"

namespace brdf::fit {

// The errors of one table. Angles in degrees; the scale and the noise are relative.
struct LaboratoryErrors {
  double scale = 0, zero_i = 0, zero_o = 0, noise = 0.005, aperture = 0;
};

// Returns errors with these standard deviations.
inline LaboratoryErrors drawn_errors(double scale, double zero, double noise, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double s = scale * normal(random), i = zero * normal(random), o = zero * normal(random);
  return {.scale = s, .zero_i = i, .zero_o = o, .noise = noise};
}

// Returns the budget that states these standard deviations.
inline std::shared_ptr<const io::Budget> budget_of(double scale, double zero, double noise) {
  io::Budget budget;
  using Unit = io::BudgetUnit;
  using By = io::SharedBy;
  using Effect = io::BudgetEffect;
  budget.sources = {{"reference_standard", scale, Unit::relative, By::table, Effect::scale},
                    {"zero_theta_i", zero, Unit::degree, By::table, Effect::theta_i},
                    {"zero_theta_o", zero, Unit::degree, By::table, Effect::theta_o},
                    {"repeatability", noise, Unit::relative, By::row, Effect::scale}};
  return std::make_shared<const io::Budget>(std::move(budget));
}

// A factor of the surface that no form has, by theta_i, theta_o in radians and the azimuth between them.
using Structure = std::function<double(double, double, double)>;

inline double no_structure(double, double, double) {
  return 1;
}

// A smooth, reciprocal factor of some per cent.
inline double structure_of_3_percent(double theta_i, double theta_o, double turn) {
  const double x = 1 - std::cos(theta_i), z = 1 - std::cos(theta_o), s = -std::sqrt(x * z) * std::cos(turn);
  return std::exp(0.03 * (1.2 * s + 1.5 * (x + z) - 4 * x * z + 0.75 * std::sin(6 * (theta_i + theta_o))));
}

inline Material gloss(double alpha = 0.25, double kd = 0.4, double ks = 1, double f0 = 0.04) {
  Material m = make_material(*find_form("cook_torrance"), {"f_r"});
  const ReflectanceInfo& about = m.terms[0].form.info();
  for (std::size_t k = 0; k < about.shape.size(); ++k) m.terms[0].shape[0][k] = alpha;
  for (std::size_t k = 0; k < about.weights.size(); ++k) {
    const auto name = about.weights[k].name;
    m.terms[0].weights[0][k] = name == "kd" ? kd : name == "ks" ? ks : f0;
  }
  return m;
}

// Returns the same surface with channels of unequal kd.
inline Material spectral(std::size_t channels) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < channels; ++c) names.push_back(std::to_string(400 + 40 * c) + "nm");
  Material m = make_material(*find_form("cook_torrance"), names);
  const Material one = gloss();
  m.terms[0].shape = one.terms[0].shape;
  for (std::size_t c = 0; c < channels; ++c) {
    m.terms[0].weights[c] = one.terms[0].weights[0];
    for (std::size_t k = 0; k < m.terms[0].weights[c].size(); ++k)
      if (m.terms[0].form.info().weights[k].name == "kd")
        m.terms[0].weights[c][k] = 0.05 + 0.35 * double(c) / double(channels - 1);
  }
  return m;
}

// Returns 225 rows: five lights, fifteen views from `first_view` on in steps of five degrees, three azimuths.
// The instrument divides by the cosine of the stated theta_o.
inline io::SampleTable laboratory(const Material& surface, double first_view, const LaboratoryErrors& e,
                                  std::mt19937_64& random, const Structure& structure = no_structure,
                                  const std::string& name = "table.csv") {
  io::SampleTable table;
  table.source = name;
  table.set_channels(surface.channels);
  std::normal_distribution<double> normal;
  const auto detector = aperture_nodes(degrees(e.aperture), 3), source = aperture_nodes({});
  std::vector<double> f(surface.channels.size());
  for (const double light : {0, 15, 30, 45, 60})
    for (int k = 0; k < 15; ++k)
      for (const double phi : {0, 90, 180}) {
        const double view = first_view + 5 * k;
        const Angle theta_i = degrees(light + e.zero_i), theta_o = degrees(view + e.zero_o);
        const auto wi = direction(theta_i, degrees(180)), wo = direction(theta_o, degrees(phi));
        if (e.aperture > 0)
          eval_aperture(surface, wi, wo, source, detector, f);
        else
          eval(surface, wi, wo, f);
        const double factor = structure(theta_i.radians(), theta_o.radians(), degrees(phi - 180).radians()) *
                              std::cos(theta_o.radians()) / std::cos(degrees(view).radians());
        table.add_directions(light, 180, view, phi);
        for (std::size_t c = 0; c < f.size(); ++c)
          table.values[c].push_back(f[c] * factor * std::exp(e.scale + e.noise * normal(random)));
      }
  return table;
}

// Returns the fit of cook_torrance with f0 held, without the parts that no test of several tables needs.
inline FitOptions laboratory_options() {
  FitOptions options;
  options.metric = Metric::log_relative;
  options.fix = {{"f0", {0.04}}};
  options.profiles = false;
  options.cross_validation = false;
  return options;
}

inline std::vector<std::vector<Reflectance>> laboratory_model() {
  return {{*find_form("cook_torrance")}};
}

}  // namespace brdf::fit
