// A small dense matrix for interfaces. Computations map it to an Eigen matrix.
#pragma once

#include <cstddef>
#include <vector>

namespace brdf::fit {

struct Matrix {
  std::size_t rows = 0, cols = 0;
  std::vector<double> a;

  Matrix() = default;
  Matrix(std::size_t r, std::size_t c) : rows(r), cols(c), a(r * c, 0.0) {}
  double& operator()(std::size_t i, std::size_t j) { return a[i * cols + j]; }
  double operator()(std::size_t i, std::size_t j) const { return a[i * cols + j]; }
};

}  // namespace brdf::fit
