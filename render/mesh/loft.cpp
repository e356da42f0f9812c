#include "render/mesh/loft.h"

#include <glm/gtc/matrix_transform.hpp>

namespace brdf::render {

using glm::vec3;

Mesh loft(const Surface& at, const std::vector<float>& us, const std::vector<float>& vs, float outwards,
          const std::function<bool(float u, float v)>& kept) {
  constexpr float kStep = 2e-3f;
  Mesh mesh;
  for (const float u : us) {
    for (const float v : vs) {
      const vec3 along_u = at(u + kStep, v) - at(u - kStep, v), along_v = at(u, v + kStep) - at(u, v - kStep);
      const vec3 normal = glm::cross(along_u, along_v) * outwards;
      const float length = glm::length(normal);
      mesh.vertices.push_back({at(u, v), length > 0 ? normal / length : vec3(0, 1, 0), {1, 0, 0, 1}, {u, v}});
    }
  }
  const auto row = std::uint32_t(vs.size());
  for (std::uint32_t i = 0; i + 1 < us.size(); ++i) {
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      if (kept && !kept((us[i] + us[i + 1]) / 2, (vs[j] + vs[j + 1]) / 2)) continue;
      const std::uint32_t a = i * row + j, b = a + row, c = a + 1, d = b + 1;
      if (outwards > 0) mesh.indices.insert(mesh.indices.end(), {a, b, c, b, d, c});
      if (outwards < 0) mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
    }
  }
  return mesh;
}

std::vector<float> divided(const std::vector<float>& borders, const std::vector<int>& pieces) {
  std::vector<float> out{borders[0]};
  for (std::size_t k = 0; k + 1 < borders.size(); ++k)
    for (int i = 1; i <= pieces[k]; ++i)
      out.push_back(glm::mix(borders[k], borders[k + 1], float(i) / float(pieces[k])));
  return out;
}

Mesh mirrored(const Mesh& half) {
  Mesh both = half;
  append(both, half, glm::scale(glm::mat4(1), {1, 1, -1}));
  return both;
}

Mesh placed(const Mesh& mesh, vec3 at, vec3 scale, float turn_y) {
  glm::mat4 m = glm::translate(glm::mat4(1), at);
  m = glm::rotate(m, glm::radians(turn_y), {0, 1, 0});
  Mesh out;
  append(out, mesh, glm::scale(m, scale));
  return out;
}

}  // namespace brdf::render
