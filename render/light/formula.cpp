#include "render/light/formula.h"

#include <algorithm>
#include <cmath>

#include "brdf/scalar.h"
#include "io/light/studio.h"

namespace brdf::render {
namespace {

constexpr glm::vec3 kZenith{0.55f, 0.85f, 1.6f}, kHorizon{1.0f, 1.0f, 1.0f};  // of mean 1: colour alone
constexpr float kGround = 0.3f;
const glm::vec3 kSun = glm::normalize(glm::vec3(-0.6f, 0.7f, 0.5f));  // the brightest direction of the sky

glm::vec3 studio(const glm::vec3& w) {
  const std::array<float, 3> light = io::studio::radiance(Vec3<float>{w.x, w.y, w.z});
  return {light[0], light[1], light[2]};
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
