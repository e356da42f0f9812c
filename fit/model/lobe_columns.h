// The lobes of a block of rows in columns, over which the solver streams.
#pragma once

#include <span>
#include <vector>

#include "brdf/aperture.h"
#include "brdf/reflectance.h"

namespace brdf::fit {

inline constexpr std::size_t kBlockRows = 256;  // rows per block; a multiple of the widest vector

// The lobes of one form, and their derivatives, at up to kBlockRows pairs of directions. Rows below the
// horizon give 0.
class LobeColumns {
 public:
  explicit LobeColumns(const Reflectance& form);

  // Evaluates the lobes. The directions are in the surface's frame. `detector` is a quadrature over the
  // aperture of the detector; empty for no aperture.
  void evaluate(std::span<const double> shape, Angle tangent_phi, Partial partial,
                const Directions<double>& directions, std::span<const ApertureNode> detector);
  // Return columns of the last evaluation, kBlockRows entries each. The index of a derivative, d, counts
  // the shape parameters, then tangent_phi.
  double* lobe(std::size_t k) { return &rows_[k * (1 + derivatives_) * kBlockRows]; }
  double* derivative(std::size_t k, std::size_t d) { return lobe(k) + (1 + d) * kBlockRows; }

 private:
  void evaluate_point(std::span<const double> shape, Angle tangent_phi, Partial partial,
                      const Directions<double>& directions, double* out);

  Reflectance form_;
  std::size_t lobes_, shape_parameters_, derivatives_ = 0;
  std::vector<double> rows_, one_node_;
  DirectionArrays<double> turned_, displaced_;
};

}  // namespace brdf::fit
