// Surfaces of revolution from profiles: curves in the plane (radius, height) whose points know their
// tangents, so that smooth parts are smooth and corners are corners.
#pragma once

#include <vector>

#include "render/mesh/mesh.h"

namespace brdf::render {

struct ProfilePoint {
  glm::vec2 at;       // distance from the axis, height
  glm::vec2 tangent;  // unit, in the direction of travel; the outside is to its right
};
using Profile = std::vector<ProfilePoint>;  // the same place twice: a corner

struct ProfileCorner {
  glm::vec2 at;
  float fillet = 0;  // radius of the arc that takes the corner's place; 0: sharp
};
// Straight lines through the corners. A fillet that does not fit between its neighbours is made smaller.
Profile filleted(const std::vector<ProfileCorner>& corners, int pieces = 8);
// An arc round `center` from one angle to another (radians from the outward direction, counter-clockwise).
Profile arc(glm::vec2 center, float radius, float from, float to, int pieces);
// The natural cubic spline through the points, with continuous curvature; `pieces` between two.
Profile spline(const std::vector<glm::vec2>& points, int pieces);
// One after another; a corner where their tangents differ.
Profile joined(const std::vector<Profile>& parts);

// The profile turned about the y axis; travelling upwards on the outside its normals point outwards. u runs
// round, v along.
Mesh lathe(const Profile& profile, int slices);

}  // namespace brdf::render
