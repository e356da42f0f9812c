#include "brdf/quadrature.h"

#include <map>
#include <mutex>

#include "brdf/scalar.h"
#include "libbrdf/src/integrals/functions.h"

namespace brdf::quadrature {
namespace {

GaussRule legendre(int n) {
  GaussRule rule{std::vector<double>(n), std::vector<double>(n)};
  for (int k = 0; k < (n + 1) / 2; ++k) {
    double x = integrals::cos(kPi * (k + 0.75) / (n + 0.5)), derivative = 1;
    for (int step = 0; step < 100; ++step) {
      double previous = 1, value = x;
      for (int j = 2; j <= n; ++j) {
        const double next = ((2 * j - 1) * x * value - (j - 1) * previous) / j;
        previous = value;
        value = next;
      }
      derivative = n * (x * value - previous) / (x * x - 1);
      const double change = value / derivative;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    const double weight = 1 / ((1 - x * x) * derivative * derivative);
    rule.node[k] = (1 - x) / 2;
    rule.node[n - 1 - k] = (1 + x) / 2;
    rule.weight[k] = rule.weight[n - 1 - k] = weight;
  }
  return rule;
}

// The inner nodes are the extrema of the Legendre polynomial of degree n - 1.
GaussRule lobatto(int n) {
  const int degree = n - 1;
  GaussRule rule{std::vector<double>(n), std::vector<double>(n)};
  for (int k = 0; k < (n + 1) / 2; ++k) {
    double x = integrals::cos(kPi * k / degree), value = 1;
    for (int step = 0; step < 100; ++step) {
      double previous = 1;
      value = x;
      for (int j = 2; j <= degree; ++j) {
        const double next = ((2 * j - 1) * x * value - (j - 1) * previous) / j;
        previous = value;
        value = next;
      }
      if (k == 0) break;  // the end of the interval
      // P' = degree (x P - P_before)/(x^2 - 1). P'' follows from Legendre's equation.
      const double first = degree * (x * value - previous) / (x * x - 1);
      const double second = (2 * x * first - degree * (degree + 1) * value) / (1 - x * x);
      const double change = first / second;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    rule.node[k] = (1 - x) / 2;
    rule.node[n - 1 - k] = (1 + x) / 2;
    rule.weight[k] = rule.weight[n - 1 - k] = 1 / (degree * n * value * value);
  }
  return rule;
}

// Returns the rule with n points, which is computed once.
const GaussRule& kept(std::map<int, GaussRule>& rules, int n, GaussRule (*compute)(int)) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  auto found = rules.find(n);
  if (found == rules.end()) found = rules.emplace(n, compute(n)).first;
  return found->second;
}

}  // namespace

const GaussRule& gauss_legendre(int n) {
  static std::map<int, GaussRule> rules;
  return kept(rules, n, legendre);
}

const GaussRule& gauss_lobatto(int n) {
  static std::map<int, GaussRule> rules;
  return kept(rules, n, lobatto);
}

}  // namespace brdf::quadrature
