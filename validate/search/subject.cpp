#include "validate/search/subject.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/shell.h"
#include "io/files/text.h"
#include "validate/search/jump_search.h"

namespace brdf::validate {

ParameterInfo within_unit(ParameterInfo weight) {
  weight.min = std::max(weight.min, -1.0);
  weight.max = std::min(weight.max, 1.0);
  return weight;
}

double parameter_value(const ParameterInfo& p, double x, double max) {
  if (x <= 0) return p.min;
  if (x >= 1) return max;
  // Each whole number has an equal share of the unit interval.
  if (p.whole) return std::min(p.min + std::floor((max - p.min + 1) * x), max);
  if (!p.log_scale) return p.min + (max - p.min) * x;
  if (p.min > 0) return p.min * std::pow(max / p.min, x);
  return std::expm1(x * std::log1p(max));  // from 0; logarithmic beyond 1
}

std::string tied_name(const ReflectanceInfo& form) {
  const std::string_view common = form.tied_name();
  return std::string(common.empty() ? form.shape[std::size_t(form.axes().along)].name : common);
}

Subject Subject::form(const Reflectance& form) {
  Subject s;
  const ReflectanceInfo& f = info(form);
  s.name_ = f.name;
  s.form_ = form;
  s.material_ = make_material(form, f.channels.empty() ? std::vector<std::string>{"fr"}
                                                       : std::vector(f.channels.begin(), f.channels.end()));
  s.shape_dimensions_ = f.shape.size();
  s.weight_dimensions_ = f.weights.size();
  s.anisotropic_ = f.anisotropic();
  for (const Role role : {Role::diffuse, Role::specular})
    for (std::size_t k = 0; k < f.weights.size(); ++k)
      if (f.weights[k].role == role) s.shared_.push_back(k);
  return s;
}

Subject Subject::outside(std::string name, const Material& material, OutsideFacts facts) {
  Subject s = form(material.terms.front().form);
  s.name_ = std::move(name);
  s.anisotropic_ = s.anisotropic_ || facts.oriented || facts.may_turn;
  s.outside_ = std::move(facts);
  return s;
}

Subject Subject::material(std::string name, Material material, std::optional<OutsideFacts> facts) {
  Subject s;
  s.name_ = std::move(name);
  s.anisotropic_ = is_anisotropic(material) || (facts && facts->oriented);
  s.outside_ = std::move(facts);
  s.material_ = std::move(material);
  return s;
}

std::span<const Violation> Subject::declared() const {
  return form_ ? info(*form_).violations : std::span<const Violation>{};
}

Material Subject::at(std::span<const double> point) const {
  if (!form_) return material_;
  Material m = material_;
  const ReflectanceInfo& f = info(*form_);
  Term& term = m.terms.front();
  std::size_t k = 0;
  for (std::size_t j = 0; j < f.shape.size(); ++j)
    term.shape[0][j] = parameter_value(f.shape[j], point[k++], f.shape[j].max);
  for (std::size_t j = 0; j < f.weights.size(); ++j) {
    const ParameterInfo weight = within_unit(f.weights[j]);
    term.weights[0][j] = parameter_value(weight, point[k++], weight.max);
  }
  // The first coordinate is the sum of the weights that share the light. Each further coordinate is the
  // fraction that the preceding weight leaves to the remaining weights.
  auto& w = term.weights[0];
  double left = 1;
  for (std::size_t n = 0; n + 1 < shared_.size(); ++n) {
    double &one = w[shared_[n]], rest = w[shared_[n + 1]];
    left = n == 0 ? one : left;
    one = left * (1 - rest);
    left *= rest;
  }
  if (shared_.size() > 1) w[shared_.back()] = left;
  std::fill(term.weights.begin() + 1, term.weights.end(), w);
  return restricted(std::move(m));
}

Material Subject::restricted(Material at) const {
  if (!condition_) return at;
  const auto holds = [&](const Material& m) {
    const auto named = parameters(m);
    // Exactly, because a search ends at the edge: no witness may lie beyond it.
    const auto of_name = [&](std::string_view name) {
      return std::ranges::find_if(named, [&](const auto& p) { return p.first == name; })->second;
    };
    return condition_->holds(of_name, 0);
  };
  if (holds(at)) return at;
  const ReflectanceInfo& f = info(*form_);
  const std::vector<std::string>& names = condition_->names();
  const auto named = [&](const ParameterInfo& p) { return std::ranges::find(names, p.name) != names.end(); };
  // The material with the named parameters at this share of the way from their minima.
  const auto part = [&](double share) {
    Material m = at;
    Term& term = m.terms.front();
    const auto move = [&](std::span<const ParameterInfo> table, std::vector<double>& values) {
      for (std::size_t k = 0; k < table.size(); ++k)
        if (named(table[k])) {
          const double moved = share * (values[k] - table[k].min);
          values[k] = table[k].min + (table[k].whole ? std::floor(moved) : moved);
        }
    };
    for (auto& set : term.shape) move(f.shape, set);
    for (auto& set : term.weights) move(f.weights, set);
    return m;
  };
  double low = 0, high = 1;
  for (int step = 0; step < 50; ++step) {
    const double middle = (low + high) / 2;
    (holds(part(middle)) ? low : high) = middle;
  }
  return part(low);
}

void Subject::restrict_to(const io::Condition& condition) {
  const auto known = parameters(material_);
  for (const std::string& name : condition.names())
    if (std::ranges::none_of(known, [&](const auto& p) { return p.first == name; }))
      throw InputError("--such-that: " + name + " is not a parameter of " + name_);
  condition_ = condition;
  Material least = material_;
  const ReflectanceInfo& f = info(*form_);
  for (std::size_t k = 0; k < f.shape.size(); ++k) least.terms.front().shape[0][k] = f.shape[k].min;
  for (std::size_t k = 0; k < f.weights.size(); ++k) least.terms.front().weights[0][k] = f.weights[k].min;
  const auto values = parameters(least);
  if (!condition.holds([&](std::string_view name) {
        return std::ranges::find_if(values, [&](const auto& p) { return p.first == name; })->second;
      }))
    throw InputError(
        "--such-that: the condition must hold at the lower bounds of its parameters, as kd + ks <= 1 does; "
        "use --param NAME=MIN:MAX for the range of one parameter");
}

std::vector<std::pair<std::string, double>> Subject::parameters(const Material& at) const {
  std::vector<std::pair<std::string, double>> named;
  if (!form_) return named;
  const ReflectanceInfo& f = info(*form_);
  const Term& term = at.terms.front();
  for (std::size_t j = 0; j < f.weights.size(); ++j)
    named.emplace_back(f.weights[j].name, term.weights[0][j]);
  for (std::size_t j = 0; j < f.shape.size(); ++j) named.emplace_back(f.shape[j].name, term.shape[0][j]);
  return named;
}

std::string Subject::selector(const Material& at) const {
  if (!form_) return io::shell_file(name_);
  if (catalogue_index(*form_) < 0 && !outside_) return {};
  std::string words = outside_ ? outside_->words : "--form " + io::shell_word(name_);
  for (const auto& [name, value] : parameters(at))
    words += " --set " + io::shell_word(name) + "=" + io::to_text(value);
  return words;
}

const DirectionSampler* Subject::sampler() const {
  return outside_ ? outside_->sampler.get() : own_sampler_.get();
}

std::string Subject::explained(std::string_view check, const Material& at, const Vec3<double>& wi,
                               const Vec3<double>& wo) const {
  const std::string text = outside_ && outside_->explain ? outside_->explain(check, at, wi, wo) : "";
  return text.empty() ? "" : "; " + text;
}

std::string Subject::explained_jump(const Jump& jump) const {
  const std::string text =
      outside_ && outside_->explain_jump
          ? outside_->explain_jump(jump.at, jump.here.wi, jump.here.wo, jump.there.wi, jump.there.wo)
          : "";
  return text.empty() ? "" : "; " + text;
}

std::string Subject::command(const std::string& verb, const Material& at, const std::string& rest) const {
  const std::string words = selector(at);
  return words.empty() ? "" : "brdf " + verb + " " + words + " " + rest;
}

}  // namespace brdf::validate
