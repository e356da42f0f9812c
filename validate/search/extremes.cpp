#include "validate/search/extremes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "brdf/directions.h"

namespace brdf::validate {
namespace {

std::vector<double> inside(const ParameterInfo& p, std::vector<double> values) {
  std::erase_if(values, [&](double v) { return v < p.min || v > p.max; });
  return values;
}

std::vector<double> extreme_values(const ParameterInfo& p) {
  switch (p.role) {
    case Role::exponent:
    case Role::exponent_across:
      return inside(p, {p.min, 1, 5.3, 50, p.max});
    case Role::index:
      return inside(p, {p.min, 1.0001, 1.5, p.max});
    case Role::slope:
      return inside(p, {p.min, 0.1985, 0.9, p.max});
    case Role::width:
    case Role::width_across:
      return inside(p, {p.min, 3e-3, 0.1, 0.4, p.max});
    case Role::diffuse:
    case Role::specular:
    case Role::f0:
    case Role::extinction:
    case Role::tint:
    case Role::other:
      break;
  }
  return p.initial == p.max ? std::vector{p.min, p.max} : std::vector{p.min, p.initial, p.max};
}

// Pairs of values along and across the tangent: equal values, then values far apart, instead of all pairs.
std::vector<std::array<double, 2>> extreme_pairs(const ParameterInfo& along, const ParameterInfo& across) {
  std::vector<std::array<double, 2>> pairs;
  for (const double v : extreme_values(along))
    if (v >= across.min && v <= across.max) pairs.push_back({v, v});
  const bool widths = along.role == Role::width;
  const auto limited = [&](double v) { return std::clamp(v, across.min, across.max); };
  pairs.push_back({along.min, limited(widths ? 0.1 : across.max)});
  pairs.push_back({along.max, limited(widths ? 1e-3 : across.min)});
  return pairs;
}

std::vector<std::vector<double>> extreme_shapes(const ReflectanceInfo& form) {
  const auto [along, across] = form.axes();
  std::vector<std::vector<double>> sets{std::vector<double>(form.shape.size())};
  for (std::size_t k = 0; k < form.shape.size(); ++k) {
    if (int(k) == across) continue;  // set together with the parameter along the tangent
    std::vector<std::vector<double>> longer;
    for (auto set : sets) {
      if (int(k) != along) {
        for (const double v : extreme_values(form.shape[k])) longer.emplace_back(set)[k] = v;
        continue;
      }
      for (const auto& [x, y] : extreme_pairs(form.shape[k], form.shape[std::size_t(across)])) {
        set[k] = x;
        set[std::size_t(across)] = y;
        longer.push_back(set);
      }
    }
    sets = std::move(longer);
  }
  return sets;
}

std::vector<std::vector<double>> extreme_weights(const ReflectanceInfo& form) {
  if (form.basis) return {lobe_alone(form)};
  const int f0 = form.weight_index(Role::f0);
  std::vector<std::vector<double>> sets{lobe_alone(form)};
  if (f0 >= 0) {
    sets.push_back(sets.front());
    sets.back()[std::size_t(f0)] = form.weights[std::size_t(f0)].min;
  }
  const std::size_t terms = form.weights.size() - (f0 >= 0);
  const double share = terms == 1 ? 0.01 : 1 / double(terms);
  std::vector<double>& all = sets.emplace_back();
  for (const ParameterInfo& p : form.weights)
    all.push_back(p.role == Role::f0 ? p.initial : std::clamp(share, p.min, p.max));
  return sets;
}

}  // namespace

std::vector<double> lobe_alone(const ReflectanceInfo& form) {
  const auto counts = [](const ParameterInfo& p) { return p.role != Role::diffuse && p.role != Role::f0; };
  const bool has_lobe = std::ranges::any_of(form.weights, counts);
  std::vector<double> weights;
  if (form.basis) {  // the constant, and so little of every other function that f stays above 0
    weights.assign(form.weights.size(), 0.5 / double(form.weights.size()));
    weights[std::size_t(form.weight_index(Role::diffuse))] = 1;
    return weights;
  }
  for (const ParameterInfo& p : form.weights)
    weights.push_back(p.role == Role::diffuse && has_lobe ? p.min : std::min(p.max, 1.0));
  return weights;
}

ParameterGrid extreme_parameters(const Reflectance& form) {
  return {extreme_weights(form.info()), extreme_shapes(form.info())};
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
  const auto [along, across] = form.axes();
  const auto of = [&](int k, Role role) {
    const double value = shape[std::size_t(k)];
    return role == Role::width ? value : std::sqrt(2 / (value + 2));
  };
  for (const Role role : {Role::width, Role::exponent})
    if (const int k = form.shape_index(role); k >= 0) return {of(k, role), of(k == along ? across : k, role)};
  return {0.3, 0.3};
}

template <class T>
Vec3<T> nearly_unit(const Vec3<double>& w) {
  using Wide = std::conditional_t<std::is_same_v<T, float>, double, long double>;
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
  for (int i = -reach(a, b); i <= reach(a, b); ++i) {
    const T x = moved(a, i);
    for (int j = -reach(b, a); j <= reach(b, a); ++j) {
      const T y = moved(b, j);
      const Wide rest = Wide(x) * Wide(x) + Wide(y) * Wide(y);
      const T z = T(std::sqrt(double(1 - rest)));  // sqrt of long double takes five times as long
      const Wide off = std::abs(rest + Wide(z) * Wide(z) - 1);
      if (off < least) {
        least = off;
        best[a] = x;
        best[b] = y;
        best[solved] = c[solved] < 0 ? -z : z;
      }
    }
  }
  return {best[0], best[1], best[2]};
}
template Vec3<float> nearly_unit<float>(const Vec3<double>&);
template Vec3<double> nearly_unit<double>(const Vec3<double>&);

}  // namespace brdf::validate
