// Conversions between Matrix and Eigen's matrices.
#pragma once

#include <Eigen/Dense>
#include <algorithm>

#include "fit/algebra/matrix.h"

namespace brdf::fit {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Returns a view of `m`, which must outlive the view.
inline Eigen::Map<const RowMatrix> view_of(const Matrix& m) {
  return {m.a.data(), Eigen::Index(m.rows), Eigen::Index(m.cols)};
}

// Returns a copy of `m` as a Matrix.
inline Matrix matrix_of(const RowMatrix& m) {
  Matrix out(std::size_t(m.rows()), std::size_t(m.cols()));
  std::copy(m.data(), m.data() + m.size(), out.a.begin());
  return out;
}

}  // namespace brdf::fit
