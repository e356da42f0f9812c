// Triangle meshes: procedural shapes, text wrapped round a sphere, and models read by Assimp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace brdf::render {

struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec4 tangent;  // w: handedness, bitangent = w * cross(normal, tangent)
  glm::vec2 uv;       // v upwards
};

// The smallest box, along the axes, that holds points. Without a point, low exceeds high.
struct PointBox {
  glm::vec3 low{1e30f}, high{-1e30f};

  void add(const glm::vec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  glm::vec3 size() const { return high - low; }
  bool is_flat() const {
    const glm::vec3 s = size();
    return std::min({s.x, s.y, s.z}) < 1e-3f * std::max({s.x, s.y, s.z});
  }
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  // three per triangle, counter-clockwise seen from outside

  bool closed = false;  // the inside cannot be seen from outside

  std::size_t triangles() const { return indices.size() / 3; }
};

// Returns a unit sphere round the origin, with poles on the y axis and 2 * slices * (stacks - 1) triangles.
Mesh make_sphere(int slices, int stacks);
// Returns the sphere with the number of triangles nearest to `triangles`; kSphereTriangles is the default
// of "sphere".
Mesh make_sphere_of(int triangles);
inline constexpr int kSphereTriangles = 50176;
// Returns an icosahedron subdivided `levels` times: 20 * 4^levels triangles of nearly equal size.
Mesh make_icosphere(int levels);
// Returns the square [-1, 1]^2 in the xz plane facing +y, with cells x cells quads; u and v run over [0,
// cells]. Parity 0 or 1: only the even or the odd fields of a chessboard.
Mesh make_plane(int cells = 1, int parity = -1);
// Returns a car built from profiles: body, cabin, four wheels. The car is about 4 units long, rests on y =
// 0 and faces +x. "body", "cabin" or "wheels" selects one part, in its place.
Mesh make_car(std::string_view part = "");
// Returns the object that usually shows materials: a unit ball with a groove round it, on a base that ends
// at y = -1.28. "ball" or "stand" selects one part.
Mesh make_shader_ball(std::string_view part = "");
// Returns a hollow vase made by the lathe, 2.26 units high, resting on y = 0.
Mesh make_vase();
// Returns a square cloth, 4.2 units wide, that has fallen over a ball of radius 0.75 round the origin. The
// folds come from a mass and spring model at rest. The two sides are 0.008 apart.
Mesh make_cloth();
// Returns a sedan with fenders, windows, lamps and spoked wheels, 4.4 units long, resting on y = 0, facing
// +x. `part` selects one part, in its place: "body", "windows", "trim" (the dark parts: sills, arches,
// tyres), "metal" (rims), "lamps".
Mesh make_sedan(std::string_view part = "");
// Returns UTF-8 text as a mesh: outlines of the font, tessellated and wrapped round the unit sphere; u runs
// along the text. Throws InputError if the text contains nothing to draw or too many letters,
// EnvironmentError if the font cannot be read.
inline constexpr std::size_t kMostLetters = 200;
Mesh make_text_sphere(std::string_view text, const std::filesystem::path& font = {});
// Returns all meshes of the file, joined, with node transforms applied. Missing normals and tangents are
// computed; edges sharper than 40 degrees stay sharp. Throws InputError if the file is unreadable or empty
// or has vertices that are not finite.
Mesh load_model(const std::filesystem::path& file);

// Returns the mesh of a scene file's "mesh" entry. Permitted are sphere, sphere:N (triangles), icosphere:L,
// plane, plane:N, checker_even:N, checker_odd:N, car, car:PART, shader_ball, shader_ball:PART, vase, cloth,
// sedan, sedan:PART, text:..., FILE.
Mesh make_mesh(const std::string& specification, const std::filesystem::path& folder);

// Returns a unit vector perpendicular to `normal`, continuous except at one pole.
glm::vec3 any_tangent(const glm::vec3& normal);
// Computes tangents along u; vertices without usable texture coordinates get any_tangent().
void make_tangents(Mesh& mesh);
// Removes triangles without area (repeated vertices). Throws InputError with the name `source` if a vertex
// is not finite.
void clean(Mesh& mesh, const std::string& source);
// Returns the same triangles with one normal each and without shared vertices.
Mesh flat_shaded(const Mesh& mesh);
// Returns the least and the greatest coordinates of all vertices.
std::pair<glm::vec3, glm::vec3> bounding_box(const Mesh& mesh);
// Returns the smallest sphere round the bounding box of all vertices: centre and radius.
glm::vec4 bounding_sphere(const Mesh& mesh);
// Appends a copy of `part` with its vertices transformed.
void append(Mesh& mesh, const Mesh& part, const glm::mat4& transform = glm::mat4(1));

}  // namespace brdf::render
