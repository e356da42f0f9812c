#include "libbrdf/src/integrals/v_cavity.h"

#include <algorithm>
#include <cmath>

#include "brdf/scalar.h"
#include "libbrdf/src/integrals/functions.h"

namespace brdf::integrals {
namespace {

void add_quadratic_roots(double a, double b, double c, std::vector<double>& roots) {
  const double d = b * b - 4 * a * c;
  if (!(d >= 0)) return;
  const double t = -0.5 * (b + std::copysign(std::sqrt(d), b));
  if (a != 0) roots.push_back(t / a);
  if (t != 0) roots.push_back(c / t);
}

// Adds the real roots of a x^3 + b x^2 + c x + d.
void add_cubic_roots(double a, double b, double c, double d, std::vector<double>& roots) {
  if (std::abs(a) < 1e-13 * (std::abs(b) + std::abs(c) + std::abs(d)))
    return add_quadratic_roots(b, c, d, roots);
  const double B = b / a, C = c / a, D = d / a;
  const double q = (B * B - 3 * C) / 9, r = (2 * B * B * B - 9 * B * C + 27 * D) / 54;
  std::vector<double> found;
  if (r * r < q * q * q) {
    const double t = integrals::acos(std::clamp(r / std::sqrt(q * q * q), -1.0, 1.0));
    for (const double turn : {0.0, 2 * kPi, -2 * kPi})
      found.push_back(-2 * std::sqrt(q) * integrals::cos((t + turn) / 3) - B / 3);
  } else {
    const double s = -std::copysign(integrals::cbrt(std::abs(r) + std::sqrt(r * r - q * q * q)), r);
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

  // Returns the branch that is the minimum: 0 for G = 1, 1 for fixed, 2 for moving.
  int taken() const { return fixed >= 1 && moving >= 1 ? 0 : fixed < moving ? 1 : 2; }
};

Branches branches(double ox, double oy, double oz, double p, double q) {
  const double w = oz + ox * p + oy * q;
  return {2 * oz / w, 4 / (1 + p * p + q * q) - 2 * oz / w};
}

// The kinks of a row, and its sequence of branches as the base-4 digits of one number.
struct Row {
  std::vector<double> kinks;
  int branches = 0;
};

Row row_of(double ox, double oy, double oz, double p, double q_low, double q_high) {
  const double c = oz + ox * p, m = 1 + p * p;
  std::vector<double> roots;
  if (oy != 0) roots.push_back((2 * oz - c) / oy);                                   // fixed = 1
  add_quadratic_roots(oz, -oy, oz * m - c, roots);                                   // fixed = moving
  add_cubic_roots(-oy, -2 * oz - c, (4 - m) * oy, (4 - m) * c - 2 * oz * m, roots);  // moving = 1
  std::erase_if(roots, [&](double q) { return !(q > q_low && q < q_high); });
  std::ranges::sort(roots);
  roots.push_back(q_high);
  Row row;
  double from = q_low;
  int previous = -1;
  for (const double root : roots) {
    if (root - from < 1e-13 * (q_high - q_low)) continue;
    const int taken = branches(ox, oy, oz, p, (from + root) / 2).taken();
    if (taken != previous) {
      if (previous >= 0) row.kinks.push_back(from);
      row.branches = 4 * row.branches + taken + 1;
    }
    previous = taken;
    from = root;
  }
  return row;
}

}  // namespace

std::vector<double> v_cavity_kinks(double ox, double oy, double oz, double p, double q_low, double q_high) {
  return row_of(ox, oy, oz, p, q_low, q_high).kinks;
}

std::vector<double> v_cavity_breaks(double ox, double oy, double oz, double p_low, double p_high) {
  const double scale = 0.1 * oz;
  const auto branches_at = [&](double s) {
    const double p = scale * integrals::sinh(s);
    const double c = oz * (p * p - 1) - 2 * ox * p, d = oy * oy - oz * c;
    if (!(d > 0)) return 0;
    const double t = oy + std::copysign(std::sqrt(d), oy);
    return row_of(ox, oy, oz, p, std::min(t / oz, c / t), std::max(t / oz, c / t)).branches;
  };
  // The slopes span decades, from o_z to 1/o_z, if the fixed direction grazes. The grid is therefore
  // uniform in asinh.
  constexpr int kGrid = 400;
  const double s_low = integrals::asinh(p_low / scale), s_high = integrals::asinh(p_high / scale);
  std::vector<double> breaks;
  double left = s_low;
  int before = 0;
  for (int k = 1; k <= kGrid; ++k) {
    const double right = s_low + (s_high - s_low) * k / kGrid;
    const int after = k == kGrid ? 0 : branches_at(right);
    if (after != before) {
      double a = left, b = right;
      for (int step = 0; step < 55; ++step) {
        const double middle = (a + b) / 2;
        (branches_at(middle) == before ? a : b) = middle;
      }
      breaks.push_back(scale * integrals::sinh((a + b) / 2));
    }
    left = right;
    before = after;
  }
  return breaks;
}

std::vector<Crossing> v_cavity_crossings(double ox, double oy, double oz) {
  // Gradients and second derivatives of the curves at q = 0, with w = o_z + o_x p + o_y q and
  // m = 1 + p^2 + q^2.
  std::vector<double> roots;
  if (ox != 0) roots = {oz / ox, ox / oz};           // fixed = 1: w = 2 o_z; fixed = moving: w = o_z m
  add_cubic_roots(-ox, -3 * oz, 3 * ox, oz, roots);  // moving = 1: 4 w = 2 o_z m + w m
  std::vector<Crossing> crossings;
  for (const double p : roots) {
    const double nudge = 1e-6 * std::abs(p);
    if (branches(ox, oy, oz, p - nudge, 0).taken() == branches(ox, oy, oz, p + nudge, 0).taken()) continue;
    const double w = oz + ox * p, m = 1 + p * p;
    double along_p = ox, along_q = oy, pp = 0, pq = 0, qq = 0;
    if (std::abs(w - oz * m) < 1e-9 * w) {
      along_p = ox - 2 * oz * p;
      pp = qq = -2 * oz;
    } else if (std::abs(w - 2 * oz) > 1e-9 * w) {
      along_p = (4 - m) * ox - 2 * p * (2 * oz + w);
      along_q = (4 - m) * oy;
      qq = -4 * oz - 2 * w;
      pp = qq - 4 * ox * p;
      pq = -2 * oy * p;
    }
    along_p = std::copysign(std::max(std::abs(along_p), 1e-300), along_p);
    const double slope = -along_q / along_p;
    crossings.push_back({p, std::abs(slope), std::abs((qq + 2 * pq * slope + pp * slope * slope) / along_p)});
  }
  return crossings;
}

}  // namespace brdf::integrals
