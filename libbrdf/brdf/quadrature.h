// Gauss rules, and panels that concentrate their nodes in regions of fast variation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace brdf::quadrature {

inline constexpr std::size_t kRow = 64;  // nodes processed at a time

// Computes sinh and cosh of 0 <= s[k] <= 700. Largest relative error: 4 ulp, also for tiny s. Outputs may
// not overlap. The loop is vectorised like the batches of the forms; with calls of the C library the nodes
// would cost ten times as much as the forms.
void sinh_cosh(std::size_t count, const double* s, double* sinh, double* cosh);

struct GaussRule {
  std::vector<double> node, weight;  // on [0, 1]
};

// Returns the Gauss-Legendre rule with n points. Nodes are accurate to 1e-16 (Newton's method on the
// Legendre recurrence). Rules are computed once and kept. Thread safe.
// Example:
//     const brdf::quadrature::GaussRule& rule = brdf::quadrature::gauss_legendre(8);
//     double integral = 0;  // of exp over [0, 1]
//     for (std::size_t k = 0; k < rule.node.size(); ++k)
//       integral += rule.weight[k] * std::exp(rule.node[k]);
const GaussRule& gauss_legendre(int n);
// Returns the Gauss-Lobatto rule with n >= 3 points, which includes both ends; exact up to degree 2 n - 3.
const GaussRule& gauss_lobatto(int n);

struct UnitNode {
  double v, weight;
};

// Returns the k-th node of [0, 1] after the substitution v -> v^2 at each marked end: an end at which the
// integrand has a square root or the tangent of a kink. The substitution makes the integrand smooth.
inline UnitNode unit_node(const GaussRule& rule, std::size_t k, bool root_low, bool root_high) {
  const double v = rule.node[k], w = rule.weight[k];
  if (root_low && root_high) return {v * v * (3 - 2 * v), w * 6 * v * (1 - v)};  // quadratic at both ends
  if (root_low) return {v * v, w * 2 * v};
  if (!root_high) return {v, w};
  const double u = rule.node[rule.node.size() - 1 - k];  // 1 - v without cancellation
  return {1 - u * u, w * 2 * u};
}

// Calls visit(distance, weight) for distances in [0, length] from a point near which the integrand varies
// on the length `scale`. Returns the number of e-folds of distance that the nodes cover.
template <class Visit>
double graded_panel(const GaussRule& rule, double length, double scale, bool root, Visit&& visit) {
  scale = std::fmin(scale, length);
  const double end = std::asinh(length / scale);
  std::array<double, kRow> s, weight, sinh, cosh;
  for (std::size_t first = 0; first < rule.node.size(); first += kRow) {
    const std::size_t count = std::min(kRow, rule.node.size() - first);
    for (std::size_t k = 0; k < count; ++k) {
      const UnitNode node = unit_node(rule, first + k, root, false);
      s[k] = end * node.v;
      weight[k] = node.weight * end * scale;
    }
    sinh_cosh(count, s.data(), sinh.data(), cosh.data());
    for (std::size_t k = 0; k < count; ++k) visit(scale * sinh[k], weight[k] * cosh[k]);
  }
  return end;
}

}  // namespace brdf::quadrature
