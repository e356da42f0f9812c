// Pairs of directions, stored as one array per coordinate.
#pragma once

#include <cstddef>
#include <vector>

#include "brdf/angle.h"
#include "brdf/vec3.h"

namespace brdf {

// `count` pairs of unit directions: wi points to the light, wo to the viewer.
template <class T>
struct Directions {
  const T *wi_x, *wi_y, *wi_z;
  const T *wo_x, *wo_y, *wo_z;
  std::size_t count;

  Vec3<T> wi(std::size_t i) const { return {wi_x[i], wi_y[i], wi_z[i]}; }
  Vec3<T> wo(std::size_t i) const { return {wo_x[i], wo_y[i], wo_z[i]}; }
  // Returns `size` pairs, starting with pair `first`.
  Directions part(std::size_t first, std::size_t size) const {
    return {wi_x + first, wi_y + first, wi_z + first, wo_x + first, wo_y + first, wo_z + first, size};
  }
};

// Arrays that own the coordinates of the directions.
template <class T>
class DirectionArrays {
 public:
  explicit DirectionArrays(std::size_t count) : values_(6 * count), count_(count) {}
  std::size_t size() const { return count_; }
  void set(std::size_t i, const Vec3<T>& wi, const Vec3<T>& wo) {
    const T coordinates[] = {wi.x, wi.y, wi.z, wo.x, wo.y, wo.z};
    for (std::size_t k = 0; k < 6; ++k) values_[k * count_ + i] = coordinates[k];
  }
  Directions<T> view() const {
    const T* p = values_.data();
    return {p, p + count_, p + 2 * count_, p + 3 * count_, p + 4 * count_, p + 5 * count_, count_};
  }

 private:
  std::vector<T> values_;
  std::size_t count_;
};

// Returns a view of a single pair. The vectors must outlive the view.
template <class T>
Directions<T> one_pair(const Vec3<T>& wi, const Vec3<T>& wo) {
  return {&wi.x, &wi.y, &wi.z, &wo.x, &wo.y, &wo.z, 1};
}

// Returns the unit vector with this polar angle and azimuth.
// Example:
//     brdf::DirectionArrays<double> arrays(1);
//     arrays.set(0, direction(brdf::degrees(30), brdf::degrees(0)),
//                direction(brdf::degrees(45), brdf::degrees(180)));
//     const brdf::Vec3<double> to_viewer = arrays.view().wo(0);
Vec3<double> direction(Angle theta, Angle phi);

// Writes the directions as seen from a frame with its tangent rotated by phi.
void turn_batch(const Directions<double>& directions, Angle phi, DirectionArrays<double>& out);

}  // namespace brdf
