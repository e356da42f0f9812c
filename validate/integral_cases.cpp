#include "validate/integral_cases.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace brdf::validate {
namespace {

// One channel, the lobe alone: full specular weight, F = 1 or Schlick's with f0 = 0.04 where the form has f0.
Term lobe_of(const Reflectance& form, std::vector<double> shape, bool schlick) {
  Term term = make_term(form, 1);
  term.shape = {std::move(shape)};
  const ReflectanceInfo& f = info(form);
  for (std::size_t k = 0; k < f.weights.size(); ++k)
    term.weights[0][k] = f.weights[k].role == Role::diffuse         ? 0
                         : f.weights[k].role == Role::f0 && schlick ? 0.04
                                                                    : 1;
  return term;
}

// Half of the angles over the whole range, half within ten degrees of its end.
double half_grazing(Random& random) {
  const bool grazing = random.uniform() < 0.5;
  const double degrees = grazing ? 90 - random.log_uniform(0.1, 10) : random.uniform(0, 89.9);
  return degrees * kPi / 180;
}

std::vector<double> shape_with(const Reflectance& form, double along, double across) {
  std::vector<double> shape;
  for (const ParameterInfo& p : info(form).shape)
    shape.push_back(p.role == Role::width ? along : p.role == Role::width_across ? across : p.initial);
  return shape;
}

bool has_widths(const ReflectanceInfo& f) {
  return f.fittable() && f.shape_index(Role::width) >= 0 && f.shape_index(Role::width_across) >= 0;
}
bool has_facets(const ReflectanceInfo& f) {
  return has_widths(f) && f.facets;
}
bool has_widths_alone(const ReflectanceInfo& f) {
  return has_widths(f) && !f.facets;
}
bool has_v_cavities(const ReflectanceInfo& f) {
  return has_widths(f) && f.kink == Kink::v_cavity;
}

std::optional<Reflectance> first_form(bool (*is)(const ReflectanceInfo&)) {
  for (const Reflectance& form : catalogue())
    if (is(form.info())) return form;
  return std::nullopt;
}

struct Set {
  std::string name;
  Reflectance form;
  std::size_t count;
  bool grazing;           // cosines down to 1e-5
  int unequal_every = 0;  // any two widths up to 1:1000 in every so many cases; 0: equal widths only
};

std::vector<Set> all_sets() {
  std::vector<Set> sets;
  if (const auto form = first_form(has_facets)) {
    sets.push_back({"isotropic", *form, 1500, false});
    sets.push_back({"grazing", *form, 500, true});
    sets.push_back({"anisotropic", *form, 500, false, 1});
  }
  if (const auto form = first_form(has_widths_alone))
    sets.push_back({std::string(form->info().name), *form, 300, false, 4});
  if (const auto form = first_form(has_v_cavities)) sets.push_back({"v_cavity", *form, 300, false, 4});
  return sets;
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
  std::vector<std::string> names;
  for (const Set& set : all_sets()) names.push_back(set.name);
  return names;
}

std::vector<IntegralCase> integral_cases(const std::string& name, std::uint64_t seed) {
  const std::vector<Set> sets = all_sets();
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Set& s) { return s.name == name; });
  if (found == sets.end()) return {};
  Random random(seed);
  std::vector<IntegralCase> cases;
  for (std::size_t k = 0; k < found->count; ++k) {
    const double phi = random.uniform(0, 2 * kPi), theta = half_grazing(random);
    const double along = random.log_uniform(1e-4, 1);
    const double polar = found->grazing ? std::acos(random.log_uniform(1e-5, 1)) : theta;
    const std::size_t every = std::size_t(found->unequal_every);
    const bool unequal = every > 0 && k % every == every - 1;
    const double across =
        unequal ? random.log_uniform(std::max(1e-4, along / 1000), std::min(1.0, along * 1000)) : along;
    cases.push_back({lobe_of(found->form, shape_with(found->form, along, across), k % 2), polar, phi});
  }
  return cases;
}

}  // namespace brdf::validate
