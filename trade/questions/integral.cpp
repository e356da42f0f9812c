#include <cmath>

#include "brdf/forms.h"
#include "brdf/integrals.h"
#include "brdf/low_discrepancy.h"
#include "brdf/quadrature.h"
#include "trade/approximations/albedo.h"
#include "trade/questions/names.h"
#include "trade/questions/picture.h"
#include "trade/questions/questions.h"

namespace brdf::trade {
namespace {

// F = 1.
Domain angles(double least, double most, double least_alpha, double most_alpha) {
  return make_domain(
      {{"theta", least, most}, {"alpha", least_alpha, most_alpha, true}},
      [](std::span<const double> at) {
        return AngleRow<double>{at[0], at[1]};
      },
      "f0 1");
}

// E at F = 1 for any masking: half vectors by the inverse of D's distribution, Gauss-Legendre in both
// numbers.
template <class V>
struct masked_albedo {
  V v;
  double operator()(const AngleRow<double>& x) const {
    const quadrature::GaussRule& rule = quadrature::gauss_legendre(64);
    const double alpha = x.alpha;
    const Vec3<double> wo = direction(degrees(x.theta), {});
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
        // f cos_i/pdf, with pdf = D cos_h/(4 cos_d).
        sum += rule.weight[m] * rule.weight[n] * (f.num / f.den) * wi.z * 4 * cos_d / cos_h;
      }
    }
    return sum;
  }
};

template <class V>
Choice masked_choice(std::string name, V v) {
  Choice choice{std::move(name), kernel(visibility<V>{v}), "", on_ball(v, schlick_fresnel)};
  choice.judged = scalar_kernel(masked_albedo<V>{v});
  return choice;
}

Question masked_question() {
  Question q{names::kMaskingByAlbedo,
             "directional albedo, F = 1",
             Measure::absolute,
             angles(0, 85, 0.05, 1),
             {angles(0, 85, 0.01, 0.01), angles(85, 89, 0.05, 1)},
             {}};
  q.choices = {masked_choice("Smith, correlated", smith_correlated),
               masked_choice("Smith, separable", smith_separable),
               masked_choice("Hammon", hammon_correlated),
               masked_choice("Schlick-GGX, k = alpha/2", schlick_ggx_half),
               masked_choice("Schlick-GGX, k = (roughness+1)^2/8", schlick_ggx_analytic),
               masked_choice("V-cavities", v_shaped_cavities),
               masked_choice(names::kMaskingDropped, masking_dropped)};
  q.points = 512;
  q.timed = directions({"alpha", 0.05, 1, true}, 85);
  return q;
}

// --- Integrators -------------------------------------------------------------------------------------------

using Integrator = std::function<double(const AngleRow<double>&)>;

Integrator by_rule(const AlbedoOptions& options) {
  return [options](const AngleRow<double>& x) {
    const double shape[] = {x.alpha, x.alpha};
    return lobe_albedos(cook_torrance{}, shape, degrees(x.theta), {}, options)[1].value;
  };
}

