// Conditions that the parts of a microfacet form must meet on their own. The half vector is described by
// its slopes (p, q). The slope distribution P22 = D cos_h^4 must integrate to 1. The projected area that
// masking leaves visible, the integral of G1 P22 (o.h)/cos_h over the facets that face the viewer, must
// equal the viewer's cosine (Heitz 2014 eq. 17): the weak white furnace test. With an approximate G1 the
// deviation is the relative error of G1.
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "brdf/quadrature.h"
#include "brdf/reflectance.h"
#include "io/files/shell.h"
#include "io/files/text.h"
#include "validate/form/checks.h"
#include "validate/search/degrees.h"
#include "validate/search/extremes.h"
#include "validate/search/search.h"

namespace brdf::validate {
namespace {

constexpr double kAreaBound = 1e-7;  // relative, of projected areas

struct Viewer {
  double theta = 0, phi = 0;
};

// Visits (h, weight) over the slope s along the viewer's azimuth and the slope t across it, with n points
// per panel. At fixed s the ridge lies at t = -B s/C and has the width sqrt((1 + (A - B^2/C) s^2)/C), with
// the scaled tangent's square q = A s^2 + 2 B s t + C t^2. Along s the width is then 1/sqrt(A - B^2/C).
template <class Visit>
void over_slopes(const LobeWidth& a, const Viewer& viewer, double far, int n, Visit&& visit) {
  const auto& rule = quadrature::gauss_legendre(n);
  const double c = std::cos(viewer.phi), s0 = std::sin(viewer.phi);
  const double A = square(c / a.x) + square(s0 / a.y);
  const double B = c * s0 * (1 / square(a.y) - 1 / square(a.x));
  const double C = square(s0 / a.x) + square(c / a.y);
  const double along = A - B * B / C, width = 1 / std::sqrt(along);
  std::vector<std::pair<double, double>> panel;  // distance, weight
  quadrature::graded_panel(rule, far, 1, false, [&](double d, double w) { panel.emplace_back(d, w); });
  const auto row = [&](double s, double weight) {
    const double centre = -B * s / C, ridge = std::sqrt((1 + along * s * s) / C);
    for (const double sign : {-ridge, ridge})
      for (const auto& [d, w] : panel) {
        const double t = centre + sign * d;
        visit(Vec3<double>{s * c - t * s0, s * s0 + t * c, 1}, w * ridge * weight);
      }
  };
  // Facets face the viewer above s = -cot(theta); V-cavities have their kink at s = +cot(theta).
  std::vector<double> ends{-far * width, 0, far * width};
  if (viewer.theta > 0)
    if (const double edge = 1 / std::tan(viewer.theta); edge < far * width)
      ends.insert(ends.end(), {-edge, edge});
  std::ranges::sort(ends);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double half = (ends[k + 1] - ends[k]) / 2;
    if (!(half > 0)) continue;
    const auto scale = [&](double at) { return std::hypot(width, at); };
    quadrature::graded_panel(rule, half, scale(ends[k]), false,
                             [&](double d, double w) { row(ends[k] + d, w); });
    quadrature::graded_panel(rule, half, scale(ends[k + 1]), false,
                             [&](double d, double w) { row(ends[k + 1] - d, w); });
  }
}

struct Integral {
  double value = 0;
  long evaluations = 0;
};

// The integral over the slopes divided by `whole`. The order is raised until two results agree to a
// hundredth of the bound, or until the last order. `weigh` multiplies a block of weights by the integrand
// at its slopes.
template <class Weigh>
Integral integrate(const FacetFacts& facets, const LobeWidth& a, const Viewer& viewer, double whole,
                   Weigh&& weigh) {
  constexpr std::size_t kBlock = 512;
  Integral result;
  std::vector<Vec3<double>> h(kBlock);
  std::vector<double> weights(kBlock);
  std::size_t used = 0;
  double previous = HUGE_VAL;
  for (const int n : {16, 24, 32, 48, 64, 96}) {
    double sum = 0;
    const auto flush = [&] {
      const std::span<double> weighed(weights.data(), used);
      weigh(std::span<const Vec3<double>>(h.data(), used), weighed);
      for (const double w : weighed) sum += w;
      result.evaluations += long(used);
      used = 0;
    };
    over_slopes(a, viewer, facets.far, n, [&](const Vec3<double>& slopes, double weight) {
      h[used] = slopes;
      weights[used] = weight;
      if (++used == kBlock) flush();
    });
    flush();
    result.value = sum / whole;
    if (std::abs(result.value - previous) < kAreaBound / 100) break;
    previous = result.value;
  }
  return result;
}

using Shape = std::vector<double>;

Integral normalisation_of(const ReflectanceInfo& form, const Shape& shape, const Viewer& viewer) {
  std::vector<double> density;
  return integrate(*form.facets, lobe_width(form, shape), viewer, 1,
                   [&](std::span<const Vec3<double>> h, std::span<double> weights) {
                     density.resize(h.size());
                     form.facets->slopes(shape, h.size(), h.data(), density.data());
                     for (std::size_t k = 0; k < h.size(); ++k) weights[k] *= density[k];
                   });
}

// The visible area divided by the viewer's cosine.
Integral visible_of(const ReflectanceInfo& form, const Shape& shape, const Viewer& viewer) {
  const Vec3<double> o = direction(radians(viewer.theta), radians(viewer.phi));
  std::vector<double> density, g1;
  return integrate(*form.facets, lobe_width(form, shape), viewer, o.z,
                   [&](std::span<const Vec3<double>> h, std::span<double> weights) {
                     density.resize(h.size());
                     g1.resize(h.size());
                     form.facets->slopes(shape, h.size(), h.data(), density.data());
                     form.facets->masking(shape, o, h.size(), h.data(), g1.data());
                     for (std::size_t k = 0; k < h.size(); ++k) {
                       const double facing = dot(o, h[k]);
                       weights[k] = facing > 0 ? weights[k] * density[k] * facing * g1[k] : 0;
                     }
                   });
}

using Quantity = Integral (*)(const ReflectanceInfo&, const Shape&, const Viewer&);

// The largest deviation from 1 over the widths and, if the quantity depends on the viewer, over viewers.
Finding search(const Subject& subject, const char* check, Quantity quantity, bool over_viewers,
               const CheckOptions& options) {
  if (!subject.of_form() || !info(*subject.of_form()).facets)
    return not_applicable(subject.name(), check, "the form has no distribution of microfacets");
  const ReflectanceInfo& form = info(*subject.of_form());
  std::vector<std::size_t> widths;
  for (const Role role : {Role::width, Role::width_across})
    if (const int k = form.shape_index(role); k >= 0) widths.push_back(std::size_t(k));
  const auto shape_at = [&](std::span<const double> x) {
    Shape shape = subject.own().terms.front().shape.front();
    for (std::size_t n = 0; n < widths.size(); ++n) {
      const ParameterInfo& p = form.shape[widths[n]];
      shape[widths[n]] = parameter_value(p, x[n], p.max);
    }
    return shape;
  };
  const auto viewer_at = [&](std::span<const double> x) {
    if (!over_viewers) return Viewer{};
    constexpr double kLowest = kPi / 1800;
    return Viewer{kPi / 2 - (kLowest + (kPi / 2 - kLowest) * square(1 - x[x.size() - 2])),
                  kPi / 2 * x.back()};
  };
  const bool full = options.effort == Effort::full;
  SearchOptions settings;
  settings.cover = full ? 200 : 50;
  settings.starts = full ? 4 : 2;
  settings.steps = 25;
  settings.finest = 1e-5;
  settings.seed = options.seed;
  settings.budget = options.budget;
  std::vector<std::vector<double>> corners;
  for (const auto& [x, y, theta, phi] :
       std::initializer_list<std::array<double, 4>>{{0, 0, 1, 0}, {1, 1, 1, 0}, {1, 1, 0, 0}, {0, 1, 1, 1}}) {
    std::vector<double>& corner = corners.emplace_back(std::vector{x, y});
    corner.resize(widths.size());
    if (over_viewers) corner.insert(corner.end(), {theta, phi});
  }
  Finding f{subject.name(), check};
  const Best best = maximise(
      [&](std::span<const double> x) {
        const Integral r = quantity(form, shape_at(x), viewer_at(x));
        f.evaluations += r.evaluations;
        return std::isnan(r.value) ? HUGE_VAL : std::abs(r.value - 1);
      },
      corners.front().size(), settings, corners);
  f.value = best.value;
  f.bound = kAreaBound;
  const Shape shape = shape_at(best.point);
  Witness w;
  for (const std::size_t k : widths) w.parameters.emplace_back(form.shape[k].name, shape[k]);
  const Viewer viewer = viewer_at(best.point);
  w.angles = {{"theta", in_degrees(viewer.theta)}, {"phi", in_degrees(viewer.phi)}};
  if (catalogue_index(*subject.of_form()) >= 0)
    w.command = "brdf validate --form " + io::shell_word(subject.name()) + " --json";
  f.witness = w;
  return f;
}

}  // namespace

Finding check_normalisation(const Subject& subject, const CheckOptions& options) {
  Finding f = search(subject, "normalisation", normalisation_of, false, options);
  if (f.outcome != Outcome::not_applicable)
    f.conclude(!(f.value > kAreaBound),
               "the projected areas of the microfacets add up to the area of the surface",
               "the projected areas of the microfacets do not add up to the area of the surface");
  return f;
}

Finding check_white_furnace(const Subject& subject, const CheckOptions& options) {
  Finding f = search(subject, "white_furnace", visible_of, true, options);
  if (f.outcome != Outcome::not_applicable)
    f.conclude(!(f.value > kAreaBound), "the visible microfacets have exactly the projected area",
               "the visible area differs from the projected area by " +
                   io::to_text(std::round(f.value * 1e4) / 100) + " % (relative error of the masking G1)");
  return f;
}

}  // namespace brdf::validate
