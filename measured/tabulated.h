// Tabulates the ratio of measured samples on a lattice, for pictures.
#pragma once

#include <atomic>
#include <memory>

#include "measured/measured.h"

namespace brdf::measured {

// Returns the values of the reflectance to within about 1 %, which is also the uncertainty due to its
// moving neighbourhood. The ratio is tabulated at the nodes of a lattice, with 16 nodes to a length of r
// and 8 nodes to the other lengths, and interpolated linearly. A node is computed on its first use, so a
// picture costs only the directions that it contains, and the next picture costs almost nothing.
// Thread-safe. If the sample was rotated, or if the lattice would have too many nodes, every value is
// computed anew.
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
  std::size_t node_at(std::size_t i, std::size_t j, std::size_t k) const;  // computes the node if necessary

  std::shared_ptr<const MeasuredReflectance> measured_;
  std::array<Axis, 3> axes_;
  std::size_t per_node_ = 0;  // a ratio per channel, and `known`; 0: no lattice
  std::unique_ptr<std::atomic<float>[]> values_;
  std::unique_ptr<std::atomic<bool>[]> ready_;
};

}  // namespace brdf::measured
