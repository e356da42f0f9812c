// The table of the lookup-texture article, and a better table, as kernels over directions.
//
// Both give the article's specular term f_r cos_i = F D' G/(pi cos_o), with D' = D/4 scaled as in the
// article, V-cavities and the exact dielectric Fresnel term.
#pragma once

#include <memory>
#include <vector>

#include "brdf/fresnel.h"
#include "brdf/microfacet.h"
#include "trade/approximations/masking.h"

namespace brdf::trade {

struct LookupMaterial {
  double eta = 1.5, alpha = 0.3;  // values of the article
};

struct lookup_exact {
  LookupMaterial material;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    const Geometry<T> g = geometry_of(x);
    const Roughness<T> alpha{T(material.alpha), T(material.alpha)};
    return quotient(d_beckmann(alpha, g), v_cavities(g)) * fresnel_dielectric(T(material.eta), g.cos_d) *
           g.cos_i;
  }
};

// F D' G/cos_i for H ~ N: wi.h ~ cos_i ~ cos_o, G ~ min(1, 2 n.h).
template <class T>
T collapsed(const LookupMaterial& m, const T& cos_h, const T& cos_i) {
  const T c2 = square(at_least(cos_h, T(1e-3)));
  const T alpha2(m.alpha * m.alpha);
  const T d = math::exp(-((T(1) - c2) / (c2 * alpha2))) / (T(4) * alpha2 * c2 * c2);
  const T light = at_least(cos_i, T(1e-3));
  return fresnel_dielectric(T(m.eta), light) * d * at_most(T(2) * cos_h, T(1)) / light;
}

// The formula that the texture holds, evaluated instead of looked up. Its error is due to the assumption H ~
// N alone.
template <bool clamped>  // to 1, like a texel
struct lookup_collapsed {
  LookupMaterial material;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    const Geometry<T> g = geometry_of(x);
    const T cos_h = g.h.z / (T(2) * g.cos_d);
    const T texel = collapsed(material, cos_h, g.cos_i);
    return T(1 / kPi) * (clamped ? at_most(texel, T(1)) : texel);
  }
};

// A square texture of one channel, with texels at ((i + 0.5)/size, (j + 0.5)/size) and clamped edges.
template <class Texel>
struct Texture {
  int size = 0;
  double scale = 1;  // value of the largest integer texel
  std::shared_ptr<const std::vector<Texel>> texels;

  template <class T>
  T at(int i, int j) const {
    const auto value = T((*texels)[std::size_t(j * size + i)]);
    if constexpr (std::is_integral_v<Texel>)
      return value * T(scale / double(Texel(-1)));
    else
      return value;
  }
  template <class T>
  T nearest(const T& u, const T& v) const {
    const int i = int(u * T(size)), j = int(v * T(size));
    return at<T>(i < size ? i : size - 1, j < size ? j : size - 1);
  }
  template <class T>
  T bilinear(const T& u, const T& v) const {
    const T last(size - 1);
    const T x = at_most(at_least(u * T(size) - T(0.5), T(0)), last);
    const T y = at_most(at_least(v * T(size) - T(0.5), T(0)), last);
    const int i = int(x), j = int(y);
    const int i1 = i + 1 < size ? i + 1 : i, j1 = j + 1 < size ? j + 1 : j;
    const T a = x - T(i), b = y - T(j);
    const T low = at<T>(i, j) + a * (at<T>(i1, j) - at<T>(i, j));
    const T high = at<T>(i, j1) + a * (at<T>(i1, j1) - at<T>(i, j1));
    return low + b * (high - low);
  }
};

// Stores value(u, v) at the centre of every texel. Integer texels represent the range [0, scale].
template <class Texel, class F>
Texture<Texel> bake(int size, double scale, F value) {
  auto texels = std::make_shared<std::vector<Texel>>();
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i) {
      const double x = value((i + 0.5) / size, (j + 0.5) / size);
      if constexpr (std::is_integral_v<Texel>)
        texels->push_back(Texel(at_most(at_least(x / scale, 0.0), 1.0) * double(Texel(-1)) + 0.5));
      else
        texels->push_back(Texel(x));
    }
  return {size, scale, std::move(texels)};
}

// The article's texture over (n.h, n.l), with texels clamped to 1.
template <class Texel, bool smooth>
struct lookup_article {
  Texture<Texel> texture;
  lookup_article(const LookupMaterial& m, int size)
      : texture(bake<Texel>(size, 1.0, [&](double cos_h, double cos_i) {
          return at_most(collapsed(m, cos_h, cos_i), 1.0);
        })) {}
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    const Geometry<T> g = geometry_of(x);
    const T u = g.h.z / (T(2) * g.cos_d), v = g.cos_i;
    return T(1 / kPi) * (smooth ? texture.bilinear(u, v) : texture.nearest(u, v));
  }
};

// The better parameterisation. One axis is t/(1 + t) with t = (tan(theta_h)/alpha)^2, which gives lobes of
// all widths the same share of texels; the other axis is wi.h. The texel is F D' alpha^2. G/cos_o is
// computed, hence no assumption about the directions is needed. The square root spreads dark values over the
// integers.
template <class Texel, bool smooth>
struct lookup_scaled {
  double inverse_alpha2;
  Texture<Texel> texture;
  lookup_scaled(const LookupMaterial& m, int size)
      : inverse_alpha2(1 / (m.alpha * m.alpha)), texture(bake<Texel>(size, 0.5, [&](double s, double cos_d) {
          const double t = s / (1 - s), tan2 = t * m.alpha * m.alpha;
          return std::sqrt(0.25 * std::exp(-t) * (1 + tan2) * (1 + tan2) * fresnel_dielectric(m.eta, cos_d));
        })) {}
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    const Geometry<T> g = geometry_of(x);
    const T t = (square(g.h.x) + square(g.h.y)) * T(inverse_alpha2);
    const T u = t / (square(g.h.z) + t);
    const T root = smooth ? texture.bilinear(u, g.cos_d) : texture.nearest(u, g.cos_d);
    const Fraction<T> v = v_cavities(g);
    return root * root * T(inverse_alpha2 * 4 / kPi) * g.cos_i * (v.num / v.den);
  }
};

}  // namespace brdf::trade
