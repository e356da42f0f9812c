// Samplers of single lobes. A form names the sampler of its specular lobe: using Sampler = VisibleGgx, or
// OfWidths<VisibleGgx> if its shape has other parameters in addition to widths.
//
// A sampler has two static templates over the shape parameters S<T>:
//   Vec3<T> sample(const S<T>&, T u1, T u2, const Vec3<T>& wo)   a direction wi, u in [0, 1)
//   T pdf(const S<T>&, const Geometry<T>&)                       its density per solid angle of wi, 1/sr
// Directions are given in the local frame, with wo fixed and above the horizon. A sampled wi may lie below
// the horizon. T is float, double or the tracing scalar (brdf/trace.h), which writes the sampler as GLSL.
// The templates therefore use select() instead of `?:`, and name elementary functions without std::.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "brdf/cosine_lobe.h"
#include "brdf/microfacet.h"

namespace brdf {

template <class T>
Vec3<T> normalised(const Vec3<T>& v) {
  return v * (T(1) / math::sqrt(dot(v, v)));
}

// Returns the direction with this cosine to z and this azimuth.
template <class T>
Vec3<T> from_cosine(T cosine, T phi) {
  using std::cos, std::sin;
  const T sine = math::sqrt(at_least((T(1) - cosine) * (T(1) + cosine), T(0)));
  return {sine * cos(phi), sine * sin(phi), cosine};
}

template <class C, class T>
Vec3<T> chosen(const C& condition, const Vec3<T>& yes, const Vec3<T>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y), select(condition, yes.z, no.z)};
}

template <class T>
Vec3<T> mirrored(const Vec3<T>& w, const Vec3<T>& h) {
  return h * (T(2) * dot(w, h)) - w;
}

// Density: cos/pi.
template <class T>
Vec3<T> sample_cosine(T u1, T u2) {
  return from_cosine(math::sqrt(T(1) - u1), T(2 * kPi) * u2);
}

// Samples a direction about the mirror direction r of wo. Density: (n + 1)/(2 pi) (r.wi)^n.
template <class T>
Vec3<T> sample_phong(T n, T u1, T u2, const Vec3<T>& wo) {
  using std::pow;
  const Vec3<T> local = from_cosine(pow(T(1) - u1, T(1) / (n + T(1))), T(2 * kPi) * u2);
  const Vec3<T> r{-wo.x, -wo.y, wo.z};
  const Vec3<T> any =
      chosen(larger(r.z, -r.z) < T(0.9), Vec3<T>{T(0), T(0), T(1)}, Vec3<T>{T(1), T(0), T(0)});
  const Vec3<T> x = normalised(cross(any, r));
  return x * local.x + cross(r, x) * local.y + r * local.z;
}
template <class T>
T pdf_phong(T n, const Geometry<T>& g) {
  return (n + T(1)) * T(1 / (2 * kPi)) * mirror_cosine_power(n, g);
}

// Samples a half vector with density (n + 2)/(2 pi) cos_h^(n+1).
template <class T>
Vec3<T> sample_half_cosine(T n, T u1, T u2) {
  using std::pow;
  return from_cosine(pow(T(1) - u1, T(1) / (n + T(2))), T(2 * kPi) * u2);
}
template <class T>
T pdf_half_cosine(T n, const Geometry<T>& g) {
  const T cos_h = g.h.z / (T(2) * g.cos_d);
  return (n + T(2)) * T(1 / (2 * kPi)) * half_cosine_power(n, g) * cos_h / (T(4) * g.cos_d);
}

// Samples a half vector with Gaussian slopes (Walter 2005, "Notes on the Ward BRDF"). Density: D cos_h with
// Beckmann's D.
template <class T>
Vec3<T> sample_gaussian_slopes(const Roughness<T>& a, T u1, T u2) {
  using std::cos, std::sin, std::log;
  // A generator that rounds to float can return exactly 1.
  const T radius = math::sqrt(-log(at_least(T(1) - u1, T(1e-30))));
  const T phi = T(2 * kPi) * u2;
  return normalised(Vec3<T>{a.alpha_x * radius * cos(phi), a.alpha_y * radius * sin(phi), T(1)});
}
template <class T>
T pdf_gaussian_slopes(const Roughness<T>& a, const Geometry<T>& g) {
  const Fraction<T> d = d_beckmann(a, g);
  return d.num / d.den * g.h.z / (T(8) * square(g.cos_d));
}

