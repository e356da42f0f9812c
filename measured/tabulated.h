// The ratio of measured samples kept on a lattice, for pictures.
#pragma once

#include <atomic>
#include <memory>

#include "measured/measured.h"

namespace brdf::measured {

// Answers as the reflectance does, within about 1 % (as much as its moving neighbourhood leaves open): the
// ratio at the nodes of a lattice, 16 to a length of r, 8 to the others, linear between. A node is computed
// when it is first asked for, so that a picture pays for the directions that it holds, and the next one
// hardly at all. Several threads may ask at once. Where the samples were turned, or the lattice would have
// too many nodes, every answer is computed anew.
class Tabulated {
 public:
  explicit Tabulated(std::shared_ptr<const MeasuredReflectance> measured);
  Seen at(const Vec3<double>& wi, const Vec3<double>& wo) const;
  const MeasuredReflectance& reflectance() const { return *measured_; }

 private:
  struct Axis {
    double from = 0, step = 1;
    std::size_t nodes = 1;
  };
  std::size_t node_at(std::size_t i, std::size_t j, std::size_t k) const;  // computed

  std::shared_ptr<const MeasuredReflectance> measured_;
  std::array<Axis, 3> axes_;
  std::size_t per_node_ = 0;  // a ratio per channel, and what is known; 0: no lattice
  std::unique_ptr<std::atomic<float>[]> values_;
  std::unique_ptr<std::atomic<bool>[]> ready_;
};

}  // namespace brdf::measured
