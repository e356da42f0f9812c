// Directions in the frame of a tilted surface.
#pragma once

#include "brdf/vec3.h"

namespace brdf {

// Returns a direction in the frame of a surface with this unit normal (normal.z > -1). The direction is
// rotated by the smallest rotation that takes the normal to +z (Rodrigues 1840).
template <class T>
constexpr Vec3<T> in_frame_of(const Vec3<T>& normal, const Vec3<T>& w) {
  const Vec3<T> middle{normal.x, normal.y, normal.z + T(1)};
  const T along = dot(middle, w) / middle.z;
  return {w.x - middle.x * along, w.y - middle.y * along, w.z - middle.z * along + T(2) * dot(normal, w)};
}

}  // namespace brdf
