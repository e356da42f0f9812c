// Directions as a tilted surface sees them.
#pragma once

#include "brdf/vec3.h"

namespace brdf {

// A direction in the frame of a surface of this unit normal (z > -1): turned by the smallest rotation that
// takes the normal to +z (Rodrigues 1840).
template <class T>
constexpr Vec3<T> in_frame_of(const Vec3<T>& normal, const Vec3<T>& w) {
  const Vec3<T> middle{normal.x, normal.y, normal.z + T(1)};
  const T along = dot(middle, w) / middle.z;
  return {w.x - middle.x * along, w.y - middle.y * along, w.z - middle.z * along + T(2) * dot(normal, w)};
}

}  // namespace brdf
