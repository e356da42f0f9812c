#include "render/light/formula.h"

#include <algorithm>
#include <cmath>

#include "brdf/scalar.h"

namespace brdf::render {
namespace {

// A rectangular light: the direction of its centre, the tangents of half its angles across and upwards, and
// the share of these over which its edge fades.
struct SoftBox {
  glm::vec3 toward;
  glm::vec2 half;
  float edge;
  glm::vec3 radiance;
};

constexpr float kWallLow = 0.12f, kWallHigh = 0.4f;  // radiance of the wall, straight down and straight up
const SoftBox kBoxes[] = {
    {{-0.75f, 0.8f, 0.75f}, {0.5f, 0.5f}, 0.12f, {3.2f, 3.1f, 3.0f}},      // key light, upper left front
    {{1.0f, 0.15f, 0.45f}, {0.2f, 0.75f}, 0.15f, {1.5f, 1.6f, 1.75f}},     // a strip at the right
    {{0.35f, 0.75f, -0.85f}, {0.75f, 0.22f}, 0.15f, {2.0f, 2.0f, 2.0f}}};  // rim light, behind and above

constexpr glm::vec3 kZenith{0.55f, 0.85f, 1.6f}, kHorizon{1.0f, 1.0f, 1.0f};  // of mean 1: colour alone
constexpr float kGround = 0.3f;
const glm::vec3 kSun = glm::normalize(glm::vec3(-0.6f, 0.7f, 0.5f));  // the brightest direction of the sky

// Returns 1 inside and 0 outside, with a smooth transition over the edge.
float inside(float t, float edge) {
  return 1 - glm::smoothstep(1 - edge, 1 + edge, std::abs(t));
}

glm::vec3 studio(const glm::vec3& w) {
  glm::vec3 sum(glm::mix(kWallLow, kWallHigh, 0.5f + 0.5f * w.y));
  for (const SoftBox& box : kBoxes) {
    const glm::vec3 n = glm::normalize(box.toward);
    const float facing = glm::dot(w, n);
    if (facing <= 0) continue;
    const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), n)), y = glm::cross(n, x);
    const glm::vec2 place = glm::vec2(glm::dot(w, x), glm::dot(w, y)) / (facing * box.half);
    sum += box.radiance * (inside(place.x, box.edge) * inside(place.y, box.edge));
  }
  return sum;
}

// gradation() depends on the cosine of the angle from the zenith, indicatrix() on the angle from the sun.
float gradation(float up) {
  return 1 - std::exp(-0.32f / std::max(up, 1e-3f));
}
float indicatrix(float cosine) {
  const float angle = std::acos(glm::clamp(cosine, -1.0f, 1.0f));
  return 1 + 10 * (std::exp(-3 * angle) - std::exp(-3 * float(kPi) / 2)) + 0.45f * cosine * cosine;
}

glm::vec3 sky(const glm::vec3& w) {
  if (w.y < 0) return glm::vec3(kGround);
  const float relative = indicatrix(glm::dot(w, kSun)) * gradation(w.y) / (indicatrix(kSun.y) * gradation(1));
  return glm::mix(kHorizon, kZenith, std::sqrt(w.y)) * relative;
}

}  // namespace

glm::vec3 radiance_of(Formula formula, const glm::vec3& direction) {
  switch (formula) {
    case Formula::studio:
      return studio(direction);
    case Formula::sky:
      return sky(direction);
    case Formula::uniform:
      break;
  }
  return glm::vec3(1);
}

}  // namespace brdf::render
