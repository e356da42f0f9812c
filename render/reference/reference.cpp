#include "render/reference/reference.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "io/files/error.h"
#include "io/files/parallel.h"
#include "render/reference/environment_light.h"
#include "render/reference/surface_hit.h"
#include "render/scene/camera_view.h"
#include "render/scene/display_rule.h"
#include "render/scene/floor.h"
#include "render/scene/shadow_view.h"

namespace brdf::render {
namespace {

struct DeviceRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

// All objects as world-space triangles; geometry ids are object indices.
class SceneRays {
 public:
  explicit SceneRays(const PreparedScene& scene) : device_(rtcNewDevice(nullptr)) {
    if (!device_) throw EnvironmentError("Embree cannot be started");
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    for (std::size_t k = 0; k < scene.meshes.size(); ++k) add(*scene.meshes[k], scene.layers[0][k]);
    rtcCommitScene(scene_.get());
  }

  RTCRayHit trace(const glm::vec3& origin, const glm::vec3& direction, float from = 0) const {
    RTCRayHit hit{};
    hit.ray.tnear = from;
    hit.ray.org_x = origin.x;
    hit.ray.org_y = origin.y;
    hit.ray.org_z = origin.z;
    hit.ray.dir_x = direction.x;
    hit.ray.dir_y = direction.y;
    hit.ray.dir_z = direction.z;
    hit.ray.tfar = std::numeric_limits<float>::infinity();
    hit.ray.mask = ~0u;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_.get(), &context, &hit);
    return hit;
  }
  // Returns whether an object other than `own` lies along the direction. Hits on surfaces of `own` are
  // passed, each by `step`.
  bool blocked(const glm::vec3& origin, const glm::vec3& direction, std::size_t own, float step) const {
    for (float from = 0;;) {
      const RTCRayHit hit = trace(origin, direction, from);
      if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
      if (hit.hit.geomID != own) return true;
      from = hit.ray.tfar + step;
    }
  }

 private:
  void add(const Mesh& mesh, const Item& item) {
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.vertices.size()));
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      vertices[v] = item.origin + item.linear * mesh.vertices[v].position;
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles()));
    std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_.get(), geometry, unsigned(item.object));
    rtcReleaseGeometry(geometry);
  }

  std::unique_ptr<RTCDeviceTy, DeviceRelease> device_;
  std::unique_ptr<RTCSceneTy, SceneRelease> scene_;
};

struct Lit {
  glm::vec3 wi;          // unit, world
  glm::vec3 irradiance;  // on a surface that faces the light
};

Lit lit_by(const Light& light, const glm::vec3& position) {
  const glm::vec3 irradiance = light.color * light.intensity;
  if (!light.point) return {-glm::normalize(light.vector), irradiance};
  const glm::vec3 to_light = light.vector - position;
  const float d2 = glm::dot(to_light, to_light);
  return {to_light / std::sqrt(d2), irradiance / d2};
}

glm::vec3 backdrop(const Scene& scene, const glm::vec3& ray) {
  const glm::vec3 up = make_view(scene.camera).up;
  const float height = glm::dot(ray, up) / glm::dot(up, up);
  glm::vec3 color;
  for (int c = 0; c < 3; ++c)
    color[c] = backdrop_color(scene.background[c], (*scene.backdrop_top)[c], height);
  return color;
}

glm::vec3 sky(const PreparedScene& prepared, const glm::vec3& ray) {
  const Scene& scene = prepared.scene;
  if (prepared.environment && scene.environment->shown)
    return scene.environment->intensity * Floor(prepared).share(scene.camera.position, glm::normalize(ray)) *
           prepared.environment->shown(to_picture(*scene.environment) * glm::normalize(ray));
  if (!scene.sky_zenith) return scene.backdrop_top ? backdrop(scene, ray) : scene.background;
  const float up = glm::normalize(ray).y;
  glm::vec3 color;
  for (int c = 0; c < 3; ++c) color[c] = sky_color(scene.background[c], (*scene.sky_zenith)[c], up);
  return color;
}

