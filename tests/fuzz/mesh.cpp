#include "render/mesh/mesh.h"

#include <cmath>

#include "tests/fuzz/fuzz.h"

namespace brdf::fuzz {
namespace {

// Assimp selects the format by the name first. Returns the suffix for the first bytes of the content.
std::string suffix_of(std::string_view input) {
  for (const auto& [magic, suffix] :
       {std::pair{"ply", ".ply"}, {"solid", ".stl"}, {"xof ", ".x"}, {"glTF", ".glb"}})
    if (input.starts_with(magic)) return suffix;
  return ".obj";
}

const Registered meshes("mesh", [](std::string_view input) {
  const render::Mesh mesh = render::load_model(as_file(input, suffix_of(input)));
  require(mesh.triangles() > 0 && mesh.indices.size() == 3 * mesh.triangles(), "a model has triangles");
  for (const std::uint32_t index : mesh.indices)
    require(index < mesh.vertices.size(), "corners are vertices");
  for (const render::Vertex& v : mesh.vertices) {
    require(std::isfinite(glm::dot(v.position, glm::vec3(1))), "positions are finite");
    require(std::abs(glm::length(v.normal) - 1) < 1e-3f, "normals have length 1");
    require(std::abs(glm::length(glm::vec3(v.tangent)) - 1) < 1e-3f && std::abs(v.tangent.w) == 1,
            "tangents have length 1 and a side");
    require(std::isfinite(v.uv.x) && std::isfinite(v.uv.y), "texture coordinates are finite");
  }
});

}  // namespace
}  // namespace brdf::fuzz
