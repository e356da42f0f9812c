#include "fit/assess/smooth_curves.h"

#include <algorithm>
#include <cmath>

namespace brdf::fit {

std::vector<SmoothCurve> smooth_curves(const Model& model, std::span<const double> p,
                                       const RowMatrix& covariance) {
  std::vector<SmoothCurve> out;
  if (!model.smooth()) return out;
  const Matrix by_node = model.smooth()->coefficients();
  for (std::size_t s = 0; s < model.shape_slots(); ++s) {
    const Slot& slot = model.slots()[s];
    if (slot.nodes == 1 || slot.node > 0) continue;
    SmoothCurve& curve = out.emplace_back(SmoothCurve{slot.name, std::string(name_of(slot.scale)), {}, {}});
    for (std::size_t power = 0; power < slot.nodes; ++power) {
      Eigen::VectorXd slope = Eigen::VectorXd::Zero(covariance.rows());
      double value = 0;
      for (std::size_t k = 0; k < slot.nodes; ++k) {
        value += by_node(power, k) * p[s + k];
        slope(Eigen::Index(s + k)) = by_node(power, k);
      }
      curve.coefficients.push_back(value);
      curve.standard_errors.push_back(std::sqrt(std::max(slope.dot(covariance * slope), 0.0)));
    }
  }
  return out;
}

}  // namespace brdf::fit
