#include "render/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "brdf/scalar.h"
#include "io/files/error.h"

namespace brdf::render {
namespace {

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Returns the number after "name:". Throws InputError if it is not an integer in [low, high].
int count_of(const std::string& specification, std::size_t colon, int low, int high) {
  int value = 0;
  const char* end = specification.data() + specification.size();
  const auto [stop, error] = std::from_chars(specification.data() + colon + 1, end, value);
  if (error != std::errc() || stop != end || value < low || value > high) {
    throw InputError("mesh \"" + specification + "\": the number must be an integer from " +
                     std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

Vertex sphere_vertex(const glm::vec3& n) {
  const auto pi = float(kPi);
  const float azimuth = std::atan2(-n.z, n.x);
  const float ring = std::hypot(n.x, n.z);
  const glm::vec3 tangent = ring > 1e-6f ? glm::vec3(n.z, 0, -n.x) / ring : any_tangent(n);
  return {n,
          n,
          glm::vec4(tangent, 1),
          {azimuth / (2 * pi) + 0.5f, std::asin(glm::clamp(n.y, -1.f, 1.f)) / pi + 0.5f}};
}

}  // namespace

glm::vec3 any_tangent(const glm::vec3& n) {
  // Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
  const float sign = std::copysign(1.0f, n.z);
  const float a = -1 / (sign + n.z);
  return {1 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

Mesh make_sphere(int slices, int stacks) {
  Mesh mesh;
  mesh.closed = true;
  for (int j = 0; j <= stacks; ++j) {
    const double theta = kPi * j / stacks;
    for (int i = 0; i <= slices; ++i) {
      const double phi = 2 * kPi * i / slices - kPi;
      const glm::vec3 n(
          glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)));
      const glm::vec3 t(glm::dvec3(-std::sin(phi), 0, -std::cos(phi)));
      mesh.vertices.push_back(
          {n, n, glm::vec4(t, 1), {float(i) / float(slices), 1 - float(j) / float(stacks)}});
    }
  }
  const auto at = [&](int j, int i) { return std::uint32_t(j * (slices + 1) + i); };
  for (int j = 0; j < stacks; ++j) {
    for (int i = 0; i < slices; ++i) {
      if (j > 0) mesh.indices.insert(mesh.indices.end(), {at(j, i), at(j + 1, i), at(j, i + 1)});
      if (j + 1 < stacks)
        mesh.indices.insert(mesh.indices.end(), {at(j, i + 1), at(j + 1, i), at(j + 1, i + 1)});
    }
  }
  return mesh;
}

Mesh make_sphere_of(int triangles) {
  // slices = 2 (stacks - 1) gives nearly square cells and 4 (stacks - 1)^2 triangles.
  const int rows = std::max(1, int(std::lround(std::sqrt(double(triangles) / 4))));
  return make_sphere(std::max(3, 2 * rows), rows + 1);
}

Mesh make_icosphere(int levels) {
  const float g = (1 + std::sqrt(5.0f)) / 2;
  std::vector<glm::vec3> points{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::uint32_t> faces{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                   4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                   6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (glm::vec3& p : points) p = glm::normalize(p);
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, fresh] =
          middles.try_emplace(std::pair(std::min(a, b), std::max(a, b)), std::uint32_t(points.size()));
      if (fresh) points.push_back(glm::normalize(points[a] + points[b]));
      return found->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t f = 0; f < faces.size(); f += 3) {
      const std::uint32_t a = faces[f], b = faces[f + 1], c = faces[f + 2];
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
    }
    faces = std::move(finer);
  }
  Mesh mesh;
  mesh.closed = true;
  mesh.indices = std::move(faces);
  for (const glm::vec3& p : points) mesh.vertices.push_back(sphere_vertex(p));
  return mesh;
}

Mesh make_plane(int cells, int parity) {
  Mesh mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const glm::vec2 uv{float(i), float(j)};
      const glm::vec2 p = uv * (2 / float(cells)) - 1.0f;
      mesh.vertices.push_back({{p.x, 0, -p.y}, {0, 1, 0}, {1, 0, 0, 1}, uv});
    }
  }
  const auto at = [&](int j, int i) { return std::uint32_t(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      if (parity >= 0 && (i + j) % 2 != parity) continue;
      mesh.indices.insert(mesh.indices.end(), {at(j, i), at(j, i + 1), at(j + 1, i), at(j + 1, i),
                                               at(j, i + 1), at(j + 1, i + 1)});
    }
  }
  return mesh;
}

void make_tangents(Mesh& mesh) {
  std::vector<glm::vec3> along_u(mesh.vertices.size(), glm::vec3(0)), along_v = along_u;
  for (std::size_t f = 0; f < mesh.indices.size(); f += 3) {
    const std::array corner{mesh.indices[f], mesh.indices[f + 1], mesh.indices[f + 2]};
    const Vertex &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
    const glm::vec3 e = b.position - a.position, g = c.position - a.position;
    const glm::vec2 s = b.uv - a.uv, t = c.uv - a.uv;
    const float area = s.x * t.y - t.x * s.y;
    if (!(std::abs(area) > 1e-20f)) continue;
    for (const std::uint32_t v : corner) {
      along_u[v] += (e * t.y - g * s.y) / area;
      along_v[v] += (g * s.x - e * t.x) / area;
    }
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    Vertex& vertex = mesh.vertices[v];
    const glm::vec3 t = along_u[v] - vertex.normal * glm::dot(vertex.normal, along_u[v]);
    const float length = glm::length(t);
    if (!(length > 1e-12f)) {
      vertex.tangent = glm::vec4(any_tangent(vertex.normal), 1);
      continue;
    }
    const bool mirrored = glm::dot(glm::cross(vertex.normal, t), along_v[v]) < 0;
    vertex.tangent = glm::vec4(t / length, mirrored ? -1 : 1);
  }
}

void clean(Mesh& mesh, const std::string& source) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!finite(mesh.vertices[v].position))
      throw InputError(source + ": vertex " + std::to_string(v + 1) + " is not finite");
  }
  std::vector<std::uint32_t> kept;
  for (std::size_t f = 0; f + 2 < mesh.indices.size(); f += 3) {
    const std::uint32_t a = mesh.indices[f], b = mesh.indices[f + 1], c = mesh.indices[f + 2];
    const glm::dvec3 p(mesh.vertices[a].position), q(mesh.vertices[b].position), r(mesh.vertices[c].position);
    if (glm::length(glm::cross(q - p, r - p)) > 0) kept.insert(kept.end(), {a, b, c});
  }
  mesh.indices = std::move(kept);
  if (mesh.indices.empty()) throw InputError(source + ": has no triangle with an area above 0");
}

