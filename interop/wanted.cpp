#include "interop/wanted.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "io/colour/channel_colours.h"
#include "io/files/text.h"

namespace brdf::interop {
namespace {

struct Asked {
  const Limits& limits;
  [[noreturn]] void refuse(const std::string& reason) const {
    throw Refused("--to " + std::string(limits.program) + ": " + reason);
  }
};

// Returns true if the shapes of all channels agree, except for the diffuse colour and the Fresnel
// reflectance.
bool has_one_shape(const Term& term) {
  const ReflectanceInfo& form = info(term.form);
  for (std::size_t k = 0; k < form.shape.size(); ++k) {
    const Role role = form.shape[k].role;
    if (role == Role::diffuse || is_fresnel(role)) continue;
    for (const std::vector<double>& shape : term.shape)
      if (shape[k] != term.shape[0][k]) return false;
  }
  return true;
}

// Returns the material with channels in the order red, green, blue, or with its single channel.
Material in_order(const Material& given, const Asked& asked) {
  const std::string count =
      std::to_string(given.channels.size()) + " channels, but the program takes one colour or three";
  if (given.channels.size() != 1 && given.channels.size() != 3)
    asked.refuse(count + "; --to glsl converts a spectrum, tables carry every channel");
  if (given.channels.size() == 1 && io::channel_colours(given.channels)) return given;
  std::optional<Material> out = in_colours(given);
  if (!out) asked.refuse(count + ", and the names do not identify colours");
  return std::move(*out);
}

// Returns true for a target or for another program's model with a violation that a target has, too.
bool is_approximated(const Term& term, const Violation& violation, const Asked& asked) {
  return std::ranges::any_of(asked.limits.targets, [&](const Reflectance& target) {
    const auto same = [&](const Violation& v) { return v.check == violation.check; };
    return target == term.form ||
           (catalogue_index(term.form) < 0 && std::ranges::any_of(info(target).violations, same));
  });
}

void check_properties(const Term& term, const Asked& asked) {
  for (const char* property : {"reciprocity", "continuity"})
    for (const Violation& v : info(term.form).violations)
      if (v.check == property && !is_approximated(term, v, asked))
        asked.refuse(std::string(info(term.form).name) + " violates " + property + " (" +
                     std::string(v.statement) +
                     "): no formula of the program approximates this behaviour at grazing angles");
}

void check_term(Term& term, const Asked& asked) {
  const ReflectanceInfo& form = info(term.form);
  if (form.about_light)
    asked.refuse(
        std::string(form.name) +
        " is a lobe about the direction of the light, and no formula of the program has such a lobe");
  check_properties(term, asked);
  if (!has_one_shape(term))
    asked.refuse(std::string(form.name) +
                 " has widths per channel, but files of the program hold a single width for all colours");
  if (std::ranges::adjacent_find(term.shape, std::not_equal_to<>()) == term.shape.end()) term.shape.resize(1);
  for (std::size_t c = 0; c < term.weights.size(); ++c)
    for (std::size_t k = 0; k < form.weights.size(); ++k)
      if (const double w = term.weights[c][k],
          most = form.weights[k].role == Role::specular ? asked.limits.most_lobe : asked.limits.most;
          w > most)
        asked.refuse(std::string(form.weights[k].name) + " " + io::to_text(w) + " is above " +
                     io::to_text(most) + ", the limit at which the program clamps");
}

}  // namespace

std::optional<Material> in_colours(const Material& given) {
  const auto colours = io::channel_colours(given.channels);
  if (given.channels.size() != 3 || !colours) return std::nullopt;
  Material out = given;
  for (std::size_t t = 0; t < given.terms.size(); ++t)
    for (std::size_t colour = 0; colour < 3; ++colour) {
      out.terms[t].weights[colour] = given.terms[t].weights[colours->of[colour]];
      if (given.terms[t].shape.size() == 3)
        out.terms[t].shape[colour] = given.terms[t].shape[colours->of[colour]];
    }
  out.channels = {"r", "g", "b"};
  return out;
}

bool has_lobe(const Term& term) {
  const int specular = info(term.form).weight_index(Role::specular);
  if (specular < 0) return info(term.form).shape_index(Role::width) >= 0;  // targets with a single colour
  return std::ranges::any_of(term.weights,
                             [&](const std::vector<double>& w) { return w[std::size_t(specular)] != 0; });
}

Widths widths_of(const Term& term) {
  const ReflectanceInfo& form = info(term.form);
  const std::vector<double>& shape = term.shape[0];
  const auto at = [&](Role along, Role across, auto width) -> Widths {
    const int a = form.shape_index(along), b = form.shape_index(across);
    const double first = width(shape[std::size_t(a)]);
    return {first, b < 0 ? first : width(shape[std::size_t(b)])};
  };
  if (form.shape_index(Role::width) >= 0)
    return at(Role::width, Role::width_across, [](double alpha) { return alpha; });
  if (form.shape_index(Role::exponent) >= 0)
    return at(Role::exponent, Role::exponent_across,
              [](double n) { return std::clamp(std::sqrt(2 / (n + 2)), 1e-4, 1.0); });
  return {};
}

namespace {

// Rotates the frame so that the wider axis of the lobe lies along the tangent.
void turn_to_axis(Wanted& part) {
  for (Term& term : part.material.terms) {
    const auto [along, across] = info(term.form).axes();
    if (along < 0 || across < 0) continue;
    if (term.shape[0][std::size_t(along)] == term.shape[0][std::size_t(across)]) continue;
    const Widths widths = widths_of(term);
    part.tangent = part.given = term.tangent_phi;
    if (widths.along < widths.across) {
      for (std::vector<double>& shape : term.shape)
        std::swap(shape[std::size_t(along)], shape[std::size_t(across)]);
      part.tangent = radians(term.tangent_phi.radians() + kPi / 2);
    }
    term.tangent_phi = {};
  }
}

}  // namespace

std::vector<Wanted> wanted(const Material& given, const Limits& limits) {
  const Asked asked{limits};
  const Material all = in_order(given, asked);
  std::vector<Wanted> parts{{{all.channels, {}}}};
  for (Term term : all.terms) {
    check_term(term, asked);
    const bool lobe = has_lobe(term);
    if (!lobe || parts[0].lobe < 0) {
      if (lobe) parts[0].lobe = int(parts[0].material.terms.size());
      parts[0].material.terms.push_back(std::move(term));
      continue;
    }
    if (!limits.adds)
      asked.refuse(
          "files of the program have one lobe in addition to the diffuse part, but the material has the "
          "lobes of " +
          std::string(info(parts[0].material.terms[std::size_t(parts[0].lobe)].form).name) + " and " +
          std::string(info(term.form).name));
    parts.push_back({{all.channels, {std::move(term)}}, {}, {}, 0});
  }
  for (Wanted& part : parts) turn_to_axis(part);
  return parts;
}

Material sum_of(const std::vector<Wanted>& parts) {
  Material sum{parts.front().material.channels, {}};
  for (const Wanted& part : parts)
    for (Term term : part.material.terms) {
      term.tangent_phi = radians(term.tangent_phi.radians() + part.tangent.radians());
      sum.terms.push_back(std::move(term));
    }
  return sum;
}

std::vector<std::string> not_held(const Wanted& part, const Holds& target) {
  std::vector<std::string> out;
  if (part.lobe < 0) return out;
  const Term& term = part.material.terms[std::size_t(part.lobe)];
  const ReflectanceInfo& form = info(term.form);
  const auto differ = [](const auto& rows, std::size_t k) {
    return std::ranges::any_of(rows, [&](const std::vector<double>& row) { return row[k] != rows[0][k]; });
  };
  if (const int ks = form.weight_index(Role::specular);
      !target.coloured_lobe && ks >= 0 && differ(term.weights, std::size_t(ks)))
    out.push_back(std::string(form.weights[std::size_t(ks)].name) +
                  " has a colour, but the lobe of the program has one weight for all colours");
  for (std::size_t k = 0; k < form.shape.size() && !target.coloured_fresnel; ++k)
    if (is_fresnel(form.shape[k].role) && differ(term.shape, k))
      out.push_back(std::string(form.shape[k].name) +
                    " has a value for each colour, but the lobe of the program has one value for all");
  return out;
}

}  // namespace brdf::interop
