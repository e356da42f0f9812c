#include "fit/model/lobe_columns.h"

#include <algorithm>

namespace brdf::fit {

LobeColumns::LobeColumns(const Reflectance& form)
    : form_(form),
      lobes_(info(form).lobes.size()),
      shape_parameters_(info(form).shape.size()),
      rows_(lobes_ * (2 + shape_parameters_) * kBlockRows),
      turned_(0),  // allocated on first use
      displaced_(0) {}

void LobeColumns::evaluate_point(std::span<const double> shape, Angle tangent_phi, Partial partial,
                                 const Directions<double>& directions, double* out) {
  if (tangent_phi == Angle{}) {
    form_->lobes(shape, partial, directions, {out, kBlockRows});
    return;
  }
  if (turned_.size() == 0) turned_ = DirectionArrays<double>(kBlockRows);
  turn_batch(directions, tangent_phi, turned_);
  Directions<double> turned = turned_.view();
  turned.count = directions.count;
  form_->lobes(shape, partial, turned, {out, kBlockRows});
}

void LobeColumns::evaluate(std::span<const double> shape, Angle tangent_phi, Partial partial,
                           const Directions<double>& directions, std::span<const ApertureNode> detector) {
  derivatives_ = partial == Partial::none ? 0 : shape_parameters_ + (partial == Partial::shape_and_phi);
  if (detector.empty()) {
    evaluate_point(shape, tangent_phi, partial, directions, rows_.data());
    return;
  }
  const std::size_t used = lobes_ * (1 + derivatives_) * kBlockRows;
  one_node_.resize(rows_.size());
  if (displaced_.size() == 0) displaced_ = DirectionArrays<double>(kBlockRows);
  std::fill(rows_.begin(), rows_.begin() + std::ptrdiff_t(used), 0.0);
  for (const ApertureNode& node : detector) {
    for (std::size_t j = 0; j < directions.count; ++j)
      displaced_.set(j, directions.wi(j), aperture_direction(directions.wo(j), node));
    Directions<double> displaced = displaced_.view();
    displaced.count = directions.count;
    evaluate_point(shape, tangent_phi, partial, displaced, one_node_.data());
    for (std::size_t k = 0; k < used; ++k) rows_[k] += node.weight * one_node_[k];
  }
}

}  // namespace brdf::fit
