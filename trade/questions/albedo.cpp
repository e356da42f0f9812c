#include "trade/approximations/albedo.h"
#include "brdf/forms.h"

#include <cmath>

#include "brdf/integrals.h"
#include "trade/questions/questions.h"

namespace brdf::trade {
namespace {

// A and B of albedo.h by quadrature.
struct AlbedoPair {
  double a, b;
};
AlbedoPair integrated(double cosine, double alpha, const AlbedoOptions& options) {
  const double shape[] = {std::max(alpha, 1e-4), std::max(alpha, 1e-4)};
  const double theta = std::acos(std::min(1.0, std::max(cosine, 1e-6)));
  const auto lobes = lobe_albedos(cook_torrance{}, shape, radians(theta), {}, options);
  return {lobes[1].value, lobes[2].value};
}
Kernel exact_albedo(double tolerance) {
  AlbedoOptions options;
  options.tolerance = tolerance;
  return scalar_kernel([options](const CosineRow<double>& x) {
    const AlbedoPair e = integrated(x.cosine, x.width, options);
    return x.f0 * e.a + (1 - x.f0) * e.b;
  });
}

albedo_table make_table(int size) {
  auto a = std::make_shared<std::vector<double>>(), b = std::make_shared<std::vector<double>>();
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i) {
      const double roughness = double(j) / (size - 1);
      const AlbedoPair e = integrated(double(i) / (size - 1), roughness * roughness, {});
      a->push_back(e.a);
      b->push_back(e.b);
    }
  return {size, a, b};
}

// The ball under uniform light: L = E(cos_o). The measure multiplies by cos_i, which has no meaning here and
// is divided out.
template <class K>
struct under_uniform_light {
  K albedo;
  double f0;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    return albedo(CosineRow<T>{x.wo.z, T(0.3), T(f0)}) / at_least(x.wi.z, T(1e-3));
  }
};
template <class K>
Choice albedo_choice(std::string name, const K& k, std::string note, double f0) {
  return {std::move(name), kernel(k), std::move(note), untimed_kernel(under_uniform_light<K>{k, f0})};
}
Choice integral_choice(double f0) {
  return {"integrated to 1e-6", exact_albedo(1e-6), "pole-adapted quadrature with error control",
          scalar_kernel([f0](const DirectionRow<double>& x) {
            const AlbedoPair e = integrated(x.wo.z, 0.3, {});
            return (f0 * e.a + (1 - f0) * e.b) / std::max(x.wi.z, 1e-3);
          })};
}
// Adds the approximations that do not use a table of this library.
void add_published(Question& q, double f0) {
  q.choices.push_back(
      albedo_choice("64 visible normals", albedo_visible_normals{64}, "MaterialX's Monte Carlo", f0));
  q.choices.push_back(
      albedo_choice("1024 half vectors", albedo_half_vectors{1024}, "as environment tables are made", f0));
  q.choices.push_back(
      albedo_choice("rational fit", albedo_materialx, "MaterialX's shading language library", f0));
  q.choices.push_back(
      albedo_choice("exponential fit", albedo_karis, "Karis 2014; made for k = alpha/2 masking", f0));
}

Question albedo_question() {
  const auto domain = [](double least_cos, double most_cos, double least_alpha, double most_alpha) {
    return make_domain({{"cos", least_cos, most_cos}, {"alpha", least_alpha, most_alpha, true}, {"f0", 0, 1}},
                       [](std::span<const double> at) {
                         return CosineRow<double>{at[0], at[1], at[2]};
                       });
  };
  Question q{"albedo of GGX",
             "directional albedo",
             Measure::absolute,
             domain(0.05, 1, 0.01, 1),
             {domain(0.05, 1, 1e-4, 1e-4), domain(0.001, 0.05, 0.01, 1)},
             {}};
  q.unit = Unit::albedo;
  q.points = 2048;
  q.timed_points = 64;
  q.pixels = 1024;
  q.choices = {integral_choice(0.04)};
  add_published(q, 0.04);
  for (int size : {16, 32, 64})
    q.choices.push_back(albedo_choice("table " + std::to_string(size) + "^2", make_table(size),
                                      "bilinear in cos and sqrt(alpha)", 0.04));
  q.reference = exact_albedo(1e-8);
  return q;
}

// Answers the same question at the nodes of a published grid, the 32 x 32 table of a production path tracer
// with F = 1.
Question table_nodes_question() {
  const auto nodes = [](double cosines, double widths) {
    return make_domain(
        {{"31 cos", 0, cosines}, {"31 roughness", 0, widths}},
        [](std::span<const double> at) {
          const double cosine = std::floor(at[0]) / 31, roughness = std::floor(at[1]) / 31;
          const CosineRow<double> row{cosine, std::max(roughness * roughness, 1e-4), 1};
          return at[0] < 32 && at[1] < 32 ? std::optional(row) : std::nullopt;
        },
        "whole numbers up to 31; f0 1");
  };
  Question q{"albedo of GGX at a table's nodes",
             "directional albedo, F = 1",
             Measure::absolute,
             nodes(32, 32),
             {nodes(2, 32), nodes(32, 3)},
             {}};
  q.unit = Unit::albedo;
  q.points = 4096;  // enough points to reach every node
  q.timed_points = 64;
  q.pixels = 1024;
  q.choices = {integral_choice(1)};
  add_published(q, 1);
  return q;
}

}  // namespace

std::vector<Question> albedo_questions() {
  return {albedo_question(), table_nodes_question()};
}

}  // namespace brdf::trade