// Integrates the lobe times cosine over the points that `visit` generates (cosine, azimuth in radians,
// weight).
template <class Visit>
double integrate_lobe(const AngleRow<double>& x, Visit visit) {
  const Roughness<double> alpha{x.alpha, x.alpha};
  const Vec3<double> wo = direction(degrees(x.theta), {});
  double sum = 0;
  visit([&](double cosine, double phi, double weight) {
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const auto g = geometry(Vec3<double>{sine * std::cos(phi), sine * std::sin(phi), cosine}, wo);
    sum += weight * quotient(d_ggx(alpha, g), v_smith_ggx(alpha, g));
  });
  return sum;
}
// Cosine-distributed directions on the additive recurrence R2: a Monte Carlo estimate at its best.
Integrator cosine_samples(int count) {
  return [count](const AngleRow<double>& x) {
    return integrate_lobe(x, [&](auto add) {
      static constexpr auto kStep = additive_recurrence_steps<2>();
      for (std::uint64_t k = 1; k <= std::uint64_t(count); ++k) {
        const double u = additive_recurrence(0.5, kStep[0], k), v = additive_recurrence(0.5, kStep[1], k);
        add(std::sqrt(u), 2 * kPi * v, kPi / count);
      }
    });
  };
}
// The method of teaching code: equal steps in both angles.
Integrator midpoint(int steps) {
  return [steps](const AngleRow<double>& x) {
    return integrate_lobe(x, [&](auto add) {
      const double d = kPi / 2 / steps;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < 4 * steps; ++j) {
          const double theta = (i + 0.5) * d;
          add(std::cos(theta), (j + 0.5) * d, std::sin(theta) * std::cos(theta) * d * d);
        }
    });
  };
}
Integrator product_gauss(int order) {
  return [order](const AngleRow<double>& x) {
    const quadrature::GaussRule& rule = quadrature::gauss_legendre(order);
    return integrate_lobe(x, [&](auto add) {
      for (std::size_t m = 0; m < rule.node.size(); ++m)
        for (std::size_t n = 0; n < rule.node.size(); ++n)
          add(rule.node[m], kPi * rule.node[n], 2 * kPi * rule.weight[m] * rule.weight[n] * rule.node[m]);
    });
  };
}

Question integrator_question() {
  Question q{"integrating an albedo",
             "albedo of GGX, F = 1",
             Measure::relative,
             angles(0, 85, 0.05, 1),
             {angles(0, 85, 1e-3, 1e-3), angles(85, 89.9, 0.05, 1)},
             {}};
  q.unit = Unit::albedo;
  q.points = 256;
  q.timed_points = 16;
  q.pixels = 128;
  const auto add = [&](const std::string& name, const Integrator& integrate, const char* note) {
    // The ball under uniform light, alpha 0.3.
    const auto shown = [integrate](const DirectionRow<double>& x) {
      const Angle theta = radians(std::acos(std::min(1.0, x.wo.z)));
      return integrate({theta.degrees(), 0.3}) / std::max(x.wi.z, 1e-3);
    };
    q.choices.push_back({name, scalar_kernel(integrate), note, scalar_kernel(shown), Precision::double_});
  };
  const auto rule = [](Rule r, double tolerance, int order) {
    AlbedoOptions options;
    options.rule = r;
    options.tolerance = tolerance;
    options.order = order;
    return by_rule(options);
  };
  add("pole-adapted, to 1e-10", rule(Rule::pole, 1e-10, 0), "with error control");
  add("pole-adapted, to 1e-6", rule(Rule::pole, 1e-6, 0), "with error control");
  add("pole-adapted, to 1e-4", rule(Rule::pole, 1e-4, 0), "with error control");
  for (int order : {4, 6, 8, 12, 16, 24})
    add("pole-adapted, order " + std::to_string(order), rule(Rule::pole, 1e-6, order), "");
  add("slope, to 1e-6", rule(Rule::slope, 1e-6, 0), "with error control");
  for (int order : {8, 16, 32})
    add("slope, order " + std::to_string(order), rule(Rule::slope, 1e-6, order), "");
  add("adaptive, to 1e-4", rule(Rule::adaptive, 1e-4, 0), "bisection of cells");
  for (int order : {16, 32, 64})
    add("product Gauss, " + std::to_string(order) + "^2", product_gauss(order), "cosine and azimuth");
  for (int steps : {18, 45})
    add("midpoints, " + std::to_string(steps) + " x " + std::to_string(4 * steps), midpoint(steps),
        "equal steps in both angles");
  for (int count : {100, 1000, 10000})
    add(std::to_string(count) + " cosine samples", cosine_samples(count), "additive recurrence");
  for (int count : {64, 1024})
    add(
        std::to_string(count) + " visible normals",
        [count](const AngleRow<double>& x) {
          const double cosine = std::cos(degrees(x.theta).radians());
          return albedo_visible_normals{count}(CosineRow<double>{cosine, x.alpha, 1});
        },
        "Heitz 2018");
  q.reference = scalar_kernel(rule(Rule::pole, 1e-11, 0));
  return q;
}

}  // namespace

std::vector<Question> integral_questions() {
  return {masked_question(), integrator_question()};
}

}  // namespace brdf::trade
