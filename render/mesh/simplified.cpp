#include "render/mesh/simplified.h"

#include <algorithm>
#include <unordered_map>

namespace brdf::render {

Mesh simplified(const Mesh& mesh, int cells) {
  const auto [low, high] = bounding_box(mesh);
  const glm::vec3 size = high - low, start = low;
  const float cell = std::max({size.x, size.y, size.z}) / float(cells);
  const auto cell_of = [&](const Vertex& v) {
    const auto side = std::uint64_t(cells) + 1;
    const glm::vec3 at = (v.position - start) / cell;
    return (std::uint64_t(at.x) * side + std::uint64_t(at.y)) * side + std::uint64_t(at.z);
  };
  const auto octant_of = [](const glm::vec3& n) {
    return std::uint64_t(n.x > 0) | std::uint64_t(n.y > 0) << 1 | std::uint64_t(n.z > 0) << 2;
  };
  Mesh out;
  out.closed = mesh.closed;
  std::unordered_map<std::uint64_t, glm::vec3> places;      // by cell
  std::unordered_map<std::uint64_t, std::uint32_t> merged;  // by cell and octant
  std::vector<std::uint32_t> now;                           // number of each vertex
  for (const Vertex& v : mesh.vertices) {
    const std::uint64_t home = cell_of(v);
    const glm::vec3 place = places.try_emplace(home, v.position).first->second;
    const auto [found, is_new] =
        merged.try_emplace(8 * home + octant_of(v.normal), std::uint32_t(out.vertices.size()));
    if (is_new) {
      out.vertices.push_back(v);
      out.vertices.back().position = place;
    }
    now.push_back(found->second);
  }
  for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
    const std::uint32_t a = now[mesh.indices[k]], b = now[mesh.indices[k + 1]], c = now[mesh.indices[k + 2]];
    const glm::vec3 &p = out.vertices[a].position, &q = out.vertices[b].position,
                    &r = out.vertices[c].position;
    if (p != q && q != r && r != p) out.indices.insert(out.indices.end(), {a, b, c});
  }
  return out.indices.empty() ? mesh : out;
}

}  // namespace brdf::render