// Samples the visible normals of GGX (Heitz 2018): a disc for the stretched view direction, projected back.
template <class T>
Vec3<T> sample_visible_ggx(const Roughness<T>& a, T u1, T u2, const Vec3<T>& wo) {
  using std::cos, std::sin;
  const Vec3<T> v = normalised(Vec3<T>{a.alpha_x * wo.x, a.alpha_y * wo.y, wo.z});
  const T length2 = square(v.x) + square(v.y);
  const Vec3<T> t1 = chosen(T(0) < length2, Vec3<T>{-v.y, v.x, T(0)} * (T(1) / math::sqrt(length2)),
                            Vec3<T>{T(1), T(0), T(0)});
  const Vec3<T> t2 = cross(v, t1);
  const T r = math::sqrt(u1), phi = T(2 * kPi) * u2;
  const T p1 = r * cos(phi);
  const T share = T(0.5) * (T(1) + v.z);
  const T p2 = (T(1) - share) * math::sqrt(at_least(T(1) - p1 * p1, T(0))) + share * r * sin(phi);
  const T p3 = math::sqrt(at_least(T(1) - p1 * p1 - p2 * p2, T(0)));
  const Vec3<T> h = t1 * p1 + t2 * p2 + v * p3;
  return normalised(Vec3<T>{a.alpha_x * h.x, a.alpha_y * h.y, at_least(h.z, T(1e-12))});
}
// Density of the mirrored direction: G1 D/(4 cos_o).
template <class T>
T pdf_visible_ggx(const Roughness<T>& a, const Geometry<T>& g) {
  const Fraction<T> d = d_ggx(a, g);
  return d.num / (d.den * (T(2) * (g.cos_o + stretched_length(a, g.wo))));
}

namespace detail {
// Returns the slope x below which a share u of the Gaussian slopes lies that are visible at this angle. The
// distribution is cos (1 + erf x)/2 + sin e^(-x^2)/(2 sqrt(pi)), normalised. The equation is solved by
// Newton's method inside a bracket, whose ends are steps like others: a step of 0 stays where it is. Plain
// numbers iterate until convergence, `most_steps` at most; the traced version has the 14 steps that float
// needs. The slope of the mass is 0 at the upper end; its lower bound keeps the step a number there.
template <class T>
T visible_gaussian_slope(T cosine, T sine, T u, int most_steps = std::is_floating_point_v<T> ? 40 : 14) {
  using std::exp, std::erfc;
  const auto mass = [&](T x) {
    return cosine * T(0.5) * erfc(-x) + sine * T(0.28209479177387814) * exp(-x * x);
  };
  T low = T(-6), high = select(cosine < T(6) * sine, cosine / sine, T(6));
  const T target = u * mass(high);
  T x = T(0.5) * (low + high);
  for (int k = 0; k < most_steps; ++k) {
    const T excess = mass(x) - target;
    const auto above = T(0) < excess;
    high = select(above, x, high);
    low = select(above, low, x);
    const T slope = at_least((cosine - x * sine) * T(0.56418958354775629) * exp(-x * x), T(1e-30));
    const T step = x - excess / slope, middle = T(0.5) * (low + high);
    const T next = select(step < low, middle, select(high < step, middle, step));
    if constexpr (std::is_floating_point_v<T>)
      if (std::abs(next - x) < T(4) * std::numeric_limits<T>::epsilon()) break;
    x = next;
  }
  return x;
}
}  // namespace detail

// Samples the visible normals of Beckmann slopes (Heitz and d'Eon 2014). The distribution of slopes is
// inverted numerically.
template <class T>
Vec3<T> sample_visible_beckmann(const Roughness<T>& a, T u1, T u2, const Vec3<T>& wo) {
  const Vec3<T> v = normalised(Vec3<T>{a.alpha_x * wo.x, a.alpha_y * wo.y, wo.z});
  const T sine = math::sqrt(square(v.x) + square(v.y));
  const T along = detail::visible_gaussian_slope(v.z, sine, u1);
  const T across = detail::visible_gaussian_slope(T(1), T(0), u2);
  const T c = select(T(0) < sine, v.x / sine, T(1)), s = select(T(0) < sine, v.y / sine, T(0));
  return normalised(
      Vec3<T>{-a.alpha_x * (c * along - s * across), -a.alpha_y * (s * along + c * across), T(1)});
}
template <class T>
T pdf_visible_beckmann(const Roughness<T>& a, const Geometry<T>& g) {
  const Fraction<T> d = d_beckmann(a, g);
  return d.num / (d.den * (T(4) * (g.cos_o + cos_lambda_beckmann(a, g.wo))));
}

