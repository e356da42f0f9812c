#include "render/reference/environment_light.h"

#include <cmath>

#include "render/scene/floor.h"

namespace brdf::render {
namespace {

// The directions of a run, with their radiance over the density with which they were drawn.
class Run {
 public:
  Run(const PreparedScene& scene, const Item& item, const SurfaceHit& surface, const glm::vec3& wo)
      : map_(*scene.environment),
        form_(*item.form),
        shape_(surface.shape.begin(), surface.shape.end()),
        to_picture_(to_picture(*scene.scene.environment)),
        frame_(surface.tangent, surface.bitangent, surface.normal),
        wo_{wo.x, wo.y, wo.z},
        floor_(scene),
        position_(surface.position) {}

  void draw(const std::array<double, kPointDimensions>& u) {
    const LightSample light = map_.sample(u[0], u[1]);
    add((light.direction * to_picture_) * frame_, light.radiance, light.density);
    const Vec3<double> wo{double(wo_.x), double(wo_.y), double(wo_.z)};
    const Vec3<double> own = form_->sample(shape_, u[2], u[3], u[4], wo);
    const glm::vec3 wi{float(own.x), float(own.y), float(own.z)};
    const glm::vec4 texel = map_.texel_towards(to_picture_ * (frame_ * wi));
    add(wi, glm::vec3(texel), texel.a);
  }

  // Returns the sum over the directions drawn since the last call.
  glm::vec3 lit(const Item& item, const SurfaceHit& surface) {
    glm::vec3 sum(0);
    const Directions<float> d = pairs_.view().part(0, count_);
    for (std::size_t c = 0; c < 3; ++c) {
      form_->eval_cos({surface.weights[c], surface.weights[0], surface.shape, item.channels[c]}, d,
                      values_.data());
      for (std::size_t k = 0; k < count_; ++k) sum[int(c)] += values_[k] * weighted_[k][int(c)];
    }
    count_ = 0;
    return sum;
  }

 private:
  void add(const glm::vec3& wi, const glm::vec3& radiance, float light_density) {
    if (wi.z <= 0) return;
    const Vec3<double> i{double(wi.x), double(wi.y), double(wi.z)},
        o{double(wo_.x), double(wo_.y), double(wo_.z)};
    const auto density = float(form_->pdf(shape_, i, o)) + light_density;
    if (!(density > 0)) return;
    pairs_.set(count_, {wi.x, wi.y, wi.z}, wo_);
    weighted_[count_++] = radiance * (floor_.share(position_, frame_ * wi) / density);
  }

  const LightMap& map_;
  const Reflectance& form_;
  std::vector<double> shape_;
  glm::mat3 to_picture_, frame_;
  Vec3<float> wo_;
  Floor floor_;
  glm::vec3 position_;
  DirectionArrays<float> pairs_{2 * kRun};
  std::array<glm::vec3, 2 * kRun> weighted_;
  std::array<float, 2 * kRun> values_;
  std::size_t count_ = 0;
};

}  // namespace

EnvironmentEstimate environment_light(const PreparedScene& scene, const Item& item, const SurfaceHit& surface,
                                      const glm::vec3& wo, const std::array<double, kPointDimensions>& starts,
                                      int samples) {
  Run run(scene, item, surface, wo);
  const int runs = (samples + kRun - 1) / kRun;
  glm::dvec3 sum(0), squares(0);
  for (int r = 0; r < runs; ++r) {
    for (int k = 0; k < kRun; ++k) run.draw(point(starts, std::uint64_t(r) * kRun + std::uint64_t(k)));
    const glm::dvec3 mean = glm::dvec3(run.lit(item, surface)) / double(kRun);
    sum += mean;
    squares += mean * mean;
  }
  const double n = runs, intensity = double(scene.scene.environment->intensity);
  const glm::dvec3 mean = sum / n;
  const glm::dvec3 scatter = glm::max(squares / n - mean * mean, glm::dvec3(0));
  return {glm::vec3(mean * intensity),
          n > 1 ? glm::vec3(scatter / (n - 1) * intensity * intensity) : glm::vec3(0)};
}

}  // namespace brdf::render
