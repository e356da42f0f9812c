#include "interop/copied.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace brdf::interop {
namespace {

// Quantities of one channel of the wanted material, by role.
struct Said {
  double diffuse = 0, lobe = 0, f0 = 1;
  double index = 0, extinction = 0;  // index 0: not given
  double slope = 0;                  // slope of the diffuse part's facets

  // The lobe's reflectance along the normal.
  double normal() const { return std::min(lobe * f0, 1.0); }
};

// Returns true for a metal of a program: its only colour is the reflectance of the lobe.
bool is_metal(const ReflectanceInfo& form, const std::vector<double>& shape) {
  for (std::size_t k = 0; k < form.shape.size(); ++k)
    if (form.shape[k].map == Map::metallic) return shape[k] == 1;
  return false;
}

Said said_of(const Wanted& wanted, std::size_t channel) {
  Said said;
  for (const Term& term : wanted.material.terms) {
    const ReflectanceInfo& form = info(term.form);
    const auto value = [&](int k, const std::vector<double>& values) {
      return k < 0 ? 0 : values[std::size_t(k)];
    };
    const std::vector<double>& shape = term.shape[term.shape.size() > 1 ? channel : 0];
    said.diffuse += value(form.weight_index(Role::diffuse), term.weights[channel]);
    said.diffuse += value(form.shape_index(Role::diffuse), shape);
    if (form.shape_index(Role::slope) >= 0) said.slope = value(form.shape_index(Role::slope), shape);
    if (wanted.lobe < 0 || &term != &wanted.material.terms[std::size_t(wanted.lobe)]) continue;
    said.lobe = value(form.weight_index(Role::specular), term.weights[channel]);
    said.index = value(form.shape_index(Role::index), shape);
    said.extinction = value(form.shape_index(Role::extinction), shape);
    const double k2 = said.extinction * said.extinction;
    if (said.index > 0) said.f0 = (std::pow(said.index - 1, 2) + k2) / (std::pow(said.index + 1, 2) + k2);
    if (form.weight_index(Role::f0) >= 0) said.f0 = value(form.weight_index(Role::f0), term.weights[channel]);
    if (form.shape_index(Role::f0) >= 0) said.f0 = value(form.shape_index(Role::f0), shape);
    if (is_metal(form, shape)) said = {.lobe = 1, .f0 = said.diffuse};
  }
  return said;
}

double dielectric_index(double f0) {
  const double root = std::sqrt(std::min(f0, 0.99));
  return (1 + root) / (1 - root);
}

struct Copy {
  const Wanted& wanted;
  const ReflectanceInfo& target;
  const CopyRules& rules;
  std::vector<Said> said;

  // Returns true for a metal: the material has a lobe and no diffuse part.
  bool metal() const {
    return wanted.lobe >= 0 && std::ranges::all_of(said, [](const Said& s) { return s.diffuse == 0; });
  }
  double most_lobe() const { return std::min(std::ranges::max(said, {}, &Said::lobe).lobe, rules.most_lobe); }
  // Factor by which the reflectance along the normal grows because the lobe's weight is cut to most_lobe.
  double excess() const {
    const double lobe = std::ranges::max(said, {}, &Said::lobe).lobe;
    return rules.most_lobe < 1 && lobe > rules.most_lobe ? lobe / rules.most_lobe : 1;
  }
  double mean(double Said::*of) const {
    double sum = 0;
    for (const Said& s : said) sum += s.*of;
    return sum / double(said.size());
  }
  // Values for parameters that are shared by all colours. If indices of refraction differ, they have no mean
  // and are marked as not given.
  Said of_all() const {
    Said all = said.front();
    all.diffuse = mean(&Said::diffuse);
    all.lobe = mean(&Said::lobe);
    all.f0 = mean(&Said::f0);
    for (const Said& s : said)
      if (s.index != all.index || s.extinction != all.extinction) all.index = all.extinction = 0;
    return all;
  }
  // Reflectance along the normal in the target's Fresnel term, per colour if the target has coloured
  // indices.
  double f0_of(const Said& s) const {
    if (!rules.grey_lobe) return std::min((has_coloured_index() ? s.f0 : mean(&Said::f0)) * excess(), 1.0);
    return most_lobe() > 0 ? s.normal() / most_lobe() : s.f0;
  }
  // Returns true if the index of each colour carries the reflectance along the normal and the lobe's weight
  // carries no part of that reflectance.
  bool has_coloured_index() const {
    return std::ranges::find(rules.coloured, Role::index) != rules.coloured.end();
  }
  double lobe_of(const Said& s) const {
    if (rules.grey_lobe) return most_lobe();
    if (has_coloured_index()) return s.lobe / excess();
    const bool has_fresnel = target.shape_index(Role::index) >= 0;
    const double f0 = std::min(mean(&Said::f0) * excess(), 1.0);
    return !has_fresnel ? s.normal() : f0 > 0 ? s.normal() / f0 : s.lobe;
  }
  // Returns true if the target has a lobe weight in addition to its index, and if the reflectance is low
  // enough for a dielectric. A more reflecting lobe is expressed by the index alone.
  bool weighs_lobe() const {
    constexpr double kMostOfADielectric = 0.25;  // index 3
    return target.shape_index(Role::specular) >= 0 && mean(&Said::f0) <= kMostOfADielectric;
  }

