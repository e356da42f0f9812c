// Gauss rules, and panels mapped so that nodes gather where an integrand varies fastest.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace brdf::quadrature {

inline constexpr std::size_t kRow = 64;  // nodes handled at a time

// sinh and cosh of 0 <= s[k] <= 700. Largest relative error 4 ulp, for tiny s
// too. Outputs may not overlap. Vectorised as the batches of the forms are:
// with calls of the C library the nodes cost ten times what the forms cost.
void sinh_cosh(std::size_t count, const double* s, double* sinh, double* cosh);

struct GaussRule {
  std::vector<double> node, weight;  // on [0, 1]
};

// Nodes to 1e-16, by Newton's method on the Legendre recurrence. Kept once computed; thread safe.
const GaussRule& gauss_legendre(int n);
// The rule of n >= 3 points that has both ends among its nodes (Lobatto): exact to degree 2 n - 3.
const GaussRule& gauss_lobatto(int n);

struct UnitNode {
  double v, weight;
};

// The k-th node of [0, 1] after v -> v^power at the ends where the integrand has a square root or a kink's
// tangent (power 2): the substitution makes it smooth.
inline UnitNode unit_node(const GaussRule& rule, std::size_t k, bool root_low, bool root_high) {
  const double v = rule.node[k], w = rule.weight[k];
  if (root_low && root_high) return {v * v * (3 - 2 * v), w * 6 * v * (1 - v)};  // quadratic at both ends
  if (root_low) return {v * v, w * 2 * v};
  if (!root_high) return {v, w};
  const double u = rule.node[rule.node.size() - 1 - k];  // 1 - v without cancellation
  return {1 - u * u, w * 2 * u};
}

// visit(distance, weight) for distances in [0, length] from a point where the integrand varies on `scale`.
// Returns how many e-folds of distance the nodes are spread over.
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