// Decides whether an object blocks a light that casts a shadow.
class Shadow {
 public:
  Shadow(const PreparedScene& prepared, const SceneRays& rays) : rays_(rays) {
    if (const std::optional<std::size_t> light = shadow_light(prepared.scene)) light_ = *light;
    step_ = 1e-4f * prepared.bounds.w;
  }
  bool hides(std::size_t light, std::size_t from_object, const glm::vec3& position,
             const glm::vec3& to_light) const {
    return light == light_ && rays_.blocked(position, to_light, from_object, step_);
  }

 private:
  const SceneRays& rays_;
  std::size_t light_ = kMostLights;  // no light
  float step_;
};
// Returns the light of the environment, summed over the layers.
EnvironmentEstimate environment_at(const PreparedScene& prepared, const RTCRayHit& hit, const glm::vec3& ray,
                                   int x, int y, const ReferenceOptions& options) {
  EnvironmentEstimate sum;
  for (std::size_t k = 0; k < prepared.layers.size(); ++k) {
    const Item& item = prepared.layers[k][hit.hit.geomID];
    if (!item.form) continue;
    const SurfaceHit s = surface_at(prepared, item, hit.hit.primID, ray);
    if (!s.front) break;
    const glm::vec3 wo = to_local(glm::normalize(prepared.scene.camera.position - s.position), s);
    const auto starts =
        point_starts(std::uint32_t(x), std::uint32_t(y), options.seed + std::uint32_t(k) * 0x10000u);
    const EnvironmentEstimate e = environment_light(prepared, item, s, wo, starts, options.samples);
    sum.mean += e.mean;
    sum.variance += e.variance;
  }
  return sum;
}

// Returns the value, and whether all parts of the value are known.
MeasuredValue shade(const PreparedScene& prepared, const RTCRayHit& hit, const glm::vec3& ray,
                    const Shadow& shadow, const Measured* measured) {
  const Scene& scene = prepared.scene;
  MeasuredValue sum(glm::vec3(0));
  for (const auto& layer : prepared.layers) {
    const Item& item = layer[hit.hit.geomID];
    if (!item.form) continue;
    const SurfaceHit s = surface_at(prepared, item, hit.hit.primID, ray);
    if (!s.front) return scene.back_color;
    const glm::vec3 wo = to_local(glm::normalize(scene.camera.position - s.position), s);
    if (!measured) sum.f_cos += scene.ambient * s.diffuse;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
      const Lit lit = lit_by(scene.lights[k], s.position);
      const glm::vec3 wi = to_local(lit.wi, s);
      if (wi.z > 0 && shadow.hides(k, item.object, s.position, lit.wi)) continue;
      const MeasuredValue value =
          measured ? (*measured)(in_surface(wi, item), in_surface(wo, item)) : eval_cos_at(item, s, wi, wo);
      sum.f_cos += lit.irradiance * value.f_cos;
      sum.known = sum.known && value.known;
    }
    if (measured) break;
  }
  return sum;
}

// Calls visit(x, y, ray, hit, rays) for each pixel, with rows shared between threads.
template <class Visit>
void for_each_pixel(const PreparedScene& prepared, unsigned threads, Visit visit) {
  const Camera& camera = prepared.scene.camera;
  const View view = make_view(camera);
  const SceneRays rays(prepared);
  const auto row = [&](std::size_t y) {
    for (int x = 0; x < camera.width; ++x) {
      const glm::vec3 ray = view.ray(pixel_center(x, int(y), camera.width, camera.height));
      visit(x, int(y), ray, rays.trace(camera.position, ray), rays);
    }
  };
  io::parallel_for(std::size_t(camera.height), row, threads);
}

}  // namespace

