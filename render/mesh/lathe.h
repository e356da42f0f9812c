// Surfaces of revolution from profiles. The points of a profile, a curve in the plane (radius, height),
// store their tangents, which keeps smooth parts smooth and corners sharp.
#pragma once

#include <vector>

#include "render/mesh/mesh.h"

namespace brdf::render {

struct ProfilePoint {
  glm::vec2 at;       // distance from the axis, height
  glm::vec2 tangent;  // unit, in the direction of travel; the outside is on the right
};
using Profile = std::vector<ProfilePoint>;  // a corner is the same place twice

struct ProfileCorner {
  glm::vec2 at;
  // Radius of the arc that replaces the corner; 0: sharp.
  float fillet = 0;
};
// Returns straight lines through the corners. A fillet that does not fit between its neighbours is made
// smaller.
Profile filleted(const std::vector<ProfileCorner>& corners, int pieces = 8);
// Returns an arc round `center` from one angle to another (radians from the outward direction,
// counter-clockwise).
Profile arc(glm::vec2 center, float radius, float from, float to, int pieces);
// Returns the natural cubic spline through the points, with continuous curvature and `pieces` pieces
// between two points.
Profile spline(const std::vector<glm::vec2>& points, int pieces);
// Returns the profiles one after another, with a corner at each joint where the tangents differ.
Profile joined(const std::vector<Profile>& parts);

// Returns the profile turned about the y axis. If the profile runs upwards on the outside, the normals
// point outwards. u runs round the axis, v along the profile.
Mesh lathe(const Profile& profile, int slices);

}  // namespace brdf::render
