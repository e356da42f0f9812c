#include "validate/numerics/integral_cases.h"

#include <algorithm>
#include <cmath>

#include "brdf/random.h"
#include "io/files/numbers.h"
#include "validate/search/degrees.h"
#include "validate/search/extremes.h"

namespace brdf::validate {
namespace {

// A term of one channel with the lobe alone: full specular weight, F = 1, or Schlick's F with f0 = 0.04 if
// the form has an f0.
Term lobe_of(const Reflectance& form, std::vector<double> shape, bool schlick) {
  Term term = make_term(form, 1);
  term.shape = {std::move(shape)};
  const ReflectanceInfo& f = info(form);
  term.weights = {lobe_alone(f)};
  if (const int f0 = f.weight_index(Role::f0); f0 >= 0 && schlick) term.weights[0][std::size_t(f0)] = 0.04;
  return term;
}

// Half of the angles cover the whole range; the other half lie within ten degrees of its end.
double half_grazing(Random& random) {
  const bool grazing = random.uniform() < 0.5;
  return in_radians(grazing ? 90 - random.log_uniform(0.1, 10) : random.uniform(0, 89.9));
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

struct Set {
  std::string name;
  Reflectance form;
  std::size_t count;
  bool grazing;  // cosines down to 1e-5
  // Every so many cases have unequal widths, up to 1:1000. 0: equal widths only.
  int unequal_every = 0;
};

std::vector<Set> all_sets() {
  std::vector<Set> sets;
  if (const auto form = find_form_if(has_facets)) {
    sets.push_back({"isotropic", *form, 1500, false});
    sets.push_back({"grazing", *form, 500, true});
    sets.push_back({"anisotropic", *form, 500, false, 1});
  }
  if (const auto form = find_form_if(has_widths_alone))
    sets.push_back({std::string(form->info().name), *form, 300, false, 4});
  if (const auto form = find_form_if(has_v_cavities)) sets.push_back({"v_cavity", *form, 300, false, 4});
  return sets;
}

}  // namespace

std::string place_of(const IntegralCase& c) {
  const ReflectanceInfo& f = info(c.term.form);
  std::string text(f.name);
  const auto add = [&](std::string_view name, double value) {
    text += " " + std::string(name) + "=" + io::short_number(value, 10);
  };
  for (std::size_t k = 0; k < f.shape.size(); ++k) add(f.shape[k].name, c.term.shape[0][k]);
  add("theta", in_degrees(c.theta));
  add("phi", in_degrees(c.phi));
  return text;
}

std::vector<std::string> integral_sets() {
  std::vector<std::string> names;
  for (const Set& set : all_sets()) names.push_back(set.name);
  return names;
}

std::vector<IntegralCase> integral_cases(const std::string& name, std::uint64_t seed) {
  const std::vector<Set> sets = all_sets();
  const auto found = std::ranges::find_if(sets, [&](const Set& s) { return s.name == name; });
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
