// A basis for matt surfaces: polynomials of both directions, reciprocal and isotropic.
//
// Koenderink and van Doorn, J. Opt. Soc. Am. A 15, 2903 (1998). x = 1 - cos(theta) and r = sqrt(x) map the
// hemisphere to the unit disk with equal areas. With Zernike's radial polynomials R_n^l,
//   f = (1/pi) sum of w_nml s_nml,
//   s_nml = 1/2 [R_n^l(r_i) R_m^l(r_o) + R_m^l(r_i) R_n^l(r_o)] cos(l (phi_o - phi_i)),
// over 0 <= l <= n <= m <= N with n - l and m - l even. The weights have either sign, w_000 has the size of
// a diffuse reflectance, and every |s| is at most 1.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "brdf/facts.h"
#include "brdf/geometry.h"

namespace brdf {

constexpr std::size_t matt_count(int order) {
  std::size_t count = 0;
  for (int l = 0; l <= order; ++l)
    for (int n = l; n <= order; n += 2)
      for (int m = n; m <= order; m += 2) ++count;
  return count;
}

// The functions of an order N, by l, then n, then m.
template <int kOrder>
inline constexpr auto kMattIndices = [] {
  std::array<MattIndex, matt_count(kOrder)> all{};
  std::size_t k = 0;
  for (int l = 0; l <= kOrder; ++l)
    for (int n = l; n <= kOrder; n += 2)
      for (int m = n; m <= kOrder; m += 2) all[k++] = {n, m, l};
  return all;
}();

// Returns the factor of r^(n - 2 k) in R_n^l.
constexpr double radial_coefficient(int n, int l, int k) {
  const auto factorial = [](int j) {
    double product = 1;
    for (int i = 2; i <= j; ++i) product *= i;
    return product;
  };
  return (k % 2 == 0 ? 1 : -1) * factorial(n - k) /
         (factorial(k) * factorial((n + l) / 2 - k) * factorial((n - l) / 2 - k));
}

// Returns R_n^l(r)/r^l, a polynomial of x = r^2.
template <int kN, int kL, class G>
G radial_over_power(const G& x) {
  G sum(radial_coefficient(kN, kL, 0));
  if constexpr (kN > kL)
    for (int k = 1; k <= (kN - kL) / 2; ++k) sum = sum * x + G(radial_coefficient(kN, kL, k));
  return sum;
}

// Returns the functions of the basis over pi. No angle is needed: with q = (x, y)/sqrt(1 + z) of each
// direction, |q|^2 = 1 - z and q_i.q_o = r_i r_o cos(phi_o - phi_i).
template <int kOrder, class S, class G>
std::array<S, matt_count(kOrder)> matt_lobes(const Geometry<G>& g) {
  const G xi = G(1) - g.cos_i, xo = G(1) - g.cos_o;
  const G t = tangential_product(g) / math::sqrt((G(1) + g.cos_i) * (G(1) + g.cos_o));
  // (r_i r_o)^l cos(l dphi), by the recurrence of cosines.
  std::array<G, std::size_t(kOrder) + 1> around;
  around[0] = G(1);
  around[1] = t;
  for (std::size_t l = 2; l < around.size(); ++l)
    around[l] = G(2) * t * around[l - 1] - xi * xo * around[l - 2];
  const auto lobe = [&]<std::size_t k>(std::integral_constant<std::size_t, k>) {
    constexpr MattIndex at = kMattIndices<kOrder>[k];
    if constexpr (at.m == 0) {
      return S(1 / kPi);
    } else {
      const G ni = radial_over_power<at.n, at.l>(xi), no = radial_over_power<at.n, at.l>(xo);
      const G& turned = around[std::size_t(at.l)];
      if constexpr (at.n == at.m) return S(G(1 / kPi) * (ni * no) * turned);
      const G mi = radial_over_power<at.m, at.l>(xi), mo = radial_over_power<at.m, at.l>(xo);
      return S(G(0.5 / kPi) * (ni * mo + mi * no) * turned);
    }
  };
  return [&]<std::size_t... k>(std::index_sequence<k...>) {
    return std::array<S, sizeof...(k)>{lobe(std::integral_constant<std::size_t, k>{})...};
  }(std::make_index_sequence<matt_count(kOrder)>{});
}

// Returns the directional albedo of s_nml/pi for a direction with x = 1 - cos(theta). The cosine is
// (R_0 - R_2)/2, so that only R_0 (1) and R_2 (-1/3) have an integral with it.
template <class S>
S matt_albedo(const MattIndex& at, const S& x) {
  if (at.l > 0) return S(0);
  const auto mean = [](int n) { return n == 0 ? 1.0 : n == 2 ? -1.0 / 3 : 0.0; };
  const auto radial = [&](int n) {
    S sum(radial_coefficient(n, 0, 0));
    for (int k = 1; k <= n / 2; ++k) sum = sum * x + S(radial_coefficient(n, 0, k));
    return sum;
  };
  return S(0.5) * (radial(at.n) * S(mean(at.m)) + radial(at.m) * S(mean(at.n)));
}

// Returns Bernstein's coefficients, of degree `degree`, of the polynomial sum of c_j t^j over [low, high]:
// the polynomial lies between the least and the largest of them, and meets them at both ends.
template <class S>
std::array<S, 6> bernstein(std::span<const double> c, int degree, const S& low, const S& high) {
  std::array<S, 6> out{};
  for (int k = 0; k <= degree; ++k) {
    // The elementary symmetric sums of `degree` arguments, k of them `high` and the others `low`.
    std::array<S, 6> symmetric{};
    symmetric[0] = S(1);
    for (int argument = 0; argument < degree; ++argument)
      for (int j = argument + 1; j >= 1; --j)
        symmetric[std::size_t(j)] =
            symmetric[std::size_t(j)] + symmetric[std::size_t(j) - 1] * (argument < k ? high : low);
    S sum(0);
    double choose = 1;
    for (int j = 0; j < int(c.size()); ++j) {
      if (c[std::size_t(j)] != 0) sum = sum + symmetric[std::size_t(j)] * S(c[std::size_t(j)]) / S(choose);
      choose = choose * (degree - j) / (j + 1);
    }
    out[std::size_t(k)] = sum;
  }
  return out;
}

// A box of r_i, r_o (0 to 1) and the cosine of the difference of the azimuths (-1 to 1).
template <class S>
struct MattBox {
  std::array<S, 3> low{S(0), S(0), S(-1)}, high{S(1), S(1), S(1)};
};

// Calls visit(coefficient, i, j, k) for Bernstein's coefficients of pi f on a box. f of the box lies between
// the least and the largest of them over pi. The coefficients with i, j and k at 0 or N are values at
// corners.
template <class S, class Visit>
void matt_coefficients(const MattBasis& basis, std::span<const S> weights, const MattBox<S>& box,
                       Visit&& visit) {
  const int degree = basis.order;
  const std::size_t size = std::size_t(degree) + 1;
  using Row = std::array<S, 6>;
  std::array<S, 216> sums{};
  for (int l = 0; l <= degree; ++l) {
    std::array<Row, 6> of_i{}, of_o{};
    for (int n = l; n <= degree; n += 2) {
      std::array<double, 6> c{};
      for (int k = 0; k <= (n - l) / 2; ++k) c[std::size_t(n - 2 * k)] = radial_coefficient(n, l, k);
      of_i[std::size_t(n)] = bernstein<S>(std::span(c).first(size), degree, box.low[0], box.high[0]);
      of_o[std::size_t(n)] = bernstein<S>(std::span(c).first(size), degree, box.low[1], box.high[1]);
    }
    // cos(l phi) as a polynomial of cos(phi) (Chebyshev).
    std::array<double, 6> before{1}, chebyshev{1};
    if (l > 0) chebyshev = {0, 1};
    for (int step = 2; step <= l; ++step) {
      std::array<double, 6> next{};
      for (std::size_t j = 0; j + 1 < next.size(); ++j) next[j + 1] = 2 * chebyshev[j];
      for (std::size_t j = 0; j < next.size(); ++j) next[j] -= before[j];
      before = chebyshev;
      chebyshev = next;
    }
    const Row of_azimuth = bernstein<S>(std::span(chebyshev).first(size), degree, box.low[2], box.high[2]);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) {
        S both(0);
        for (std::size_t at = 0; at < basis.indices.size(); ++at) {
          const auto [n, m, of_l] = basis.indices[at];
          if (of_l != l) continue;
          const S one = of_i[std::size_t(n)][i] * of_o[std::size_t(m)][j];
          const S product = n == m ? one : S(0.5) * (one + of_i[std::size_t(m)][i] * of_o[std::size_t(n)][j]);
          both = both + weights[at] * product;
        }
        for (std::size_t k = 0; k < size; ++k) {
          S& sum = sums[(i * size + j) * size + k];
          sum = sum + both * of_azimuth[k];
        }
      }
  }
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j)
      for (std::size_t k = 0; k < size; ++k) visit(sums[(i * size + j) * size + k], i, j, k);
}

}  // namespace brdf
