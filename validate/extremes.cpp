#include "validate/extremes.h"

#include <cmath>
#include <limits>
#include <string>

#include "brdf/material.h"

namespace brdf::validate {
namespace {

constexpr double kDegree = kPi / 180;

std::vector<double> extreme_values(const ParameterInfo& p) {
  if (p.name == "exponent") return {0, 1, 5.3, 50, 1e6};
  if (p.name == "eta") return {1, 1.0001, 1.5, 5};
  if (p.name == "sigma") return {0, 0.1985, 0.9, kPi / 2};
  std::vector<double> values{p.min, p.initial};
  if (p.initial != p.max) values.push_back(p.max);
  return values;
}

// Pairs of widths instead of their product.
const std::vector<std::array<double, 2>> kAlphas{{1e-4, 1e-4}, {3e-3, 3e-3}, {0.1, 0.1}, {0.4, 0.4},
                                                 {1, 1},       {1e-4, 0.1},  {1, 1e-3}};

std::vector<std::vector<double>> extreme_shapes(std::span<const ParameterInfo> table) {
  std::vector<std::vector<double>> sets{{}};
  for (std::size_t k = 0; k < table.size(); ++k) {
    const bool widths = table[k].name == "alpha_x";
    std::vector<std::vector<double>> longer;
    for (const auto& set : sets) {
      const auto extend = [&](std::initializer_list<double> values) {
        longer.push_back(set);
        longer.back().insert(longer.back().end(), values);
      };
      if (widths)
        for (const auto& a : kAlphas) extend({a[0], a[1]});
      else
        for (double v : extreme_values(table[k])) extend({v});
    }
    sets = std::move(longer);
    if (widths) ++k;  // alpha_y went with alpha_x
  }
  return sets;
}

std::vector<std::vector<double>> extreme_weights(std::span<const ParameterInfo> table) {
  if (table.size() == 3) return {{0, 1, 1}, {0, 1, 0}, {0.5, 0.5, 0.04}};  // kd, ks, f0
  if (table.size() == 2) return {{0, 1}, {0.5, 0.5}};                      // kd, ks
  return {{1}, {0.01}};                                                    // rho or albedo
}

}  // namespace

ParameterGrid extreme_parameters(const Reflectance& form) {
  const ReflectanceInfo& f = info(form);
  return {extreme_weights(f.weights), extreme_shapes(f.shape)};
}

std::vector<Vec3<double>> extreme_lights() {
  std::vector<Vec3<double>> lights{{0, 0, 1}, direction(degrees(60), {})};
  for (double theta : {20.0, 60.0, 85.0, 89.9, 89.99})
    lights.push_back(direction(degrees(theta), radians(0.3)));
  lights.push_back({std::cos(0.3), std::sin(0.3), 0});
  return lights;
}

std::vector<Vec3<double>> extreme_views(const Vec3<double>& wi, double width_x, double width_y) {
  std::vector<Vec3<double>> views;
  const auto mirror_at_slope = [&](double x, double y) {
    const double length = std::sqrt(x * x + y * y + 1);
    const Vec3<double> h{x / length, y / length, 1 / length};
    const Vec3<double> wo = h * (2 * dot(wi, h)) - wi;
    if (wo.z >= 0) views.push_back(wo);
  };
  views.push_back({-wi.x, -wi.y, wi.z});
  for (double slope : {0.3, 1.0, 2.0, 3.5, 5.0, 7.5})
    for (double azimuth : {0.4, 1.9})
      mirror_at_slope(width_x * slope * std::cos(azimuth), width_y * slope * std::sin(azimuth));
  views.push_back({0, 0, 1});
  for (double theta : {45.0, 75.0, 89.9, 89.99, 90.0})
    for (double away : {0.35, 1.4, 2.0, kPi - 0.02}) {
      const Vec3<double> w = direction(degrees(theta), radians(0.3 + away));
      views.push_back({w.x, w.y, theta == 90 ? 0 : w.z});
    }
  views.push_back(wi);
  views.push_back({-wi.x, -wi.y, 0});
  return views;
}

LobeWidth lobe_width(const ReflectanceInfo& form, const std::vector<double>& shape) {
  if (const int x = form.shape_index("alpha_x"); x >= 0)
    return {shape[std::size_t(x)], shape[std::size_t(form.shape_index("alpha_y"))]};
  if (const int n = form.shape_index("exponent"); n >= 0) {
    const double width = std::sqrt(2 / (shape[std::size_t(n)] + 2));
    return {width, width};
  }
  return {0.3, 0.3};
}

template <class T>
Vec3<T> nearly_unit(const Vec3<double>& w) {
  using Wide = long double;
  const std::array<double, 3> c{w.x, w.y, w.z};
  std::size_t solved = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(c[k]) > std::abs(c[solved])) solved = k;
  const std::size_t a = (solved + 1) % 3, b = (solved + 2) % 3;
  const auto reach = [&](std::size_t k, std::size_t other) {
    return c[k] == 0 ? 0 : c[other] == 0 ? 1000 : 16;
  };
  const auto moved = [&](std::size_t k, int ulps) {
    const T x = T(c[k]);
    return x + T(ulps) * (std::abs(x) * std::numeric_limits<T>::epsilon());
  };
  std::array<T, 3> best{T(c[0]), T(c[1]), T(c[2])};
  Wide least = 1;
  for (int i = -reach(a, b); i <= reach(a, b); ++i)
    for (int j = -reach(b, a); j <= reach(b, a); ++j) {
      const T x = moved(a, i), y = moved(b, j);
      const Wide rest = Wide(x) * Wide(x) + Wide(y) * Wide(y);
      const T z = T(std::sqrt(1 - rest));
      const Wide off = std::abs(rest + Wide(z) * Wide(z) - 1);
      if (off < least) {
        least = off;
        best[a] = x;
        best[b] = y;
        best[solved] = c[solved] < 0 ? -z : z;
      }
    }
  return {best[0], best[1], best[2]};
}
template Vec3<float> nearly_unit<float>(const Vec3<double>&);
template Vec3<double> nearly_unit<double>(const Vec3<double>&);

}  // namespace brdf::validate
