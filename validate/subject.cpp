#include "validate/subject.h"

#include <algorithm>
#include <cmath>

#include "io/text.h"

namespace brdf::validate {

double parameter_value(const ParameterInfo& p, double x, double max) {
  if (x <= 0) return p.min;
  if (x >= 1) return max;
  if (!p.log_scale) return p.min + (max - p.min) * x;
  if (p.min > 0) return p.min * std::pow(max / p.min, x);
  return std::expm1(x * std::log1p(max));  // from 0, logarithmic beyond 1
}

Subject Subject::form(const Reflectance& form) {
  Subject s;
  const ReflectanceInfo& f = info(form);
  s.name_ = f.name;
  s.form_ = form;
  s.material_ = make_material(form, {"fr"});
  s.shape_dimensions_ = f.shape.size();
  s.weight_dimensions_ = f.weights.size();
  s.anisotropic_ = f.anisotropic();
  return s;
}

Subject Subject::material(std::string name, Material material) {
  Subject s;
  s.name_ = std::move(name);
  for (const Term& term : material.terms) {
    const ReflectanceInfo& f = info(term.form);
    if (!f.anisotropic()) continue;
    for (const auto& shape : term.shape)
      s.anisotropic_ |=
          shape[std::size_t(f.shape_index("alpha_x"))] != shape[std::size_t(f.shape_index("alpha_y"))];
  }
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
  for (std::size_t j = 0; j < f.weights.size(); ++j)
    term.weights[0][j] = parameter_value(f.weights[j], point[k++], std::min(f.weights[j].max, 1.0));
  const int kd = f.weight_index("kd"), ks = f.weight_index("ks");
  if (kd >= 0 && ks >= 0) {  // the square's coordinates are the sum and the specular share of it
    auto& w = term.weights[0];
    const double sum = w[std::size_t(kd)], share = w[std::size_t(ks)];
    w[std::size_t(kd)] = sum * (1 - share);
    w[std::size_t(ks)] = sum * share;
  }
  return m;
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
  if (!form_) return "--material " + name_;
  std::string words = "--form " + name_;
  for (const auto& [name, value] : parameters(at)) words += " --set " + name + "=" + io::to_text(value);
  return words;
}

}  // namespace brdf::validate
