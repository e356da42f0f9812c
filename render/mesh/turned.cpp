// Shapes made by the lathe: a vase, and the ball that shows materials.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "brdf/scalar.h"
#include "render/mesh/lathe.h"
#include "render/mesh/mesh.h"

namespace brdf::render {
namespace {

constexpr int kSlices = 192;

float radians_of(double degrees) {
  return float(degrees * kPi / 180);
}

// A ball with a groove round it and rounded lips, and the core that is visible in the groove.
Mesh grooved_ball() {
  // Degrees of latitude at which the lips and the floor of the groove end.
  constexpr double kLip = 9, kFloor = 7;
  constexpr float kCore = 0.88f;
  const auto on = [](double latitude, float radius) {
    return radius * glm::vec2(std::cos(radians_of(latitude)), std::sin(radians_of(latitude)));
  };
  const auto sphere = [](double from, double to) {
    return arc({0, 0}, 1, radians_of(from), radians_of(to), 72);
  };
  // Each lip bends from the sphere's tangent into the wall of the groove, and again onto the floor.
  const auto lip = [&](double sign) {
    std::vector<ProfileCorner> corners{{on(sign * (kLip + 1.5), 1)},
                                       {on(sign * kLip, 1.0005f), 0.022f},
                                       {on(sign * kFloor, kCore), 0.022f},
                                       {on(sign * (kFloor - 2), kCore)}};
    if (sign > 0) std::ranges::reverse(corners);
    return filleted(corners, 10);
  };
  const Profile core = arc({0, 0}, kCore, radians_of(-kFloor + 2), radians_of(kFloor - 2), 12);
  return lathe(joined({sphere(-90, -kLip - 1.5), lip(-1), core, lip(1), sphere(kLip + 1.5, 90)}), kSlices);
}

// A foot with a hollow that holds the ball.
Mesh stand() {
  const Profile foot = filleted({{{0, -1.28f}},
                                 {{0.84f, -1.28f}, 0.03f},
                                 {{0.84f, -1.19f}, 0.03f},
                                 {{0.62f, -1.15f}, 0.12f},
                                 {{0.46f, -0.93f}, 0.012f},
                                 {{0.41f, -0.93f}, 0.012f},
                                 {{0.36f, -1.0f}, 0.05f},
                                 {{0, -1.0f}}},
                                12);
  return lathe(foot, kSlices);
}

}  // namespace

Mesh make_shader_ball(std::string_view part) {
  // The groove leans towards the viewer, who sees it from the front and from the side.
  const glm::mat4 lean =
      glm::rotate(glm::rotate(glm::mat4(1), radians_of(-24), {0, 0, 1}), radians_of(28), {1, 0, 0});
  Mesh mesh;
  if (part != "stand") append(mesh, grooved_ball(), lean);
  if (part != "ball") append(mesh, stand());
  mesh.closed = true;
  return mesh;
}

Mesh make_vase() {
  const Profile outside = spline({{0.40f, 0.06f},
                                  {0.50f, 0.22f},
                                  {0.72f, 0.62f},
                                  {0.78f, 1.0f},
                                  {0.62f, 1.42f},
                                  {0.36f, 1.72f},
                                  {0.29f, 1.92f},
                                  {0.33f, 2.10f},
                                  {0.47f, 2.24f}},
                                 16);
  const Profile inside = spline({{0.43f, 2.25f},
                                 {0.29f, 2.12f},
                                 {0.25f, 1.92f},
                                 {0.32f, 1.72f},
                                 {0.57f, 1.42f},
                                 {0.72f, 1.0f},
                                 {0.66f, 0.62f},
                                 {0.45f, 0.24f},
                                 {0.0f, 0.16f}},
                                16);
  const Profile foot = filleted({{{0, 0}}, {{0.46f, 0}, 0.02f}, {{0.46f, 0.06f}, 0.02f}, {{0.40f, 0.06f}}});
  const Profile lip = filleted({{outside.back().at},
                                {outside.back().at + 0.028f * glm::vec2(0.7f, 0.95f), 0.02f},
                                {inside.front().at + 0.028f * glm::vec2(-0.1f, 1.2f), 0.02f},
                                {inside.front().at}});
  Mesh mesh = lathe(joined({foot, outside, lip, inside}), kSlices);
  mesh.closed = true;
  return mesh;
}

}  // namespace brdf::render
