#include "measured/tabulated.h"

#include <algorithm>

namespace brdf::measured {
namespace {

constexpr std::array kNodesPerLength{16.0, 8.0, 8.0};  // the core of a lobe is narrow
constexpr std::size_t kMostNodes = 3'000'000;

}  // namespace

Tabulated::Tabulated(std::shared_ptr<const MeasuredReflectance> measured) : measured_(std::move(measured)) {
  if (measured_->turning() == Turning::turned) return;
  const double widest = place_of({1, 0, 0}, {1, 0, 0}, Turning::isotropic, measured_->core())[0];
  const std::array<double, 3> from{0, 0, -1}, to{widest, kPi / 2, 1};
  double nodes = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double step = measured_->variation().lengths[k] / kNodesPerLength[k];
    axes_[k] = {from[k], step, std::size_t((to[k] - from[k]) / step) + 2};
    nodes *= double(axes_[k].nodes);
  }
  if (nodes > double(kMostNodes)) return;
  per_node_ = measured_->channels().size() + 1;
  values_ = std::make_unique<std::atomic<float>[]>(std::size_t(nodes) * per_node_);
  ready_ = std::make_unique<std::atomic<bool>[]>(std::size_t(nodes));
}

std::size_t Tabulated::node_at(std::size_t i, std::size_t j, std::size_t k) const {
  const std::size_t node = (i * axes_[1].nodes + j) * axes_[2].nodes + k;
  if (ready_[node].load(std::memory_order_acquire)) return node * per_node_;
  const auto along = [&](std::size_t axis, std::size_t n) {
    return axes_[axis].from + double(n) * axes_[axis].step;
  };
  const Ratio ratio = measured_->ratio_at({along(0, i), along(1, j), along(2, k), 0});
  // Two threads may do this at the same time; both write the same values.
  for (std::size_t c = 0; c + 1 < per_node_; ++c)
    values_[node * per_node_ + c].store(float(ratio.of[c]), std::memory_order_relaxed);
  values_[node * per_node_ + per_node_ - 1].store(float(ratio.known), std::memory_order_relaxed);
  ready_[node].store(true, std::memory_order_release);
  return node * per_node_;
}

Seen Tabulated::at(const Vec3<double>& wi, const Vec3<double>& wo) const {
  if (per_node_ == 0 || !(wi.z > 0 && wo.z > 0)) return measured_->at(wi, wo);
  const Place place = measured_->place(wi, wo);
  std::array<std::size_t, 3> node{};
  std::array<double, 3> share{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = (place[k] - axes_[k].from) / axes_[k].step;
    node[k] = std::min(std::size_t(std::max(along, 0.0)), axes_[k].nodes - 2);
    share[k] = std::clamp(along - double(node[k]), 0.0, 1.0);
  }
  Ratio ratio;
  ratio.of.assign(per_node_ - 1, 0);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::array<std::size_t, 3> at = node;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool upper = corner >> k & 1;
      weight *= upper ? share[k] : 1 - share[k];
      at[k] += upper;
    }
    if (weight == 0) continue;
    const std::size_t first = node_at(at[0], at[1], at[2]);
    for (std::size_t c = 0; c + 1 < per_node_; ++c)
      ratio.of[c] += weight * double(values_[first + c].load(std::memory_order_relaxed));
    ratio.known += weight * double(values_[first + per_node_ - 1].load(std::memory_order_relaxed));
  }
  return measured_->seen(wi, wo, ratio);
}

}  // namespace brdf::measured
