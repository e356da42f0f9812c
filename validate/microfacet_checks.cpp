// What a microfacet form's parts must obey by themselves. In the slopes (p, q) of the half vector the
// distribution of slopes P22 = D cos_h^4 integrates to 1, and the projected area that masking leaves visible,
// integral of G1 P22 (o.h)/cos_h over the facets that face the viewer, is the viewer's cosine (Heitz 2014 eq.
// 17): the weak white furnace. With an approximate G1 the deviation is G1's relative error.
#include <algorithm>
#include <cmath>

#include "brdf/microfacet.h"
#include "brdf/quadrature.h"
#include "brdf/reflectance.h"
#include "io/text.h"
#include "validate/checks.h"
#include "validate/search.h"

namespace brdf::validate {
namespace {

constexpr double kBound = 1e-7;

using Widths = Roughness<double>;

// D cos_h^4, the density of the slopes of h = (p, q, 1), by a form's own D.
template <auto kD>
struct Slopes {
  Widths a;
  double operator()(const Vec3<double>& h) const {
    Geometry<double> g{};
    g.h = h;
    g.h2 = dot(h, h);
    const auto d = kD(a, g);
    return d.num / (d.den * square(g.h2));
  }
};
struct Ggx : Slopes<d_ggx<double, double>> {
  static constexpr double far = 1e9;  // in widths: beyond, the distribution holds nothing
};
struct Beckmann : Slopes<d_beckmann<double, double>> {
  static constexpr double far = 9;
};

// Masking G1 of the viewer o for a facet of slopes h. All but V-cavities' depend on the viewer alone.
struct PerViewer {
  double value;
  double operator()(const Vec3<double>&) const { return value; }
};
struct SmithGgx : PerViewer {
  SmithGgx(const Widths& a, const Vec3<double>& o) : PerViewer{2 * o.z / (o.z + stretched_length(a, o))} {}
};
struct SmithBeckmann : PerViewer {
  SmithBeckmann(const Widths& a, const Vec3<double>& o)
      : PerViewer{o.z / (o.z + cos_lambda_beckmann(a, o))} {}
};
struct SchlickGgx : PerViewer {
  SchlickGgx(const Widths& a, const Vec3<double>& o) : PerViewer{of(k_schlick_ggx(a), o.z)} {}
  static double of(double k, double z) { return z / (z * (1 - k) + k); }
};
struct VCavities {
  Vec3<double> o;
  VCavities(const Widths&, const Vec3<double>& viewer) : o(viewer) {}
  double operator()(const Vec3<double>& h) const { return std::min(1.0, 2 * o.z / dot(o, h)); }
};

struct Viewer {
  double theta = 0, phi = 0;
};

// Visits (h, weight) over the slope s along the viewer's azimuth and t across it, n points a panel. At fixed
// s the ridge stands at t = -B s/C with the width sqrt((1 + (A - B^2/C) s^2)/C), where
// q = A s^2 + 2 B s t + C t^2 is the scaled tangent's square; then s has the width 1/sqrt(A - B^2/C).
template <class Visit>
void over_slopes(const Widths& a, const Viewer& viewer, double far, int n, Visit&& visit) {
  const auto& rule = quadrature::gauss_legendre(n);
  const double c = std::cos(viewer.phi), s0 = std::sin(viewer.phi);
  const double A = square(c / a.alpha_x) + square(s0 / a.alpha_y);
  const double B = c * s0 * (1 / square(a.alpha_y) - 1 / square(a.alpha_x));
  const double C = square(s0 / a.alpha_x) + square(c / a.alpha_y);
  const double along = A - B * B / C, width = 1 / std::sqrt(along);
  const auto row = [&](double s, double weight) {
    const double centre = -B * s / C, ridge = std::sqrt((1 + along * s * s) / C);
    for (const double sign : {-1.0, 1.0})
      quadrature::graded_panel(rule, far * ridge, ridge, false, [&](double d, double w) {
        const double t = centre + sign * d;
        visit(Vec3<double>{s * c - t * s0, s * s0 + t * c, 1}, w * weight);
      });
  };
  // Facets face the viewer above s = -cot(theta); V-cavities have their kink at s = +cot(theta).
  std::vector<double> ends{-far * width, 0, far * width};
  if (viewer.theta > 0)
    if (const double edge = 1 / std::tan(viewer.theta); edge < far * width)
      ends.insert(ends.end(), {-edge, edge});
  std::sort(ends.begin(), ends.end());
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

// Raises the order until two agree to a hundredth of the bound, or to the last.
template <class Sum>
Integral escalate(Sum&& sum) {
  Integral result;
  double previous = HUGE_VAL;
  for (const int n : {16, 24, 32, 48, 64, 96}) {
    result.value = sum(n, result.evaluations);
    if (std::abs(result.value - previous) < kBound / 100) break;
    previous = result.value;
  }
  return result;
}

template <class D>
Integral normalisation_of(const Widths& a, const Viewer& viewer) {
  const D density{a};
  return escalate([&](int n, long& evaluations) {
    double sum = 0;
    over_slopes(a, viewer, D::far, n, [&](const Vec3<double>& h, double weight) {
      sum += weight * density(h);
      ++evaluations;
    });
    return sum;
  });
}

// The visible area over the viewer's cosine.
template <class D, class G1>
Integral visible_of(const Widths& a, const Viewer& viewer) {
  const Vec3<double> o = direction(radians(viewer.theta), radians(viewer.phi));
  const D density{a};
  const G1 g1(a, o);
  return escalate([&](int n, long& evaluations) {
    double sum = 0;
    over_slopes(a, viewer, D::far, n, [&](const Vec3<double>& h, double weight) {
      ++evaluations;
      if (const double facing = dot(o, h); facing > 0) sum += weight * density(h) * facing * g1(h);
    });
    return sum / o.z;
  });
}

using Quantity = Integral (*)(const Widths&, const Viewer&);

struct Parts {
  const char* form;
  Quantity normalisation, visible;
};

template <class D, class G1>
constexpr Parts parts(const char* form) {
  return {form, normalisation_of<D>, visible_of<D, G1>};
}

constexpr Parts kParts[] = {
    parts<Ggx, SmithGgx>("cook_torrance"),
    parts<Ggx, SmithGgx>("cook_torrance_dielectric"),
    parts<Beckmann, SmithBeckmann>("cook_torrance_beckmann"),
    parts<Beckmann, VCavities>("cook_torrance_vcavity"),
    parts<Beckmann, VCavities>("cook_torrance_1982"),
    parts<Ggx, SchlickGgx>("cook_torrance_schlick_ggx"),
    parts<Ggx, SchlickGgx>("cook_torrance_as_printed"),
};

const Parts* parts_of(const Subject& subject) {
  if (!subject.of_form()) return nullptr;
  const auto* found = std::find_if(std::begin(kParts), std::end(kParts),
                                   [&](const Parts& p) { return subject.name() == p.form; });
  return found == std::end(kParts) ? nullptr : found;
}

struct Worst {
  double deviation = 0;
  Viewer viewer;
  Material at;
  long evaluations = 0;
};

// The largest deviation from 1, over the widths and (where the quantity depends on it) the viewer.
Worst search(const Subject& subject, Quantity quantity, bool over_viewers, const CheckOptions& options) {
  const ReflectanceInfo& f = info(*subject.of_form());
  const std::size_t ix = std::size_t(f.shape_index("alpha_x")), iy = std::size_t(f.shape_index("alpha_y"));
  Worst worst;
  const auto widths_at = [&](std::span<const double> x) {
    return Widths{parameter_value(f.shape[ix], x[0], f.shape[ix].max),
                  parameter_value(f.shape[iy], x[1], f.shape[iy].max)};
  };
  const auto viewer_at = [&](std::span<const double> x) {
    if (!over_viewers) return Viewer{};
    constexpr double kLowest = kPi / 1800;
    return Viewer{kPi / 2 - (kLowest + (kPi / 2 - kLowest) * square(1 - x[2])), kPi / 2 * x[3]};
  };
  SearchOptions settings;
  settings.cover = options.effort == Effort::full ? 200 : 50;
  settings.starts = options.effort == Effort::full ? 4 : 2;
  settings.steps = 25;
  settings.finest = 1e-5;
  settings.seed = options.seed;
  std::vector<std::vector<double>> corners{{0, 0, 1, 0}, {1, 1, 1, 0}, {1, 1, 0, 0}, {0, 1, 1, 1}};
  const std::size_t dimensions = over_viewers ? 4 : 2;
  for (auto& corner : corners) corner.resize(dimensions);
  const Best best = maximise(
      [&](std::span<const double> x) {
        const Integral r = quantity(widths_at(x), viewer_at(x));
        worst.evaluations += r.evaluations;
        return std::abs(r.value - 1);
      },
      dimensions, settings, corners);
  worst.deviation = best.value;
  worst.viewer = viewer_at(best.point);
  worst.at = subject.own();
  const Widths a = widths_at(best.point);
  worst.at.terms[0].shape[0][ix] = a.alpha_x;
  worst.at.terms[0].shape[0][iy] = a.alpha_y;
  return worst;
}

Finding finding_of(const Subject& subject, const char* check, const Worst& worst, const std::string& good,
                   const std::string& bad) {
  Finding f{subject.name(), check};
  f.value = worst.deviation;
  f.bound = kBound;
  f.verdict = worst.deviation > kBound ? Verdict::fail : Verdict::pass;
  f.evaluations = worst.evaluations;
  f.statement = f.verdict == Verdict::pass ? good : bad;
  Witness w;
  for (const auto& [name, value] : subject.parameters(worst.at))
    if (name == "alpha_x" || name == "alpha_y") w.parameters.emplace_back(name, value);
  w.angles = {{"theta", worst.viewer.theta * 180 / kPi}, {"phi", worst.viewer.phi * 180 / kPi}};
  w.command = "brdf validate --form " + subject.name() + " --json";
  f.witness = w;
  return f;
}

Finding none(const Subject& subject, const char* check) {
  Finding f{subject.name(), check};
  f.verdict = Verdict::not_applicable;
  f.statement = "no distribution of facets of its own";
  return f;
}

}  // namespace

Finding check_normalisation(const Subject& subject, const CheckOptions& options) {
  const Parts* parts = parts_of(subject);
  if (!parts) return none(subject, "normalisation");
  const Worst worst = search(subject, parts->normalisation, false, options);
  return finding_of(subject, "normalisation", worst, "the facets' projected areas add up to the surface",
                    "the facets' projected areas do not add up to the surface");
}

Finding check_white_furnace(const Subject& subject, const CheckOptions& options) {
  const Parts* parts = parts_of(subject);
  if (!parts) return none(subject, "white_furnace");
  const Worst worst = search(subject, parts->visible, true, options);
  return finding_of(subject, "white_furnace", worst, "masking leaves exactly the projected area visible",
                    "masking is off by " + io::to_text(std::round(worst.deviation * 1e4) / 100) +
                        " % of the visible area (G1's relative error)");
}

}  // namespace brdf::validate
