#include "integrals/v_cavity.h"

#include <algorithm>
#include <cmath>

#include "brdf/scalar.h"

namespace brdf::integrals {
namespace {

void add_quadratic_roots(double a, double b, double c, std::vector<double>& roots) {
  const double d = b * b - 4 * a * c;
  if (!(d >= 0)) return;
  const double t = -0.5 * (b + std::copysign(std::sqrt(d), b));
  if (a != 0) roots.push_back(t / a);
  if (t != 0) roots.push_back(c / t);
}

// Real roots of a x^3 + b x^2 + c x + d.
void add_cubic_roots(double a, double b, double c, double d, std::vector<double>& roots) {
  if (std::abs(a) < 1e-13 * (std::abs(b) + std::abs(c) + std::abs(d)))
    return add_quadratic_roots(b, c, d, roots);
  const double B = b / a, C = c / a, D = d / a;
  const double q = (B * B - 3 * C) / 9, r = (2 * B * B * B - 9 * B * C + 27 * D) / 54;
  std::vector<double> found;
  if (r * r < q * q * q) {
    const double t = std::acos(std::clamp(r / std::sqrt(q * q * q), -1.0, 1.0));
    for (const double turn : {0.0, 2 * kPi, -2 * kPi})
      found.push_back(-2 * std::sqrt(q) * std::cos((t + turn) / 3) - B / 3);
  } else {
    const double s = -std::copysign(std::cbrt(std::abs(r) + std::sqrt(r * r - q * q * q)), r);
    found.push_back(s + (s == 0 ? 0 : q / s) - B / 3);
  }
  for (double x : found) {
    for (int step = 0; step < 2; ++step) {
      const double slope = (3 * x + 2 * B) * x + C;
      if (slope != 0) x -= (((x + B) * x + C) * x + D) / slope;
    }
    roots.push_back(x);
  }
}

struct Branches {
  double fixed, moving;  // 2 h_z cos/(o.h) for the two directions

  // The branch that is the minimum: 0 none, 1 fixed, 2 moving.
  int taken() const { return fixed >= 1 && moving >= 1 ? 0 : fixed < moving ? 1 : 2; }
};

Branches branches(double ox, double oy, double oz, double p, double q) {
  const double w = oz + ox * p + oy * q;
  return {2 * oz / w, 4 / (1 + p * p + q * q) - 2 * oz / w};
}

}  // namespace

std::vector<double> v_cavity_kinks(double ox, double oy, double oz, double p, double q_low, double q_high) {
  const double c = oz + ox * p, m = 1 + p * p;
  std::vector<double> roots;
  if (oy != 0) roots.push_back((2 * oz - c) / oy);                                   // fixed = 1
  add_quadratic_roots(oz, -oy, oz * m - c, roots);                                   // fixed = moving
  add_cubic_roots(-oy, -2 * oz - c, (4 - m) * oy, (4 - m) * c - 2 * oz * m, roots);  // moving = 1
  std::sort(roots.begin(), roots.end());
  std::vector<double> kinks;
  const double length = q_high - q_low;
  // A root is a kink where the branch differs on its two sides.
  double previous = q_low;
  for (std::size_t k = 0; k < roots.size(); ++k) {
    if (!(roots[k] > q_low && roots[k] < q_high)) continue;
    double next = q_high;
    for (std::size_t j = k + 1; j < roots.size(); ++j)
      if (roots[j] - roots[k] > 1e-13 * length) {
        next = std::min(next, roots[j]);
        break;
      }
    if (branches(ox, oy, oz, p, (previous + roots[k]) / 2).taken() !=
        branches(ox, oy, oz, p, (roots[k] + next) / 2).taken())
      kinks.push_back(roots[k]);
    previous = roots[k];
  }
  return kinks;
}

std::vector<double> v_cavity_breaks(double ox, double oy, double oz, double p_low, double p_high) {
  const auto count = [&](double p) {
    const double c = oz * (p * p - 1) - 2 * ox * p, d = oy * oy - oz * c;
    if (!(d > 0)) return std::size_t{0};
    const double t = oy + std::copysign(std::sqrt(d), oy);
    return v_cavity_kinks(ox, oy, oz, p, std::min(t / oz, c / t), std::max(t / oz, c / t)).size();
  };
  // The slopes span decades when the fixed direction grazes: a grid in asinh.
  constexpr int kGrid = 400;
  const double s_low = std::asinh(p_low), s_high = std::asinh(p_high);
  std::vector<double> breaks;
  double left = s_low;
  std::size_t before = 0;
  for (int k = 1; k <= kGrid; ++k) {
    const double right = s_low + (s_high - s_low) * k / kGrid;
    const std::size_t after = k == kGrid ? 0 : count(std::sinh(right));
    if (after != before) {
      double a = left, b = right;
      for (int step = 0; step < 55; ++step) {
        const double middle = (a + b) / 2;
        (count(std::sinh(middle)) == before ? a : b) = middle;
      }
      if (b < right || k < kGrid) breaks.push_back(std::sinh((a + b) / 2));
    }
    left = right;
    before = after;
  }
  return breaks;
}

}  // namespace brdf::integrals
