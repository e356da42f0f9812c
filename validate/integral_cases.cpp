#include "validate/integral_cases.h"

#include <algorithm>
#include <sstream>

namespace brdf::validate {
namespace {

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

}  // namespace

std::string place_of(const IntegralCase& c) {
  std::ostringstream text;
  text << info(c.term.form).name;
  text.precision(10);
  for (std::size_t k = 0; k < c.term.shape[0].size(); ++k)
    text << ' ' << info(c.term.form).shape[k].name << '=' << c.term.shape[0][k];
  text << " theta=" << c.theta * 180 / kPi << " phi=" << c.phi * 180 / kPi;
  return text.str();
}

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

}  // namespace brdf::validate
