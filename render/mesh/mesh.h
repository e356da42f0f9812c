// Triangle meshes: shapes made here, text wrapped round a sphere, and models that Assimp reads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::render {

struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec4 tangent;  // w: handedness, bitangent = w * cross(normal, tangent)
  glm::vec2 uv;       // v upwards
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  // three per triangle, counter-clockwise seen from outside

  bool closed = false;  // no inside can be seen from outside

  std::size_t triangles() const { return indices.size() / 3; }
};

// Unit sphere round the origin, poles on the y axis, 2 * slices * (stacks - 1) triangles.
Mesh make_sphere(int slices, int stacks);
// The sphere with the triangle count next to `triangles`; 50,176 where the caller has no wish.
Mesh make_sphere_of(int triangles);
inline constexpr int kSphereTriangles = 50176;
// Icosahedron subdivided `levels` times: 20 * 4^levels triangles of nearly equal size.
Mesh make_icosphere(int levels);
// Square [-1, 1]^2 in the xz plane facing +y, cells x cells quads; u and v run over [0, cells]. Parity 0 or
// 1: only the even or the odd fields of a chessboard.
Mesh make_plane(int cells = 1, int parity = -1);
// A model built from profiles: body, cabin, four wheels; about 4 units long, standing on y = 0, facing +x.
// "body", "cabin" or "wheels": that part alone, in its place.
Mesh make_car(std::string_view part = "");
// What materials are shown on: a unit ball with a groove round it, on a stand that ends at y = -1.28. "ball"
// or "stand": that part alone.
Mesh make_shader_ball(std::string_view part = "");
// A vase off the lathe, 2.26 units high, standing on y = 0, hollow.
Mesh make_vase();
// A square cloth that has fallen over a ball of radius 0.75 round the origin, 4.2 units wide: the folds are
// those of a mass and spring model at rest. Both sides, 0.008 apart.
Mesh make_cloth();
// A sedan with fenders, windows, lamps and spoked wheels, 4.4 units long, standing on y = 0, facing +x. A
// part alone, in its place: "body", "windows", "trim" (what is dark: sills, arches, tyres), "metal" (rims),
// "lamps".
Mesh make_sedan(std::string_view part = "");
// UTF-8 text, outlines of the font tessellated and wrapped round the unit sphere; u runs along the text.
// Throws InputError when the text holds nothing to draw or too many letters, EnvironmentError when the font
// cannot be read.
inline constexpr std::size_t kMostLetters = 200;
Mesh make_text_sphere(std::string_view text, const std::filesystem::path& font = {});
// Every mesh of the file, joined, node transforms applied. Throws InputError (unreadable, empty, or
// non-finite vertices). Normals and tangents that the file lacks are made; edges sharper than 40 degrees stay
// edges.
Mesh load_model(const std::filesystem::path& file);

// What a scene file's "mesh" may say: sphere, sphere:N (triangles), icosphere:L, plane, plane:N,
// checker_even:N, checker_odd:N, car, car:PART, shader_ball, shader_ball:PART, vase, cloth, sedan,
// sedan:PART, text:..., FILE.
Mesh make_mesh(const std::string& specification, const std::filesystem::path& folder);

// A unit vector perpendicular to `normal`, continuous but at one pole.
glm::vec3 any_tangent(const glm::vec3& normal);
// Tangents along u; vertices without usable texture coordinates get any_tangent.
void make_tangents(Mesh& mesh);
// Drops triangles without area (repeated vertices). Throws
// InputError on a vertex that is not finite; `source` names it.
void clean(Mesh& mesh, const std::string& source);
// The same triangles with one normal each, no vertex shared.
Mesh flat_shaded(const Mesh& mesh);
// Smallest sphere round the box of all vertices: centre and radius.
glm::vec4 bounding_sphere(const Mesh& mesh);
void append(Mesh& mesh, const Mesh& part, const glm::mat4& transform = glm::mat4(1));

}  // namespace brdf::render
