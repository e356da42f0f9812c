// What a microfacet form's parts must obey by themselves. In the slopes (p, q) of the half vector the
// distribution of slopes P22 = D cos_h^4 integrates to 1, and the projected area that masking leaves visible,
// integral of G1 P22 (o.h)/cos_h over the facets that face the viewer, is the viewer's cosine (Heitz 2014 eq.
// 17): the weak white furnace. With an approximate G1 the deviation is G1's relative error.
#include <algorithm>
#include <cmath>

#include "brdf/forms.h"
#include "brdf/microfacet.h"
#include "integrals/gauss_legendre.h"
#include "io/text.h"
#include "validate/checks.h"
#include "validate/search.h"

namespace brdf::validate {
namespace {

constexpr double kBound = 1e-7;

using Widths = Roughness<double>;

// A pair whose half vector has the slopes of h, so that a form's own D can be asked for.
Geometry<double> with_half_vector(const Vec3<double>& h) {
  Geometry<double> g{};
  g.h = h;
  g.h2 = dot(h, h);
  return g;
}

struct Ggx {
  static double density(const Widths& a, const Vec3<double>& h) {
    const auto d = d_ggx(a, with_half_vector(h));
    return d.num / d.den;
  }
};
struct Beckmann {
  static double density(const Widths& a, const Vec3<double>& h) {
    const auto d = d_beckmann(a, with_half_vector(h));
    return d.num / d.den;
  }
};

// G1 of the viewer o for a facet of slopes h = (p, q, 1).
struct SmithGgx {
  static double g1(const Widths& a, const Vec3<double>& o, const Vec3<double>&) {
    return 2 * o.z / (o.z + stretched_length(a, o));
  }
};
struct SmithBeckmann {
  static double g1(const Widths& a, const Vec3<double>& o, const Vec3<double>&) {
    return o.z / (o.z + cos_lambda_beckmann(a, o));
  }
};
struct SchlickGgx {
  static double g1(const Widths& a, const Vec3<double>& o, const Vec3<double>&) {
    const double k = k_schlick_ggx(a);
    return o.z / (o.z * (1 - k) + k);
  }
};
struct VCavities {
  static double g1(const Widths&, const Vec3<double>& o, const Vec3<double>& h) {
    return std::min(1.0, 2 * o.z / dot(o, h));
  }
};

struct Parts {
  const char* form;
  double (*density)(const Widths&, const Vec3<double>&);
  double (*g1)(const Widths&, const Vec3<double>&, const Vec3<double>&);
  double far;  // in widths: beyond, the distribution holds nothing (GGX falls as the fourth power)
};

constexpr Parts kParts[] = {
    {"cook_torrance", Ggx::density, SmithGgx::g1, 1e9},
    {"cook_torrance_dielectric", Ggx::density, SmithGgx::g1, 1e9},
    {"cook_torrance_beckmann", Beckmann::density, SmithBeckmann::g1, 9},
    {"cook_torrance_vcavity", Beckmann::density, VCavities::g1, 9},
    {"cook_torrance_1982", Beckmann::density, VCavities::g1, 9},
    {"cook_torrance_schlick_ggx", Ggx::density, SchlickGgx::g1, 1e9},
    {"cook_torrance_as_printed", Ggx::density, SchlickGgx::g1, 1e9},
};

const Parts* parts_of(const Subject& subject) {
  if (!subject.of_form()) return nullptr;
  const auto* found = std::find_if(std::begin(kParts), std::end(kParts),
                                   [&](const Parts& p) { return subject.name() == p.form; });
  return found == std::end(kParts) ? nullptr : found;
}

struct Integrals {
  double normalisation, visible;  // the second over the viewer's cosine
  long evaluations;
};

// Over the slope s along the viewer's azimuth and t across it. At fixed s the ridge stands at t = -B s/C with
// the width sqrt((1 + (A - B^2/C) s^2)/C), where q = A s^2 + 2 B s t + C t^2 is the scaled tangent's square;
// then s has the width 1/sqrt(A - B^2/C).
Integrals integrate(const Parts& parts, const Widths& a, double theta, double phi) {
  constexpr int kPoints = 48;
  const auto& rule = integrals::gauss_legendre(kPoints);
  const double c = std::cos(phi), s0 = std::sin(phi), sin_o = std::sin(theta), cos_o = std::cos(theta);
  const Vec3<double> o{sin_o * c, sin_o * s0, cos_o};
  const double A = square(c / a.alpha_x) + square(s0 / a.alpha_y);
  const double B = c * s0 * (1 / square(a.alpha_y) - 1 / square(a.alpha_x));
  const double C = square(s0 / a.alpha_x) + square(c / a.alpha_y);
  const double along = A - B * B / C, width = 1 / std::sqrt(along);
  Integrals result{0, 0, 0};
  const auto row = [&](double s, double weight) {
    const double centre = -B * s / C, ridge = std::sqrt((1 + along * s * s) / C);
    for (const double sign : {-1.0, 1.0})
      integrals::graded_panel(rule, parts.far * ridge, ridge, false, [&](double d, double w) {
        const double t = centre + sign * d;
        const Vec3<double> h{s * c - t * s0, s * s0 + t * c, 1};
        const double slopes = parts.density(a, h) / square(dot(h, h)) * w * weight;  // D cos_h^4
        result.normalisation += slopes;
        const double facing = dot(o, h);
        if (facing > 0) result.visible += slopes * facing * parts.g1(a, o, h) / cos_o;
        ++result.evaluations;
      });
  };
  // Facets face the viewer above s = -cot(theta); V-cavities have their kink at s = +cot(theta).
  const double edge = sin_o > 0 ? cos_o / sin_o : parts.far;
  std::vector<double> ends{-parts.far * width, 0, parts.far * width};
  if (edge < parts.far * width) ends.insert(ends.end(), {-edge, edge});
  std::sort(ends.begin(), ends.end());
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double half = (ends[k + 1] - ends[k]) / 2;
    if (!(half > 0)) continue;
    const auto scale = [&](double at) { return std::hypot(width, at); };
    integrals::graded_panel(rule, half, scale(ends[k]), false,
                            [&](double d, double w) { row(ends[k] + d, w); });
    integrals::graded_panel(rule, half, scale(ends[k + 1]), false,
                            [&](double d, double w) { row(ends[k + 1] - d, w); });
  }
  return result;
}

struct Worst {
  double deviation = 0, angle = 0, phi = 0;
  Material at;
  long evaluations = 0;
};

Worst search(const Subject& subject, const Parts& parts, const CheckOptions& options,
             double (*deviation)(const Integrals&)) {
  const FormInfo& f = info(*subject.of_form());
  const std::size_t ix = std::size_t(f.shape_index("alpha_x")), iy = std::size_t(f.shape_index("alpha_y"));
  Worst worst;
  const auto widths_at = [&](std::span<const double> x) {
    return Widths{parameter_value(f.shape[ix], x[0], f.shape[ix].max),
                  parameter_value(f.shape[iy], x[1], f.shape[iy].max)};
  };
  const auto polar = [](double x) { return kPi / 2 - (kPi / 1800 + (kPi / 2 - kPi / 1800) * square(1 - x)); };
  SearchOptions settings;
  settings.cover = options.effort == Effort::full ? 200 : 50;
  settings.starts = options.effort == Effort::full ? 4 : 2;
  settings.steps = 25;
  settings.seed = options.seed;
  const Best best = maximise(
      [&](std::span<const double> x) {
        const Integrals r = integrate(parts, widths_at(x), polar(x[2]), kPi / 2 * x[3]);
        worst.evaluations += r.evaluations;
        return deviation(r);
      },
      4, settings, {{0, 0, 1, 0}, {1, 1, 1, 0}, {1, 1, 0, 0}, {0, 1, 1, 1}});
  worst.deviation = best.value;
  worst.angle = polar(best.point[2]) * 180 / kPi;
  worst.phi = 90 * best.point[3];
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
  w.angles = {{"theta", worst.angle}, {"phi", worst.phi}};
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
  const Worst worst =
      search(subject, *parts, options, [](const Integrals& r) { return std::abs(r.normalisation - 1); });
  return finding_of(subject, "normalisation", worst, "the facets' projected areas add up to the surface",
                    "the facets' projected areas do not add up to the surface");
}

Finding check_white_furnace(const Subject& subject, const CheckOptions& options) {
  const Parts* parts = parts_of(subject);
  if (!parts) return none(subject, "white_furnace");
  const Worst worst =
      search(subject, *parts, options, [](const Integrals& r) { return std::abs(r.visible - 1); });
  return finding_of(subject, "white_furnace", worst, "masking leaves exactly the projected area visible",
                    "masking is off by " + io::to_text(std::round(worst.deviation * 1e4) / 100) +
                        " % of the visible area (G1's relative error)");
}

}  // namespace brdf::validate
