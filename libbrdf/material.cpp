#include "brdf/material.h"

#include <cmath>

namespace brdf {
namespace {

std::vector<double> defaults(std::span<const ParameterInfo> table) {
  std::vector<double> values;
  for (const ParameterInfo& p : table) values.push_back(p.initial);
  return values;
}

// Adds the term's value to `out`; `evaluate` is brdf::eval or brdf::eval_cos on typed parameters.
template <class Evaluate>
void add_term(const Term& term, const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> out,
              Evaluate evaluate) {
  const double c = std::cos(term.tangent_phi), s = std::sin(term.tangent_phi);
  const Geometry<double> g =
      term.tangent_phi == 0 ? geometry(wi, wo) : geometry(turn(wi, c, s), turn(wo, c, s));
  std::visit(
      [&](auto form) {
        const auto first = typed_weights(form, term, 0);
        for (std::size_t k = 0; k < out.size(); ++k)
          out[k] += evaluate(form, typed_weights(form, term, k), first, typed_shape(form, term, k), g);
      },
      term.form);
}

}  // namespace

bool operator==(const Term& a, const Term& b) {
  return a.form.index() == b.form.index() && a.shape == b.shape && a.weights == b.weights &&
         a.tangent_phi == b.tangent_phi;
}

Term make_term(const AnyForm& form, std::size_t channels) {
  const FormInfo& f = info(form);
  return {form, {defaults(f.shape)}, std::vector(channels, defaults(f.weights))};
}

Material make_material(const AnyForm& form, std::vector<std::string> channels) {
  const std::size_t n = channels.size();
  return {std::move(channels), {make_term(form, n)}};
}

void eval(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> out) {
  std::fill(out.begin(), out.end(), 0.0);
  for (const Term& term : material.terms)
    add_term(term, wi, wo, out,
             [](auto form, const auto& w, const auto& first, const auto& shape, const auto& g) {
               return eval(form, w, first, shape, g);
             });
}

void eval_cos(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo,
              std::span<double> out) {
  std::fill(out.begin(), out.end(), 0.0);
  for (const Term& term : material.terms)
    add_term(term, wi, wo, out,
             [](auto form, const auto& w, const auto& first, const auto& shape, const auto& g) {
               return eval_cos(form, w, first, shape, g);
             });
}

Vec3<double> direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace brdf
