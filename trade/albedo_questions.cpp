#include "trade/approximations/albedo.h"

#include <cmath>

#include "brdf/integrals.h"
#include "integrals/gauss_legendre.h"
#include "trade/approximations/masking.h"
#include "trade/questions.h"

namespace brdf::trade {
namespace {

// A function of one point that is too dear, or too branched, for a vectorised loop.
Kernel scalar_kernel(std::function<double(const Row<double>&)> f) {
  const auto shared = std::make_shared<const std::function<double(const Row<double>&)>>(std::move(f));
  const auto run = [shared](const auto& in, auto out) {
    for (std::size_t k = 0; k < out.size(); ++k) {
      Row<double> row;
      for (std::size_t c = 0; c < kInputs; ++c) row[c] = double(in[c][k]);
      using T = std::remove_cvref_t<decltype(out[k])>;
      out[k] = T((*shared)(row));
    }
  };
  return {run, run};
}

// A and B of albedo.h by quadrature.
struct AlbedoPair {
  double a, b;
};
AlbedoPair integrated(double cosine, double alpha, const AlbedoOptions& options) {
  const double shape[] = {std::max(alpha, 1e-4), std::max(alpha, 1e-4)};
  const double theta = std::acos(std::min(1.0, std::max(cosine, 1e-6)));
  const auto lobes = lobe_albedos(cook_torrance{}, shape, theta, 0, options);
  return {lobes[1].value, lobes[2].value};
}
Kernel exact_albedo(double tolerance) {
  AlbedoOptions options;
  options.tolerance = tolerance;
  return scalar_kernel([options](const Row<double>& x) {
    const AlbedoPair e = integrated(x[0], x[1], options);
    return x[2] * e.a + (1 - x[2]) * e.b;
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

// The ball under uniform light: L = E(cos_o). The measure multiplies by cos_i, which stands for nothing here.
template <class K>
struct under_uniform_light {
  K albedo;
  template <class T>
  T operator()(const Row<T>& x) const {
    Row<T> row{x[5], T(0.3), T(0.04)};
    return albedo(row) / at_least(x[2], T(1e-3));
  }
};
template <class K>
Choice albedo_choice(std::string name, const K& k, std::string note) {
  return {std::move(name), kernel(k), std::move(note), kernel(under_uniform_light<K>{k})};
}

Question albedo_question() {
  const auto domain = [](double least_cos, double most_cos, double least_alpha, double most_alpha) {
    return Domain{
        {{"cos", least_cos, most_cos}, {"alpha", least_alpha, most_alpha, true}, {"f0", 0, 1}}, {}, ""};
  };
  Question q{"albedo of GGX",
             "directional albedo",
             Measure::absolute,
             domain(0.05, 1, 0.01, 1),
             {domain(0.05, 1, 1e-4, 1e-4), domain(0.001, 0.05, 0.01, 1)},
             {}};
  q.unit = Unit::albedo;
  q.points = 4096;
  q.timed_points = 64;
  const Kernel exact = exact_albedo(1e-6);
  Choice integral{"integrated to 1e-6", exact, "pole-adapted quadrature with error control"};
  integral.picture = scalar_kernel([](const Row<double>& x) {
    const AlbedoPair e = integrated(x[5], 0.3, {});
    return (0.04 * e.a + 0.96 * e.b) / std::max(x[2], 1e-3);
  });
  q.choices = {
      std::move(integral),
      albedo_choice("64 visible normals", albedo_visible_normals{64}, "MaterialX's Monte Carlo"),
      albedo_choice("1024 half vectors", albedo_half_vectors{1024}, "as environment tables are made"),
      albedo_choice("table 16^2", make_table(16), "bilinear in cos and sqrt(alpha)"),
      albedo_choice("table 32^2", make_table(32), "bilinear in cos and sqrt(alpha)"),
      albedo_choice("table 64^2", make_table(64), "bilinear in cos and sqrt(alpha)"),
      albedo_choice("rational fit", albedo_materialx{}, "MaterialX's shading language library"),
      albedo_choice("exponential fit", albedo_karis{}, "Karis 2014; made for k = alpha/2 masking")};
  q.reference = exact_albedo(1e-8);
  return q;
}

// The same against a published grid: the nodes of a production path tracer's 32 x 32 table, F = 1.
Question table_nodes_question() {
  Question q{"albedo of GGX at a table's nodes",
             "directional albedo, F = 1",
             Measure::absolute,
             {{{"31 cos", 0, 32}, {"31 roughness", 0, 32}}, {}, "whole numbers up to 31; f0 1"},
             {},
             {}};
  q.everyday.inputs = [](std::span<const double> at, Row<double>& row) {
    const double cosine = std::floor(at[0]) / 31, roughness = std::floor(at[1]) / 31;
    row = {cosine, std::max(roughness * roughness, 1e-4), 1};
    return at[0] < 32 && at[1] < 32;
  };
  q.unit = Unit::albedo;
  q.points = 4096;
  q.timed_points = 64;
  q.choices = {{"integrated to 1e-6", exact_albedo(1e-6), "pole-adapted quadrature with error control"},
               {"64 visible normals", kernel(albedo_visible_normals{64}), "MaterialX's Monte Carlo"},
               {"1024 half vectors", kernel(albedo_half_vectors{1024}), "as environment tables are made"},
               {"rational fit", kernel(albedo_materialx{}), "MaterialX's shading language library"},
               {"exponential fit", kernel(albedo_karis{}), "Karis 2014; made for k = alpha/2 masking"}};
  return q;
}

// E at F = 1 for any masking: half vectors by the inverse of D's distribution, Gauss-Legendre in both
// numbers.
template <class V>
struct masked_albedo {
  V v;
  double operator()(const Row<double>& x) const {
    const integrals::GaussRule& rule = integrals::gauss_legendre(64);
    const double theta = x[0] * kPi / 180, alpha = x[1];
    const Vec3<double> wo = direction(theta, 0);
    double sum = 0;
    for (std::size_t m = 0; m < rule.node.size(); ++m) {
      const double u = rule.node[m], cos_h2 = (1 - u) / (1 + (alpha * alpha - 1) * u);
      const double cos_h = std::sqrt(cos_h2), sin_h = std::sqrt(1 - cos_h2);
      for (std::size_t n = 0; n < rule.node.size(); ++n) {
        const double phi = kPi * rule.node[n];
        const Vec3<double> h{sin_h * std::cos(phi), sin_h * std::sin(phi), cos_h};
        const double cos_d = dot(wo, h);
        const Vec3<double> wi = h * (2 * cos_d) - wo;
        if (cos_d <= 0 || wi.z <= 0) continue;
        const Fraction<double> f = v(Roughness<double>{alpha, alpha}, geometry(wi, wo));
        // f cos_i/pdf, pdf = D cos_h/(4 cos_d)
        sum += rule.weight[m] * rule.weight[n] * (f.num / f.den) * wi.z * 4 * cos_d / cos_h;
      }
    }
    return sum;
  }
};

template <class V>
Choice masked_choice(std::string name, V v) {
  Choice choice{std::move(name), kernel(visibility<V>{v}), ""};
  choice.judged = scalar_kernel(masked_albedo<V>{v});
  return choice;
}

Question masked_question() {
  const auto domain = [](double least, double most, double least_alpha, double most_alpha) {
    return Domain{{{"theta", least, most}, {"alpha", least_alpha, most_alpha, true}}, {}, "f0 1"};
  };
  Question q{"masking for GGX, by the albedo it gives",
             "directional albedo, F = 1",
             Measure::absolute,
             domain(0, 85, 0.05, 1),
             {domain(0, 85, 0.01, 0.01), domain(85, 89, 0.05, 1)},
             {}};
  q.choices = {masked_choice("Smith, correlated", smith_correlated{}),
               masked_choice("Smith, separable", smith_separable{}),
               masked_choice("Hammon", hammon_correlated{}),
               masked_choice("Schlick-GGX, k = alpha/2", schlick_ggx_half{}),
               masked_choice("Schlick-GGX, k = (roughness+1)^2/8", schlick_ggx_analytic{}),
               masked_choice("V-cavities", v_shaped_cavities{}),
               masked_choice("G dropped", masking_dropped{})};
  q.points = 512;
  q.timed = direction_domain({"alpha", 0.05, 1, true}, {"-", 0, 0}, 85);
  return q;
}

// --- Integrators. Row: theta (degrees), alpha
// -------------------------------------------------------------------

Kernel by_rule(const AlbedoOptions& options) {
  return scalar_kernel([options](const Row<double>& x) {
    const double shape[] = {x[1], x[1]};
    return lobe_albedos(cook_torrance{}, shape, x[0] * kPi / 180, 0, options)[1].value;
  });
}

// Integral of the lobe times cosine at given points of the unit square.
template <class Visit>
double integrate_lobe(const Row<double>& x, Visit visit) {
  const Roughness<double> alpha{x[1], x[1]};
  const Vec3<double> wo = direction(x[0] * kPi / 180, 0);
  double sum = 0;
  visit([&](double cosine, double phi, double weight) {
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const auto g = geometry(Vec3<double>{sine * std::cos(phi), sine * std::sin(phi), cosine}, wo);
    sum += weight * quotient(d_ggx(alpha, g), v_smith_ggx(alpha, g));
  });
  return sum;
}
// Cosine-distributed directions on the additive recurrence R2: a Monte Carlo estimate at its best.
Kernel cosine_samples(int count) {
  return scalar_kernel([count](const Row<double>& x) {
    return integrate_lobe(x, [&](auto add) {
      for (int k = 1; k <= count; ++k) {
        const double u = std::fmod(0.5 + k * 0.7548776662466927, 1),
                     v = std::fmod(0.5 + k * 0.5698402909980532, 1);
        add(std::sqrt(u), 2 * kPi * v, kPi / count);
      }
    });
  });
}
// The teaching code's way: equal steps in both angles.
Kernel midpoint(int steps) {
  return scalar_kernel([steps](const Row<double>& x) {
    return integrate_lobe(x, [&](auto add) {
      const double d = kPi / 2 / steps;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < 4 * steps; ++j) {
          const double theta = (i + 0.5) * d;
          add(std::cos(theta), (j + 0.5) * d, std::sin(theta) * std::cos(theta) * d * d);
        }
    });
  });
}
Kernel product_gauss(int order) {
  return scalar_kernel([order](const Row<double>& x) {
    const integrals::GaussRule& rule = integrals::gauss_legendre(order);
    return integrate_lobe(x, [&](auto add) {
      for (std::size_t m = 0; m < rule.node.size(); ++m)
        for (std::size_t n = 0; n < rule.node.size(); ++n)
          add(rule.node[m], kPi * rule.node[n], 2 * kPi * rule.weight[m] * rule.weight[n] * rule.node[m]);
    });
  });
}

Question integrator_question() {
  const auto domain = [](double least, double most, double least_alpha, double most_alpha) {
    return Domain{{{"theta", least, most}, {"alpha", least_alpha, most_alpha, true}}, {}, ""};
  };
  Question q{"integrating an albedo",
             "albedo of GGX, F = 1",
             Measure::relative,
             domain(0, 85, 0.05, 1),
             {domain(0, 85, 1e-3, 1e-3), domain(85, 89.9, 0.05, 1)},
             {}};
  q.unit = Unit::albedo;
  q.points = 256;
  q.timed_points = 16;
  const auto rule = [](Rule r, double tolerance, int order) {
    AlbedoOptions options;
    options.rule = r;
    options.tolerance = tolerance;
    options.order = order;
    return by_rule(options);
  };
  q.choices.push_back({"pole-adapted, to 1e-10", rule(Rule::pole, 1e-10, 0), "with error control"});
  q.choices.push_back({"pole-adapted, to 1e-6", rule(Rule::pole, 1e-6, 0), "with error control"});
  q.choices.push_back({"pole-adapted, to 1e-4", rule(Rule::pole, 1e-4, 0), "with error control"});
  for (int order : {4, 6, 8, 12, 16, 24})
    q.choices.push_back({"pole-adapted, order " + std::to_string(order), rule(Rule::pole, 1e-6, order), ""});
  q.choices.push_back({"slope, to 1e-6", rule(Rule::slope, 1e-6, 0), "with error control"});
  for (int order : {8, 16, 32})
    q.choices.push_back({"slope, order " + std::to_string(order), rule(Rule::slope, 1e-6, order), ""});
  q.choices.push_back({"adaptive, to 1e-4", rule(Rule::adaptive, 1e-4, 0), "bisection of cells"});
  for (int order : {16, 32, 64})
    q.choices.push_back(
        {"product Gauss, " + std::to_string(order) + "^2", product_gauss(order), "cosine and azimuth"});
  for (int steps : {18, 45})
    q.choices.push_back({"midpoints, " + std::to_string(steps) + " x " + std::to_string(4 * steps),
                         midpoint(steps), "equal steps in both angles"});
  for (int count : {100, 1000, 10000})
    q.choices.push_back(
        {std::to_string(count) + " cosine samples", cosine_samples(count), "additive recurrence"});
  for (int count : {64, 1024})
    q.choices.push_back(
        {std::to_string(count) + " visible normals", scalar_kernel([count](const Row<double>& x) {
           return albedo_visible_normals{count}(Row<double>{std::cos(x[0] * kPi / 180), x[1], 1});
         }),
         "Heitz 2018"});
  for (Choice& choice : q.choices) choice.cost = Precision::double_;
  q.reference = rule(Rule::pole, 1e-11, 0);
  return q;
}

}  // namespace

std::vector<Question> albedo_questions() {
  return {albedo_question(), table_nodes_question(), masked_question(), integrator_question()};
}

}  // namespace brdf::trade