Mesh flat_shaded(const Mesh& mesh) {
  Mesh flat;
  flat.vertices.reserve(mesh.indices.size());
  for (std::size_t f = 0; f < mesh.indices.size(); f += 3) {
    std::array<Vertex, 3> corners{mesh.vertices[mesh.indices[f]], mesh.vertices[mesh.indices[f + 1]],
                                  mesh.vertices[mesh.indices[f + 2]]};
    const glm::vec3 normal = glm::normalize(
        glm::cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position));
    for (Vertex& corner : corners) {
      corner.normal = normal;
      flat.indices.push_back(std::uint32_t(flat.vertices.size()));
      flat.vertices.push_back(corner);
    }
  }
  return flat;
}

std::pair<glm::vec3, glm::vec3> bounding_box(const Mesh& mesh) {
  PointBox box;
  for (const Vertex& v : mesh.vertices) box.add(v.position);
  return {box.low, box.high};
}

glm::vec4 bounding_sphere(const Mesh& mesh) {
  const auto [low, high] = bounding_box(mesh);
  const glm::vec3 center = (low + high) / 2.0f;
  float radius = 0;
  for (const Vertex& v : mesh.vertices) radius = std::max(radius, glm::distance(center, v.position));
  return {center, radius};
}

void append(Mesh& mesh, const Mesh& part, const glm::mat4& transform) {
  const glm::mat3 linear(transform), normals = glm::transpose(glm::inverse(linear));
  const float mirror = glm::determinant(linear) < 0 ? -1.0f : 1.0f;
  const auto base = std::uint32_t(mesh.vertices.size());
  for (Vertex v : part.vertices) {
    v.position = glm::vec3(transform * glm::vec4(v.position, 1));
    v.normal = glm::normalize(normals * v.normal);
    v.tangent = glm::vec4(glm::normalize(linear * glm::vec3(v.tangent)), v.tangent.w * mirror);
    mesh.vertices.push_back(v);
  }
  for (std::size_t f = 0; f < part.indices.size(); f += 3) {
    const bool turned = mirror < 0;
    mesh.indices.push_back(base + part.indices[f]);
    mesh.indices.push_back(base + part.indices[f + (turned ? 2 : 1)]);
    mesh.indices.push_back(base + part.indices[f + (turned ? 1 : 2)]);
  }
}

Mesh make_mesh(const std::string& specification, const std::filesystem::path& folder) {
  const std::size_t colon = specification.find(':');
  const std::string kind = specification.substr(0, colon);
  const bool plain = colon == std::string::npos;
  if (kind == "sphere")
    return make_sphere_of(plain ? kSphereTriangles : count_of(specification, colon, 12, 4000000));
  if (kind == "icosphere") return make_icosphere(plain ? 5 : count_of(specification, colon, 0, 9));
  if (kind == "plane") return make_plane(plain ? 1 : count_of(specification, colon, 1, 1000));
  if (kind == "checker_even") return make_plane(plain ? 8 : count_of(specification, colon, 2, 1000), 0);
  if (kind == "checker_odd") return make_plane(plain ? 8 : count_of(specification, colon, 2, 1000), 1);
  const std::string part = plain ? "" : specification.substr(colon + 1);
  const auto is_part = [&](std::initializer_list<std::string_view> parts) {
    return plain || std::ranges::find(parts, part) != parts.end();
  };
  if (kind == "car" && is_part({"body", "cabin", "wheels"})) return make_car(part);
  if (kind == "shader_ball" && is_part({"ball", "stand"})) return make_shader_ball(part);
  if (kind == "sedan" && is_part({"body", "windows", "trim", "metal", "lamps"})) return make_sedan(part);
  if (kind == "vase" && plain) return make_vase();
  if (kind == "cloth" && plain) return make_cloth();
  if (kind == "text" && !plain) return make_text_sphere(specification.substr(colon + 1));
  return load_model(folder / specification);
}

}  // namespace brdf::render
