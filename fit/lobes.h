// Lobes of a form and their derivatives for a block of direction pairs, structure of arrays.
#pragma once

#include <span>

#include "brdf/forms.h"

namespace brdf::fit {

inline constexpr std::size_t kBlock = 256;  // rows per block; a multiple of the widest vector
inline constexpr std::size_t kMaxPartials = 4;
inline constexpr std::size_t kMaxLobes = 4;  // of one form

// Unit vectors wi and wo of a block's rows, by component.
struct DirectionBlock {
  const double *wi_x, *wi_y, *wi_z, *wo_x, *wo_y, *wo_z;
  std::size_t rows;
};

// What to evaluate: the shape, and which derivatives.
struct LobeRequest {
  std::span<const double> shape;  // in the order of the form's table
  std::span<const int> partial;   // [shape parameter]: its derivative's position, -1 for none; tied
                                  // parameters share one
  double tangent_phi = 0;         // radians
  int tangent_partial = -1;       // position of the derivative by tangent_phi
  std::size_t partials = 0;       // how many derivatives, at most kMaxPartials
};

// Number of lobes; 0 where the form is not linear in its weights.
std::size_t lobe_count_of(const AnyForm& form);

// Writes K lobes, then for each derivative the K lobes' derivatives: column p K + k starts at
// out + (p K + k) kBlock. Rows below the horizon give 0.
void evaluate_lobes(const AnyForm& form, const LobeRequest& request, const DirectionBlock& directions,
                    double* out);

}  // namespace brdf::fit
