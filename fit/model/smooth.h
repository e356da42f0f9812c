// A shape that changes smoothly over wavelength: a polynomial of low degree in 1/wavelength.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/algebra/matrix.h"

namespace brdf::fit {

inline constexpr int kHighestDegree = 5;

// The polynomial is told by its values at degree + 1 nodes (Chebyshev's extrema between the ends of the
// spectrum), which have the parameter's own range; at a channel it is the sum of their shares (Lagrange).
struct SmoothBasis {
  std::vector<double> nodes;               // 1000 nm / wavelength, ascending
  std::vector<std::vector<double>> share;  // [node][channel]

  // The coefficients of the powers of 1000 nm / wavelength are this, [power][node], times the values at the
  // nodes.
  Matrix coefficients() const;
};

// Throws InputError where a channel's name says no wavelength or there are not more wavelengths than
// `degree`.
SmoothBasis smooth_basis(std::span<const std::string> channels, int degree);

}  // namespace brdf::fit