// Samples about the mirror direction of wo, proportional to a power of the cosine to that direction.
struct MirrorCosine {
  template <class T>
  static Vec3<T> sample(const Exponent<T>& s, T u1, T u2, const Vec3<T>& wo) {
    return sample_phong(s.exponent, u1, u2, wo);
  }
  template <class T>
  static T pdf(const Exponent<T>& s, const Geometry<T>& g) {
    return pdf_phong(s.exponent, g);
  }
};

// Samples the half vector, proportional to a power of its cosine.
struct HalfCosine {
  template <class T>
  static Vec3<T> sample(const Exponent<T>& s, T u1, T u2, const Vec3<T>& wo) {
    return mirrored(wo, sample_half_cosine(s.exponent, u1, u2));
  }
  template <class T>
  static T pdf(const Exponent<T>& s, const Geometry<T>& g) {
    return pdf_half_cosine(s.exponent, g);
  }
};

// Samples the half vector with Gaussian slopes.
struct GaussianSlopes {
  template <class T>
  static Vec3<T> sample(const Roughness<T>& s, T u1, T u2, const Vec3<T>& wo) {
    return mirrored(wo, sample_gaussian_slopes(s, u1, u2));
  }
  template <class T>
  static T pdf(const Roughness<T>& s, const Geometry<T>& g) {
    return pdf_gaussian_slopes(s, g);
  }
};

// Samples the normals that are visible from wo.
struct VisibleGgx {
  template <class T>
  static Vec3<T> sample(const Roughness<T>& s, T u1, T u2, const Vec3<T>& wo) {
    return mirrored(wo, sample_visible_ggx(s, u1, u2, wo));
  }
  template <class T>
  static T pdf(const Roughness<T>& s, const Geometry<T>& g) {
    return pdf_visible_ggx(s, g);
  }
};
struct VisibleBeckmann {
  template <class T>
  static Vec3<T> sample(const Roughness<T>& s, T u1, T u2, const Vec3<T>& wo) {
    return mirrored(wo, sample_visible_beckmann(s, u1, u2, wo));
  }
  template <class T>
  static T pdf(const Roughness<T>& s, const Geometry<T>& g) {
    return pdf_visible_beckmann(s, g);
  }
};

// Samples the hemisphere uniformly, for any shape. For terms that do not decrease with cos_i.
struct Hemisphere {
  template <class S, class T>
  static Vec3<T> sample(const S&, T u1, T u2, const Vec3<T>&) {
    return from_cosine(u1, T(2 * kPi) * u2);
  }
  template <class S, class T>
  static T pdf(const S&, const Geometry<T>&) {
    return T(1 / (2 * kPi));
  }
};

// Adapts a sampler of widths to a shape that has other parameters too. The shape provides widths().
template <class Sampler>
struct OfWidths {
  template <class S, class T>
  static Vec3<T> sample(const S& s, T u1, T u2, const Vec3<T>& wo) {
    return Sampler::sample(s.widths(), u1, u2, wo);
  }
  template <class S, class T>
  static T pdf(const S& s, const Geometry<T>& g) {
    return Sampler::pdf(s.widths(), g);
  }
};

// Uses each of two samplers with probability 1/2. u1 selects the sampler; the rest of u1 is passed to the
// sampler.
template <class First, class Second>
struct OneOf {
  template <class S, class T>
  static Vec3<T> sample(const S& s, T u1, T u2, const Vec3<T>& wo) {
    const auto first = u1 < T(0.5);
    const T rest = T(2) * u1 - select(first, T(0), T(1));
    return chosen(first, First::sample(s, rest, u2, wo), Second::sample(s, rest, u2, wo));
  }
  template <class S, class T>
  static T pdf(const S& s, const Geometry<T>& g) {
    return T(0.5) * (First::pdf(s, g) + Second::pdf(s, g));
  }
};

}  // namespace brdf
