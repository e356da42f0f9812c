// Approximations of the directional albedo of GGX with Smith's correlated masking and Schlick's Fresnel
// term: E = f0 A + (1 - f0) B, with A the albedo at F = 1 and B the albedo at F = (1 - cos_d)^5. They are
// cheaper than integration.
#pragma once

#include <memory>
#include <vector>

#include "brdf/math.h"
#include "brdf/vec3.h"
#include "trade/measure/rows.h"

namespace brdf::trade {

// The rational quadratic fit of MaterialX's shading language library (mx_ggx_dir_albedo_analytic), clamped.
inline constexpr auto albedo_materialx = []<class T>(const CosineRow<T>& row) -> T {
  const T x = row.cosine, y = row.width, x2 = x * x, y2 = y * y;
  const auto polynomial = [&](double c, double cx, double cy, double cxy, double cx2, double cy2, double cx2y,
                              double cxy2, double cx2y2) {
    return T(c) + T(cx) * x + T(cy) * y + T(cxy) * x * y + T(cx2) * x2 + T(cy2) * y2 + T(cx2y) * x2 * y +
           T(cxy2) * x * y2 + T(cx2y2) * x2 * y2;
  };
  const auto ratio = [](const T& a, const T& b) { return at_most(at_least(a / b, T(0)), T(1)); };
  const T a = ratio(polynomial(0.1003, -0.6303, 9.748, -2.038, 29.34, -8.245, -26.44, 19.99, -5.448),
                    polynomial(1.0, -1.765, 8.263, 11.53, 28.96, -7.507, -36.11, 15.86, 33.37));
  const T b = ratio(polynomial(0.9345, -2.323, 2.229, -3.748, 1.424, -0.7684, 1.436, 0.2913, 0.6286),
                    polynomial(1.0, 0.2281, 15.94, -55.83, 13.08, 41.26, 54.9, 300.2, -285.1));
  return row.f0 * a + b;
};

// Karis 2014 (physically based shading on mobile): fitted to a table for masking with k = alpha/2.
inline constexpr auto albedo_karis = []<class T>(const CosineRow<T>& row) -> T {
  const T r = math::sqrt(row.width);
  const T rx = T(1) - r, ry = T(0.0425) - T(0.0275) * r, rz = T(1.04) - T(0.572) * r,
          rw = T(0.022) * r - T(0.04);
  const T fall = math::exp(T(-9.28 * 0.69314718055994531) * row.cosine);
  const T a004 = smaller(rx * rx, fall) * rx + ry;
  return row.f0 * (rz - T(1.04) * a004) + (rw + T(1.04) * a004);
};

// A and B tabulated over (cos, roughness = sqrt(alpha)), with nodes at both ends of each axis, bilinear.
struct albedo_table {
  int size = 0;
  std::shared_ptr<const std::vector<double>> a, b;
  template <class T>
  T operator()(const CosineRow<T>& row) const {
    const T last(size - 1);
    const T x = at_most(at_least(row.cosine * last, T(0)), last);
    const T y = at_most(math::sqrt(row.width) * last, last);
    const int i0 = int(x), j0 = int(y);
    const int i = i0 < size - 1 ? i0 : size - 2, j = j0 < size - 1 ? j0 : size - 2;
    const T u = x - T(i), v = y - T(j);
    const auto at = [&](const std::vector<double>& t) {
      const auto n = std::size_t(j * size + i), m = n + std::size_t(size);
      const T low = T(t[n]) + u * (T(t[n + 1]) - T(t[n])), high = T(t[m]) + u * (T(t[m + 1]) - T(t[m]));
      return low + v * (high - low);
    };
    return row.f0 * at(*a) + (T(1) - row.f0) * at(*b);
  }
};

namespace detail {

template <class T>
T g2_over_g1(const T& alpha, const T& cos_i, const T& cos_o) {
  const auto length = [&](const T& c) { return math::sqrt(square(alpha) * (T(1) - c) * (T(1) + c) + c * c); };
  const T i = length(cos_i), o = length(cos_o);
  return cos_i * (cos_o + o) / (cos_o * i + cos_i * o);
}

}  // namespace detail

// MaterialX's Monte Carlo reference: visible normals at the points of a spherical Fibonacci set.
// Heitz 2018: the visible normal of the stretched view, from a disk warped along its projection. The weight
// of a sample is F G2/G1.
struct albedo_visible_normals {
  int samples;
  template <class T>
  T operator()(const CosineRow<T>& row) const {
    const T cos_o = at_least(row.cosine, T(1e-4)), alpha = row.width;
    const T sin_o = math::sqrt((T(1) - cos_o) * (T(1) + cos_o));
    const T scale = T(1) / math::sqrt(square(alpha * sin_o) + square(cos_o));
    const T vx = alpha * sin_o * scale, vz = cos_o * scale;
    T sum(0);
    for (int k = 0; k < samples; ++k) {
      const T u = (T(k) + T(0.5)) / T(samples);
      const T turns = T(k) * T(0.61803398874989485);
      const T phi = T(2 * kPi) * (turns - T(int(turns)));
      const T r = math::sqrt(u);
      const T t1 = r * std::cos(phi);
      const T s = T(0.5) * (T(1) + vz);
      const T t2 = (T(1) - s) * math::sqrt(at_least(T(1) - t1 * t1, T(0))) + s * r * std::sin(phi);
      const T t3 = math::sqrt(at_least(T(1) - t1 * t1 - t2 * t2, T(0)));
      // Basis of the stretched view: y, (-vz, 0, vx), v.
      Vec3<T> h{alpha * (t3 * vx - t2 * vz), alpha * t1, at_least(t3 * vz + t2 * vx, T(0))};
      h = h * (T(1) / math::sqrt(dot(h, h)));
      const T cos_d = at_least(sin_o * h.x + cos_o * h.z, T(1e-6));
      const T cos_i = T(2) * cos_d * h.z - cos_o;
      const T u1 = at_least(T(1) - cos_d, T(0));
      const T f = row.f0 + (T(1) - row.f0) * square(square(u1)) * u1;
      sum =
          sum + select(cos_i < T(1e-6), T(0), f * detail::g2_over_g1(alpha, at_least(cos_i, T(1e-6)), cos_o));
    }
    return sum / T(samples);
  }
};

// Karis 2013: half vectors drawn from D at Hammersley points, as for an environment lookup table, but with
// Smith's correlated masking instead of Karis's fit.
struct albedo_half_vectors {
  int samples;
  template <class T>
  T operator()(const CosineRow<T>& row) const {
    const T cos_o = at_least(row.cosine, T(1e-4)), alpha2 = square(row.width);
    const T sin_o = math::sqrt((T(1) - cos_o) * (T(1) + cos_o));
    T sum(0);
    for (int k = 0; k < samples; ++k) {
      unsigned bits = unsigned(k), reversed = 0;
      for (int b = 0; b < 32; ++b, bits >>= 1) reversed = (reversed << 1) | (bits & 1u);
      const T phi = T(2 * kPi) * (T(k) / T(samples)), v = T(reversed) * T(1.0 / 4294967296.0);
      const T cos_h2 = (T(1) - v) / (T(1) + (alpha2 - T(1)) * v);
      const T cos_h = math::sqrt(cos_h2), sin_h = math::sqrt(at_least(T(1) - cos_h2, T(0)));
      const T cos_d = at_least(sin_o * sin_h * std::cos(phi) + cos_o * cos_h, T(0));
      const T cos_i = T(2) * cos_d * cos_h - cos_o;
      const T u = at_least(T(1) - cos_d, T(0));
      const T f = row.f0 + (T(1) - row.f0) * square(square(u)) * u;
      const T ci = at_least(cos_i, T(1e-6));
      const auto length = [&](const T& c) { return math::sqrt(alpha2 * (T(1) - c) * (T(1) + c) + c * c); };
      const T visibility = T(0.5) / (cos_o * length(ci) + ci * length(cos_o));
      // f cos / pdf, with pdf = D cos_h/(4 cos_d).
      const T weight = T(4) * visibility * ci * cos_d / cos_h;
      sum = sum + select(cos_i < T(1e-6), T(0), f * weight);
    }
    return sum / T(samples);
  }
};

}  // namespace brdf::trade
