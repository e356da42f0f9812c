#include "interop/wanted.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "io/channel_colours.h"
#include "io/error.h"
#include "io/text.h"

namespace brdf::interop {
namespace {

struct Asked {
  const Limits& limits;
  [[noreturn]] void refuse(const std::string& reason) const {
    throw Refused("--to " + std::string(limits.program) + ": " + reason);
  }
};

// Whether the channels' shapes are the same, or differ in what the program takes for each.
bool has_one_shape(const Term& term, const Limits& limits) {
  const ReflectanceInfo& form = info(term.form);
  for (std::size_t k = 0; k < form.shape.size(); ++k) {
    const Role role = form.shape[k].role;
    if (role == Role::diffuse || (limits.fresnel_per_channel && is_fresnel(role))) continue;
    for (const std::vector<double>& shape : term.shape)
      if (shape[k] != term.shape[0][k]) return false;
  }
  return true;
}

// Red, green and blue, or the one channel.
Material in_order(const Material& given, const Asked& asked) {
  const std::string count =
      std::to_string(given.channels.size()) + " channels: it takes one or three colours";
  if (given.channels.size() != 1 && given.channels.size() != 3)
    asked.refuse(count + "; --to glsl adds a spectrum up, tables carry every channel");
  const auto colours = io::channel_colours(given.channels);
  if (!colours) asked.refuse(count + ", and no names say which they are");
  Material out = given;
  if (given.channels.size() == 1) return out;
  for (std::size_t t = 0; t < given.terms.size(); ++t)
    for (std::size_t colour = 0; colour < 3; ++colour) {
      out.terms[t].weights[colour] = given.terms[t].weights[colours->of[colour]];
      if (given.terms[t].shape.size() == 3)
        out.terms[t].shape[colour] = given.terms[t].shape[colours->of[colour]];
    }
  out.channels = {"r", "g", "b"};
  return out;
}

void check_properties(const Term& term, const Asked& asked) {
  const std::vector<Reflectance>& own = asked.limits.targets;
  if (std::find(own.begin(), own.end(), term.form) != own.end()) return;
  for (const char* property : {"reciprocity", "continuity"})
    for (const Violation& v : info(term.form).violations)
      if (v.check == property)
        asked.refuse(std::string(info(term.form).name) + " violates " + property + " (" +
                     std::string(v.statement) +
                     "): no formula of the program comes near it at grazing directions");
}

void check_term(Term& term, const Asked& asked) {
  const ReflectanceInfo& form = info(term.form);
  check_properties(term, asked);
  if (!has_one_shape(term, asked.limits))
    asked.refuse(std::string(form.name) + " has a shape per channel, the program one for all colours");
  if (std::adjacent_find(term.shape.begin(), term.shape.end(), std::not_equal_to<>()) == term.shape.end())
    term.shape.resize(1);
  for (std::size_t c = 0; c < term.weights.size(); ++c)
    for (std::size_t k = 0; k < form.weights.size(); ++k)
      if (const double w = term.weights[c][k],
          most = form.weights[k].role == Role::specular ? asked.limits.most_lobe : asked.limits.most;
          w > most)
        asked.refuse(std::string(form.weights[k].name) + " " + io::to_text(w) + " is above " +
                     io::to_text(most) + ", which the program clamps at");
}

}  // namespace

bool is_fresnel(Role role) {
  return role == Role::f0 || role == Role::index || role == Role::extinction;
}

bool has_lobe(const Term& term) {
  const int specular = info(term.form).weight_index(Role::specular);
  if (specular < 0) return info(term.form).anisotropic();  // targets of one colour
  return std::any_of(term.weights.begin(), term.weights.end(),
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

Wanted wanted(const Material& given, const Limits& limits) {
  const Asked asked{limits};
  Wanted out{in_order(given, asked), {}, -1};
  for (std::size_t t = 0; t < out.material.terms.size(); ++t) {
    Term& term = out.material.terms[t];
    check_term(term, asked);
    if (!has_lobe(term)) continue;
    if (out.lobe >= 0)
      asked.refuse("it has one lobe beside the diffuse part, the material has those of " +
                   std::string(info(out.material.terms[std::size_t(out.lobe)].form).name) + " and " +
                   std::string(info(term.form).name));
    out.lobe = int(t);
  }
  for (Term& term : out.material.terms) {
    const auto [along, across] = info(term.form).axes();
    if (along < 0 || across < 0) continue;
    if (term.shape[0][std::size_t(along)] == term.shape[0][std::size_t(across)]) continue;
    const Widths widths = widths_of(term);
    out.tangent = term.tangent_phi;
    if (widths.along < widths.across) {
      for (std::vector<double>& shape : term.shape)
        std::swap(shape[std::size_t(along)], shape[std::size_t(across)]);
      out.tangent = radians(term.tangent_phi.radians() + kPi / 2);
    }
    term.tangent_phi = {};
  }
  return out;
}

}  // namespace brdf::interop
