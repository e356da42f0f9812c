#include "brdf/material.h"

#include <algorithm>
#include <cmath>

#include "brdf/geometry.h"

namespace brdf {
namespace {

std::vector<double> defaults(std::span<const ParameterInfo> table) {
  std::vector<double> values;
  for (const ParameterInfo& p : table) values.push_back(p.initial);
  return values;
}

template <class T>
void turn_all(const Directions<T>& directions, Angle phi, DirectionArrays<T>& out) {
  const T c = T(std::cos(phi.radians())), s = T(std::sin(phi.radians()));
  for (std::size_t i = 0; i < directions.count; ++i)
    out.set(i, turn(directions.wi(i), c, s), turn(directions.wo(i), c, s));
}

// Calls evaluate(values, directions, out) on blocks that fit into the cache. The directions are rotated
// into the tangent frame of the term if the term has a tangent_phi.
template <class T, class Evaluate>
void eval_term(Angle tangent_phi, const ParameterValues<T>& values, const Directions<T>& directions, T* out,
               Evaluate&& evaluate) {
  if (tangent_phi == Angle{}) return evaluate(values, directions, out);
  constexpr std::size_t kBlock = 512;
  DirectionArrays<T> turned(std::min(kBlock, directions.count));
  for (std::size_t first = 0; first < directions.count; first += kBlock) {
    const Directions<T> block = directions.part(first, std::min(kBlock, directions.count - first));
    turn_all(block, tangent_phi, turned);
    evaluate(values, turned.view().part(0, block.count), out + first);
  }
}

// The parameters of a channel, rounded to float.
class FloatValues {
 public:
  explicit FloatValues(const ParameterValues<double>& p)
      : weights_(p.weights.begin(), p.weights.end()),
        first_(p.first.begin(), p.first.end()),
        shape_(p.shape.begin(), p.shape.end()),
        channel_(p.channel) {}
  ParameterValues<float> view() const { return {weights_, first_, shape_, channel_}; }

 private:
  std::vector<float> weights_, first_, shape_;
  std::size_t channel_;
};

// Adds the value of every term for one pair to `out`.
template <class Evaluate>
void sum_terms(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo,
               std::span<double> out, Evaluate&& evaluate) {
  std::ranges::fill(out, 0.0);
  for (const Term& term : material.terms)
    for (std::size_t k = 0; k < out.size(); ++k) {
      double value = 0;
      evaluate(term, k, one_pair(wi, wo), &value);
      out[k] += value;
    }
}

}  // namespace

Term make_term(const Reflectance& form, std::size_t channels) {
  const ReflectanceInfo& f = info(form);
  return {form, {defaults(f.shape)}, std::vector(channels, defaults(f.weights))};
}

Material make_material(const Reflectance& form, std::vector<std::string> channels) {
  const std::size_t n = channels.size();
  return {std::move(channels), {make_term(form, n)}};
}

bool is_anisotropic(const Material& material) {
  return std::ranges::any_of(material.terms, [](const Term& term) {
    const auto axes = info(term.form).axes();
    return axes.across >= 0 && std::ranges::any_of(term.shape, [&](const auto& set) {
             return set[std::size_t(axes.along)] != set[std::size_t(axes.across)];
           });
  });
}

void eval(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> out) {
  sum_terms(material, wi, wo, out,
            [](const Term& t, std::size_t c, const auto& d, double* value) { eval_batch(t, c, d, value); });
}
void eval_cos(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo,
              std::span<double> out) {
  sum_terms(material, wi, wo, out, [](const Term& t, std::size_t c, const auto& d, double* value) {
    eval_cos_batch(t, c, d, value);
  });
}

void eval_batch(const Term& term, std::size_t channel, const Directions<double>& directions, double* out) {
  eval_term(term.tangent_phi, term.values(channel), directions, out,
            [&](const auto&... arguments) { term.form->eval(arguments...); });
}
void eval_cos_batch(const Term& term, std::size_t channel, const Directions<double>& directions,
                    double* out) {
  eval_term(term.tangent_phi, term.values(channel), directions, out,
            [&](const auto&... arguments) { term.form->eval_cos(arguments...); });
}
void eval_batch(const Term& term, std::size_t channel, const Directions<float>& directions, float* out) {
  const FloatValues values(term.values(channel));
  eval_term(term.tangent_phi, values.view(), directions, out,
            [&](const auto&... arguments) { term.form->eval(arguments...); });
}
void eval_cos_batch(const Term& term, std::size_t channel, const Directions<float>& directions, float* out) {
  const FloatValues values(term.values(channel));
  eval_term(term.tangent_phi, values.view(), directions, out,
            [&](const auto&... arguments) { term.form->eval_cos(arguments...); });
}

Vec3<double> direction(Angle theta, Angle phi) {
  const double t = theta.radians(), p = phi.radians();
  return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

void turn_batch(const Directions<double>& directions, Angle phi, DirectionArrays<double>& out) {
  turn_all(directions, phi, out);
}

}  // namespace brdf
