// Derivatives by Dual and ceres::Jet against differences in 50 digits, for every parameter of every
// fittable form, including parameters at their bounds and grazing angles.
#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "brdf/dual.h"
#include "tests/typed.h"
#include "validate/numerics/exact.h"
#include "validate/search/extremes.h"

namespace brdf::validate {
namespace {

constexpr int kMost = 20;  // parameters of any form

template <class S>
S variable(double value, int k);
template <>
Dual<double, kMost> variable(double value, int k) {
  return Dual<double, kMost>::variable(value, std::size_t(k));
}
template <>
ceres::Jet<double, kMost> variable(double value, int k) {
  return {value, k};
}

// Returns f with its derivatives with respect to all parameters, weights first.
template <class S>
S differentiated(const Reflectance& form, const std::vector<double>& weights,
                 const std::vector<double>& shape, const Geometry<double>& g) {
  std::vector<S> w, s;
  for (double v : weights) w.push_back(variable<S>(v, int(w.size())));
  for (double v : shape) s.push_back(variable<S>(v, int(w.size() + s.size())));
  return visit_form(form, [&](auto f) -> S {
    using F = decltype(f);
    const auto weight = from_values<typename F::template Weights<S>>(std::span<const S>(w));
    return eval(f, weight, weight, from_values<typename F::template Shape<S>>(std::span<const S>(s)), g);
  });
}

// One point of the grid with f and its exact derivatives.
struct Point {
  Vec3<double> wi, wo;
  Exact f;
  std::vector<Exact> derivatives;
};

Vec3<Exact> as_it_stands(const Vec3<double>& w) {
  return {Exact(w.x), Exact(w.y), Exact(w.z)};
}

Point exact_point(const Reflectance& form, const std::vector<double>& weights,
                  const std::vector<double>& shape, const Vec3<double>& wi, const Vec3<double>& wo) {
  const auto value = [&](std::size_t moved, const Exact& by) {
    std::vector<Exact> w(weights.begin(), weights.end()), s(shape.begin(), shape.end());
    if (moved < w.size())
      w[moved] += by;
    else if (moved < w.size() + s.size())
      s[moved - w.size()] += by;
    return exact_eval(form, {&w, 1}, s, as_it_stands(wi), as_it_stands(wo), kMinCosine<double>)[0];
  };
  const std::size_t count = weights.size() + shape.size();
  Point point{wi, wo, value(count, 0), {}};
  for (std::size_t k = 0; k < count; ++k) {
    const double p = k < weights.size() ? weights[k] : shape[k - weights.size()];
    // At the lower bound (for eta = 1, total reflection lies below) the difference is one-sided and of
    // second order.
    const bool at_bound = k >= weights.size() && p == info(form).shape[k - weights.size()].min;
    const Exact h = Exact(p == 0 ? 1 : p) * (at_bound ? Exact(1e-22) : Exact(1e-15));
    point.derivatives.push_back(at_bound ? (4 * value(k, h) - value(k, 2 * h) - 3 * point.f) / (2 * h)
                                         : (value(k, h) - value(k, -h)) / (2 * h));
  }
  return point;
}

// Returns points for three directions of incidence and every third of the extreme views.
std::vector<Point> points(const Reflectance& form, const std::vector<double>& weights,
                          const std::vector<double>& shape) {
  std::vector<Point> all;
  const LobeWidth width = lobe_width(info(form), shape);
  for (double theta : {20.0, 60.0, 89.99}) {
    const Vec3<double> wi = direction(degrees(theta), radians(0.3));
    const auto views = extreme_views(wi, width.x, width.y);
    for (std::size_t k = 0; k < views.size(); k += 3) {
      // Towards wo = -wi, next to eta = 1, the exact Fresnel term is (eta - 1)^2/(2 cos_d^4). A difference
      // quotient does not resolve this term, so the point is left out.
      const Vec3<double> h = wi + views[k];
      if (info(form).shape_index("eta") < 0 || dot(h, h) > 0.01)
        all.push_back(exact_point(form, weights, shape, wi, views[k]));
    }
  }
  return all;
}

// Returns the largest error of a derivative, relative to the derivative plus (f + 1e-12 / sr) over the
// parameter, because derivatives cross zero. Points with f below 1e-12 of the peak are skipped.
template <class S>
double largest_error(const Reflectance& form, const std::vector<double>& weights,
                     const std::vector<double>& shape, const std::vector<Point>& grid) {
  Exact peak = 0;
  for (const Point& p : grid) peak = larger(peak, p.f);
  double worst = 0;
  for (const Point& p : grid) {
    if (p.f < Exact(1e-12) * peak) continue;
    const S f = differentiated<S>(form, weights, shape, geometry(p.wi, p.wo));
    for (std::size_t k = 0; k < p.derivatives.size(); ++k) {
      const double at = k < weights.size() ? weights[k] : shape[k - weights.size()];
      const Exact scale = abs(p.derivatives[k]) + (p.f + Exact(1e-12)) / Exact(at == 0 ? 1 : at);
      const double derivative = f.v[int(k)];
      if (!std::isfinite(derivative)) return INFINITY;
      worst = std::max(worst, double(Exact(abs(Exact(derivative) - p.derivatives[k]) / scale)));
    }
  }
  return worst;
}

std::vector<Reflectance> fittable_forms() {
  std::vector<Reflectance> forms;
  for (const Reflectance& form : catalogue())
    if (info(form).fittable()) forms.push_back(form);
  return forms;
}

class Derivatives : public ::testing::TestWithParam<Reflectance> {};

TEST_P(Derivatives, OfDualsAndJetsAreExact) {
  const Reflectance& form = GetParam();
  const ReflectanceInfo& f = info(form);
  std::vector<double> weights;
  for (const ParameterInfo& p : f.weights)
    weights.push_back(p.name == "kd" ? 0 : p.initial);  // the diffuse term would hide the lobe
  double by_dual = 0, by_jet = 0;
  for (const auto& shape : extreme_parameters(form).shapes) {
    const auto grid = points(form, weights, shape);
    by_dual = std::max(by_dual, largest_error<Dual<double, kMost>>(form, weights, shape, grid));
    by_jet = std::max(by_jet, largest_error<ceres::Jet<double, kMost>>(form, weights, shape, grid));
  }
  if (!f.accuracy) std::cout << "no accuracy stated: " << f.name << ", derivatives to " << by_dual << '\n';
  const double bound = f.accuracy ? 2e-14 : 1e-9;
  EXPECT_LT(by_dual, bound) << f.name;
  EXPECT_LT(by_jet, bound) << f.name;
}

INSTANTIATE_TEST_SUITE_P(FittableForms, Derivatives, ::testing::ValuesIn(fittable_forms()),
                         [](const auto& param) { return std::string(brdf::info(param.param).name); });

}  // namespace
}  // namespace brdf::validate