Picture render_reference(const PreparedScene& prepared, const ReferenceOptions& options) {
  Picture picture(prepared.scene.camera.width, prepared.scene.camera.height);
  const bool environment = prepared.environment && !options.measured;
  if (options.standard_error) *options.standard_error = Picture(picture.width, picture.height);
  const auto visit = [&](int x, int y, const glm::vec3& ray, const RTCRayHit& hit, const SceneRays& rays) {
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
      picture.at(x, y) = glm::vec4(sky(prepared, ray), 0);
      return;
    }
    MeasuredValue value = shade(prepared, hit, ray, Shadow(prepared, rays), options.measured);
    if (environment) {
      const EnvironmentEstimate e = environment_at(prepared, hit, ray, x, y, options);
      value.f_cos += e.mean;
      if (options.standard_error) options.standard_error->at(x, y) = glm::vec4(glm::sqrt(e.variance), 1);
    }
    picture.at(x, y) = glm::vec4(value.f_cos, value.known ? 1 : kNotMeasured);
  };
  for_each_pixel(prepared, options.threads, visit);
  return picture;
}

std::vector<LitPoint> lit_points(const PreparedScene& prepared) {
  const Scene& scene = prepared.scene;
  std::vector<LitPoint> points;
  const auto visit = [&](int x, int y, const glm::vec3& ray, const RTCRayHit& hit, const SceneRays& rays) {
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    const Shadow shadow(prepared, rays);
    const Item& item = prepared.layers[0][hit.hit.geomID];
    const SurfaceHit s = surface_at(prepared, item, hit.hit.primID, ray);
    if (!s.front) return;
    const glm::vec3 wo = to_local(glm::normalize(scene.camera.position - s.position), s);
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
      const Lit lit = lit_by(scene.lights[k], s.position);
      const glm::vec3 wi = to_local(lit.wi, s);
      if (wi.z > 0 && wo.z > 0 && !shadow.hides(k, item.object, s.position, lit.wi))
        points.push_back({x, y, item.object, wi, wo, lit.irradiance});
    }
  };
  for_each_pixel(prepared, 1, visit);
  return points;
}

PixelProbe pixel_probe(const PreparedScene& prepared, int x, int y) {
  const Scene& scene = prepared.scene;
  const glm::vec3 ray =
      make_view(scene.camera).ray(pixel_center(x, y, scene.camera.width, scene.camera.height));
  const RTCRayHit hit = SceneRays(prepared).trace(scene.camera.position, ray);
  PixelProbe out;
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return out;
  out.hit = true;
  out.object = hit.hit.geomID;
  for (const auto& layer : prepared.layers) {
    const Item& item = layer[hit.hit.geomID];
    if (!item.form) continue;
    const SurfaceHit s = surface_at(prepared, item, hit.hit.primID, ray);
    out.position = s.position;
    out.normal = s.normal;
    out.wo = to_local(glm::normalize(scene.camera.position - s.position), s);
    if (scene.lights.empty()) return out;
    out.wi = to_local(lit_by(scene.lights[0], s.position).wi, s);
    if (out.wi.z > 0) out.value += eval_cos_at(item, s, out.wi, out.wo) / out.wi.z;
  }
  return out;
}

std::vector<std::string> lines(const PixelProbe& p) {
  if (!p.hit) return {"probe: background"};
  const auto angle = [](float cosine) {
    return radians(double(std::acos(glm::clamp(cosine, -1.0f, 1.0f)))).degrees();
  };
  const auto azimuth = [](const glm::vec3& w) { return radians(double(std::atan2(w.y, w.x))).degrees(); };
  const glm::vec3 h = glm::normalize(p.wi + p.wo);
  std::vector<std::string> out;
  const auto add = [&](const char* format, auto... values) {
    char text[160];
    std::snprintf(text, sizeof text, format, values...);
    out.emplace_back(text);
  };
  add("probe: object %d at (%.3f, %.3f, %.3f)", int(p.object) + 1, double(p.position.x), double(p.position.y),
      double(p.position.z));
  add("theta_i %.2f phi_i %.2f, theta_o %.2f phi_o %.2f deg", angle(p.wi.z), azimuth(p.wi), angle(p.wo.z),
      azimuth(p.wo));
  add("theta_h %.2f theta_d %.2f deg", angle(h.z), angle(glm::dot(p.wi, h)));
  add("f_r (%.5g, %.5g, %.5g) 1/sr", double(p.value.r), double(p.value.g), double(p.value.b));
  return out;
}

}  // namespace brdf::render
