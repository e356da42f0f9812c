#include "render/reference/surface_hit.h"

#include <algorithm>

namespace brdf::render {
namespace {

glm::vec3 diffuse_of(const SurfaceHit& s, int weight) {
  if (weight < 0) return glm::vec3(0);
  const auto k = std::size_t(weight);
  return {s.weights[0][k], s.weights[1][k], s.weights[2][k]};
}

// Turns the frame to another normal and keeps the handedness.
void turn_to(const glm::vec3& n, SurfaceHit& s) {
  const float hand = glm::dot(glm::cross(s.normal, s.tangent), s.bitangent) < 0 ? -1.0f : 1.0f;
  s.tangent = glm::normalize(s.tangent - n * glm::dot(n, s.tangent));
  s.bitangent = glm::cross(n, s.tangent) * hand;
  s.normal = n;
}

glm::vec3 bent_back(const glm::vec3& n, const glm::vec3& v, double least) {
  return glm::normalize(n + v * std::max(float(least) - glm::dot(n, v), 0.0f));
}

void apply_maps(const TextureSet& maps, const Item& item, glm::vec2 uv, const glm::vec3& ray, SurfaceHit& s) {
  const auto map = [&](TextureSlot slot) { return maps[std::size_t(slot)].get(); };
  const auto grey = [&](TextureSlot slot) { return map(slot) ? map(slot)->sample(uv).r : 0; };
  glm::vec3 albedo = s.diffuse;
  if (map(TextureSlot::albedo)) albedo = map(TextureSlot::albedo)->sample_srgb(uv);
  const float roughness = grey(TextureSlot::roughness), metallic = grey(TextureSlot::metallic);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < s.weights[c].size(); ++k)
      s.weights[c][k] = driven(item.weight_rules[k], s.weights[c][k], albedo[int(c)], roughness, metallic);
  for (std::size_t k = 0; k < s.shape.size(); ++k)
    s.shape[k] = driven(item.shape_rules[k], s.shape[k], 0.0f, roughness, metallic);
  if (const Texture* normals = map(TextureSlot::normal)) {
    const glm::vec3 m = glm::vec3(normals->sample(uv)) * 2.0f - 1.0f;
    const glm::vec3 n = glm::normalize(s.tangent * m.x + s.bitangent * m.y + s.normal * m.z);
    turn_to(bent_back(n, -glm::normalize(ray), kLeastFacing), s);
  }
}

// Returns the weights of the corners at the intersection of the camera's ray with the triangle's plane
// (Moeller and Trumbore 1997).
std::array<float, 3> barycentric(const PreparedScene& scene, const Item& item,
                                 const std::array<glm::vec3, 3>& corners, const glm::vec3& ray) {
  std::array<glm::dvec3, 3> p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = glm::dvec3(item.origin) + glm::dmat3(item.linear) * glm::dvec3(corners[k]);
  const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0], d(ray);
  const glm::dvec3 s = glm::dvec3(scene.scene.camera.position) - p[0];
  const glm::dvec3 across = glm::cross(d, e2), q = glm::cross(s, e1);
  const double scale = 1 / glm::dot(e1, across);
  const double u = glm::dot(s, across) * scale, v = glm::dot(d, q) * scale;
  return {float(1 - u - v), float(u), float(v)};
}

}  // namespace

SurfaceHit surface_at(const PreparedScene& scene, const Item& item, std::uint32_t triangle,
                      const glm::vec3& ray) {
  const Mesh& mesh = *scene.meshes[item.object];
  const Vertex& a = mesh.vertices[mesh.indices[3 * triangle]];
  const Vertex& b = mesh.vertices[mesh.indices[3 * triangle + 1]];
  const Vertex& c = mesh.vertices[mesh.indices[3 * triangle + 2]];
  const auto [w, u, v] = barycentric(scene, item, {a.position, b.position, c.position}, ray);
  SurfaceHit s;
  s.weights = item.weights;
  s.shape = item.shape;
  const int diffuse = item.form->info().weight_index(Role::diffuse);
  s.diffuse = diffuse_of(s, diffuse);
  const glm::vec3 relative = item.linear * (a.position * w + b.position * u + c.position * v);
  s.position = item.origin + relative;
  // Counter-clockwise seen from the front, also under a mirroring transform, as in the rasteriser.
  const glm::vec3 face =
      glm::cross(item.linear * (b.position - a.position), item.linear * (c.position - a.position));
  s.front = glm::dot(face, ray) < 0;
  s.normal = glm::normalize(item.normals * (a.normal * w + b.normal * u + c.normal * v));
  const glm::vec4 tangent = a.tangent * w + b.tangent * u + c.tangent * v;
  const glm::vec3 t = item.linear * glm::vec3(tangent);
  s.tangent = glm::normalize(t - s.normal * glm::dot(s.normal, t));
  s.bitangent = glm::cross(s.normal, s.tangent) * (tangent.w < 0 ? -1.0f : 1.0f);
  const TextureSet& maps = scene.textures[item.object];
  if (std::ranges::any_of(maps, [](const auto& map) { return bool(map); })) {
    apply_maps(maps, item, a.uv * w + b.uv * u + c.uv * v, ray, s);
    s.diffuse = diffuse_of(s, diffuse);
  }
  const glm::vec3 viewer = -glm::normalize(ray);
  if (s.front && glm::dot(s.normal, viewer) < float(kLeastSeen))
    turn_to(bent_back(s.normal, viewer, kLeastSeen), s);
  const glm::vec3 turned = s.tangent * item.cos_turn + s.bitangent * item.sin_turn;
  s.bitangent = s.bitangent * item.cos_turn - s.tangent * item.sin_turn;
  s.tangent = turned;
  return s;
}

glm::vec3 eval_cos_at(const Item& item, const SurfaceHit& s, const glm::vec3& wi, const glm::vec3& wo) {
  const Vec3<float> i{wi.x, wi.y, wi.z}, o{wo.x, wo.y, wo.z};
  glm::vec3 out;
  for (std::size_t c = 0; c < 3; ++c) {
    const ParameterValues<float> p{s.weights[c], s.weights[0], s.shape, item.channels[c]};
    (*item.form)->eval_cos(p, one_pair(i, o), &out[int(c)]);
  }
  return out;
}

}  // namespace brdf::render
