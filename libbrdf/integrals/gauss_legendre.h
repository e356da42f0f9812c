// Gauss-Legendre nodes, and panels mapped so that nodes gather where an integrand varies fastest.
#pragma once

#include <cmath>
#include <vector>

namespace brdf::integrals {

struct GaussRule {
  std::vector<double> node, weight;  // on [0, 1]
};

// Nodes to 1e-16, by Newton's method on the Legendre recurrence. Kept once computed; thread safe.
const GaussRule& gauss_legendre(int n);

// visit(v, weight) for the nodes of [0, 1] after v -> v^power at the ends where the integrand has a square
// root or a kink's tangent (power 2): the substitution makes it smooth.
template <class Visit>
void unit_panel(const GaussRule& rule, bool root_low, bool root_high, Visit&& visit) {
  const std::size_t n = rule.node.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double v = rule.node[k], w = rule.weight[k];
    if (root_low && root_high) {
      // v -> 3 v^2 - 2 v^3: quadratic at both ends
      visit(v * v * (3 - 2 * v), w * 6 * v * (1 - v));
    } else if (root_low) {
      visit(v * v, w * 2 * v);
    } else if (root_high) {
      const double u = rule.node[n - 1 - k];  // 1 - v without cancellation
      visit(1 - u * u, w * 2 * u);
    } else {
      visit(v, w);
    }
  }
}

// visit(distance, weight) for distances in [0, length] from a point where the integrand varies on `scale`.
template <class Visit>
void graded_panel(const GaussRule& rule, double length, double scale, bool root, Visit&& visit) {
  scale = std::fmin(scale, length);
  const double s = std::asinh(length / scale);
  unit_panel(rule, root, false,
             [&](double v, double w) { visit(scale * std::sinh(s * v), w * s * scale * std::cosh(s * v)); });
}

}  // namespace brdf::integrals