  double weight(const ParameterInfo& p, const Said& s) const {
    const bool one_colour = target.weight_index(Role::specular) < 0;
    switch (p.role) {
      case Role::f0:
        return f0_of(s);
      case Role::specular:
        return lobe_of(s);
      case Role::diffuse:
        return one_colour && metal() ? s.normal() : s.diffuse;
      // No target has a weight with these roles yet.
      case Role::width:
      case Role::width_across:
      case Role::exponent:
      case Role::exponent_across:
      case Role::slope:
      case Role::index:
      case Role::extinction:
      case Role::tint:
      case Role::other:
        break;
    }
    return p.initial;
  }

  double shape(const ParameterInfo& p, const Said& s) const {
    const bool has_lobe = wanted.lobe >= 0, conductor = target.shape_index(Role::extinction) >= 0;
    const Widths widths = has_lobe ? widths_of(wanted.material.terms[std::size_t(wanted.lobe)]) : Widths();
    // Clamped below 1, as pbrt clamps "reflectance".
    const double f0 = std::min(f0_of(s), 0.9999);
    if (p.map == Map::metallic) return metal() ? 1 : 0;
    switch (p.role) {
      case Role::width:
        return widths.along;
      case Role::width_across:
        return widths.across;
      case Role::specular:
        return !has_lobe ? 0 : weighs_lobe() && !metal() ? mean(&Said::lobe) : 1;
      case Role::index:
        if (s.index > 0 || conductor) return s.index > 0 ? s.index : 1;
        return metal() ? p.initial : has_lobe ? dielectric_index(weighs_lobe() ? s.f0 : s.normal()) : 1;
      case Role::tint:
        return metal() || !has_lobe ? p.initial : tint(s);
      case Role::f0:
        return has_lobe || target.weight_index(Role::specular) >= 0 ? f0_of(s) : 0;
      case Role::slope:
        return s.slope;
      case Role::exponent:
        return 2 / (widths.along * widths.across) - 2;
      case Role::diffuse:
        return metal() ? s.normal() : s.diffuse;
      case Role::extinction:
        return s.index > 0 ? s.extinction : 2 * std::sqrt(f0 / (1 - f0));
      case Role::exponent_across:
      case Role::other:
        break;
    }
    return p.initial;
  }

  // Reflectance along the normal of this colour, divided by that of all colours.
  double tint(const Said& s) const {
    const double all = weighs_lobe() ? mean(&Said::lobe) * mean(&Said::f0) : of_all().normal();
    return all > 0 ? s.normal() / all : 1;
  }
};

double in_range(const ParameterInfo& p, double value) {
  return std::clamp(value, p.min, p.max);
}

// Returns true if the material has one term in the target's own form and the program's files can hold that
// term unchanged.
bool is_its_own(const Wanted& wanted, const Reflectance& target, const CopyRules& rules) {
  const std::vector<Term>& terms = wanted.material.terms;
  if (terms.size() != 1 || !(terms[0].form == target)) return false;
  const ReflectanceInfo& form = info(target);
  for (std::size_t k = 0; k < form.shape.size(); ++k)
    for (const std::vector<double>& shape : terms[0].shape)
      if (shape[k] != terms[0].shape[0][k] &&
          std::ranges::find(rules.coloured, form.shape[k].role) == rules.coloured.end())
        return false;
  const int lobe = form.weight_index(Role::specular);
  const auto fits = [&](const std::vector<double>& weights) {
    if (lobe < 0) return true;
    const double weight = weights[std::size_t(lobe)];
    if (rules.most_lobe < 1 && weight > rules.most_lobe) return false;
    return !rules.grey_lobe || (weight == terms[0].weights[0][std::size_t(lobe)] && weight <= 1);
  };
  return std::ranges::all_of(terms[0].weights, fits);
}

}  // namespace

int superfluous(const Term& of_target) {
  const ReflectanceInfo& form = info(of_target.form);
  const int tint = form.shape_index(Role::tint), index = form.shape_index(Role::index);
  if (tint < 0 || index < 0) return -1;
  return of_target.shape.size() > 1 && of_target.shape[0][std::size_t(index)] > 1 ? index : tint;
}

Material copied(const Wanted& wanted, const Reflectance& target, const CopyRules& rules) {
  if (is_its_own(wanted, target, rules)) return wanted.material;
  Material out = make_material(target, wanted.material.channels);
  const std::size_t channels = out.channels.size();
  Copy copy{wanted, info(target), rules, {}};
  for (std::size_t c = 0; c < channels; ++c) copy.said.push_back(said_of(wanted, c));
  Term& term = out.terms[0];
  if (!rules.coloured.empty() && channels > 1) term.shape.assign(channels, term.shape[0]);
  for (std::size_t c = 0; c < channels; ++c)
    for (std::size_t k = 0; k < copy.target.weights.size(); ++k) {
      const ParameterInfo& p = copy.target.weights[k];
      term.weights[c][k] = in_range(p, copy.weight(p, copy.said[c]));
    }
  for (std::size_t s = 0; s < term.shape.size(); ++s)
    for (std::size_t k = 0; k < copy.target.shape.size(); ++k) {
      const ParameterInfo& p = copy.target.shape[k];
      const bool by_colour = std::ranges::find(rules.coloured, p.role) != rules.coloured.end();
      term.shape[s][k] = in_range(p, copy.shape(p, by_colour ? copy.said[s] : copy.of_all()));
    }
  // A shape that is equal for all colours is stored once: a refit then has fewer parameters.
  if (std::ranges::adjacent_find(term.shape, std::not_equal_to<>()) == term.shape.end()) term.shape.resize(1);
  return out;
}

}  // namespace brdf::interop
