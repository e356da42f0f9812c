// A shape that varies smoothly over wavelength: a polynomial of low degree in 1/wavelength.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/algebra/matrix.h"

namespace brdf::fit {

inline constexpr int kHighestDegree = 5;

// The basis of the polynomial. The polynomial is defined by its values at degree + 1 nodes (Chebyshev's
// extrema between the ends of the spectrum); these values have the range of the parameter. The value at a
// channel is the sum of the nodes' values times their shares (Lagrange).
struct SmoothBasis {
  std::vector<double> nodes;               // 1000 nm / wavelength, ascending
  std::vector<std::vector<double>> share;  // [node][channel]

  // Returns the matrix [power][node] that maps the values at the nodes to the coefficients of the powers of
  // 1000 nm / wavelength.
  Matrix coefficients() const;
};

// Returns the basis for the channels. Throws InputError if the name of a channel contains no wavelength or
// if there are not more wavelengths than `degree`.
SmoothBasis smooth_basis(std::span<const std::string> channels, int degree);

}  // namespace brdf::fit
