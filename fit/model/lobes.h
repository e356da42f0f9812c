// Blocks of lobes: what the solver streams over.
#pragma once

#include <span>
#include <vector>

#include "brdf/aperture.h"
#include "brdf/reflectance.h"

namespace brdf::fit {

inline constexpr std::size_t kBlock = 256;  // rows per block; a multiple of the widest vector

// Number of lobes; 0 where the form is not linear in its weights.
std::size_t lobe_count_of(const Reflectance& form);

// One form's lobes and derivatives for a block of at most
// kBlock direction pairs. Rows below the horizon give 0.
class LobeBlock {
 public:
  explicit LobeBlock(const Reflectance& form);

  // Directions in the surface's frame; `detector`: quadrature over its aperture, empty for none.
  void evaluate(std::span<const double> shape, Angle tangent_phi, Partial partial,
                const Directions<double>& directions, std::span<const ApertureNode> detector);
  // Columns of the last evaluation, kBlock entries each;
  // derivative d counts the shape parameters, then tangent_phi.
  double* lobe(std::size_t k) { return &rows_[k * (1 + derivatives_) * kBlock]; }
  double* derivative(std::size_t k, std::size_t d) { return lobe(k) + (1 + d) * kBlock; }

 private:
  void evaluate_point(std::span<const double> shape, Angle tangent_phi, Partial partial,
                      const Directions<double>& directions, double* out);

  Reflectance form_;
  std::size_t lobes_, shape_parameters_, derivatives_ = 0;
  std::vector<double> rows_, one_node_;
  DirectionArrays<double> turned_, displaced_;
};

}  // namespace brdf::fit
