// The floor of an environment: the light that reaches it next to the objects. shaders/light.glsl has the same
// as floor_share.
#pragma once

#include "io/light/studio.h"
#include "render/scene/prepared.h"

namespace brdf::render {

class Floor {
 public:
  // `scene` must outlive this object.
  explicit Floor(const PreparedScene& scene) : scene_(&scene) {
    if (scene.scene.environment) height_ = scene.scene.environment->floor;
  }

  // Returns the share of the environment's radiance from the direction w (a unit vector of the world) that
  // reaches the point p. Without a floor, and above the horizon, this is 1. The objects are taken as balls
  // around their origins.
  float share(const glm::vec3& p, const glm::vec3& w) const {
    if (!height_ || w.y >= 0) return 1;
    const glm::vec3 place = p + w * (std::max(p.y - *height_, 0.0f) / std::max(-w.y, 1e-4f));
    float share = 1;
    for (const Item& item : scene_->layers[0]) {
      const float x = place.x - item.origin.x, z = place.z - item.origin.z;
      share *= io::studio::light_beside_ball(std::max(item.origin.y - *height_, item.extent), item.extent,
                                             x * x + z * z);
    }
    return share;
  }

 private:
  const PreparedScene* scene_;
  std::optional<float> height_;
};

}  // namespace brdf::render
