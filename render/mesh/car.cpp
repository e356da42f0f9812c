#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "brdf/scalar.h"
#include "render/mesh/mesh.h"

namespace brdf::render {
namespace {

struct Station {
  float x, bottom, top, half_width;
};

// Returns a closed body with rounded cross sections (superellipses) along x, smooth enough for highlights
// to run along it.
Mesh skin(const std::vector<Station>& stations, int around, float squareness) {
  Mesh mesh;
  const auto rounded = [&](float c) { return std::copysign(std::pow(std::abs(c), 2 / squareness), c); };
  for (std::size_t s = 0; s < stations.size(); ++s) {
    const Station& at = stations[s];
    for (int i = 0; i <= around; ++i) {
      const float angle = 2 * float(kPi) * float(i) / float(around);
      const float y = (at.top + at.bottom) / 2 + (at.top - at.bottom) / 2 * rounded(std::sin(angle));
      mesh.vertices.push_back({{at.x, y, at.half_width * rounded(std::cos(angle))},
                               {0, 0, 0},
                               {1, 0, 0, 1},
                               {float(s) / float(stations.size() - 1), float(i) / float(around)}});
    }
  }
  const auto row = std::uint32_t(around + 1);
  for (std::uint32_t s = 0; s + 1 < stations.size(); ++s) {
    for (std::uint32_t i = 0; i < std::uint32_t(around); ++i) {
      const std::uint32_t a = s * row + i, b = a + 1, c = a + row, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
    }
  }
  return mesh;
}

// Computes area-weighted vertex normals. The first and the last point of each ring, at the seam of the
// loft, share one normal.
void smooth_normals(Mesh& mesh, int around) {
  for (std::size_t f = 0; f < mesh.indices.size(); f += 3) {
    Vertex &a = mesh.vertices[mesh.indices[f]], &b = mesh.vertices[mesh.indices[f + 1]],
           &c = mesh.vertices[mesh.indices[f + 2]];
    const glm::vec3 n = glm::cross(b.position - a.position, c.position - a.position);
    a.normal += n;
    b.normal += n;
    c.normal += n;
  }
  const auto row = std::size_t(around + 1);
  for (std::size_t first = 0; first < mesh.vertices.size(); first += row) {
    glm::vec3& last = mesh.vertices[first + row - 1].normal;
    last = mesh.vertices[first].normal = mesh.vertices[first].normal + last;
  }
  for (Vertex& v : mesh.vertices)
    v.normal = glm::dot(v.normal, v.normal) > 0 ? glm::normalize(v.normal) : glm::vec3(0, 1, 0);
}

// Returns a Catmull-Rom interpolation of a few stations with many stations.
std::vector<Station> refined(const std::vector<Station>& coarse, int pieces) {
  const auto curve = [](float a, float b, float c, float d, float t) {
    return b + 0.5f * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
  };
  std::vector<Station> fine;
  const int last = int(coarse.size()) - 1;
  for (int s = 0; s < last; ++s) {
    const auto at = [&](int k) { return coarse[std::size_t(std::clamp(k, 0, last))]; };
    const Station a = at(s - 1), b = at(s), c = at(s + 1), d = at(s + 2);
    for (int p = 0; p < pieces; ++p) {
      const float t = float(p) / float(pieces);
      fine.push_back({curve(a.x, b.x, c.x, d.x, t), curve(a.bottom, b.bottom, c.bottom, d.bottom, t),
                      curve(a.top, b.top, c.top, d.top, t),
                      std::max(0.0f, curve(a.half_width, b.half_width, c.half_width, d.half_width, t))});
    }
  }
  fine.push_back(coarse.back());
  return fine;
}

Mesh smooth_body(const std::vector<Station>& profile, int pieces, int around, float squareness) {
  Mesh mesh = skin(refined(profile, pieces), around, squareness);
  smooth_normals(mesh, around);
  make_tangents(mesh);
  clean(mesh, "car");
  return mesh;
}

constexpr int kAround = 48;

Mesh lower_body() {
  return smooth_body({{-2.05f, 0.55f, 0.60f, 0.0f},
                      {-2.0f, 0.42f, 0.78f, 0.62f},
                      {-1.5f, 0.30f, 0.92f, 0.84f},
                      {-0.6f, 0.26f, 0.92f, 0.90f},
                      {0.6f, 0.26f, 0.90f, 0.90f},
                      {1.4f, 0.30f, 0.80f, 0.86f},
                      {1.95f, 0.40f, 0.66f, 0.66f},
                      {2.1f, 0.52f, 0.56f, 0.0f}},
                     10, kAround, 4);
}

Mesh cabin() {
  return smooth_body({{-1.55f, 0.80f, 0.84f, 0.0f},
                      {-1.2f, 0.70f, 1.16f, 0.62f},
                      {-0.6f, 0.70f, 1.42f, 0.70f},
                      {0.1f, 0.70f, 1.42f, 0.70f},
                      {0.7f, 0.70f, 1.08f, 0.66f},
                      {1.15f, 0.76f, 0.80f, 0.0f}},
                     10, kAround, 3.5f);
}

// A wheel is the same loft about a different axis: its stations run along the axle.
Mesh wheels() {
  const Mesh wheel = smooth_body({{-0.13f, 0.0f, 0.0f, 0.0f},
                                  {-0.12f, -0.30f, 0.30f, 0.30f},
                                  {-0.08f, -0.36f, 0.36f, 0.36f},
                                  {0.08f, -0.36f, 0.36f, 0.36f},
                                  {0.12f, -0.30f, 0.30f, 0.30f},
                                  {0.13f, 0.0f, 0.0f, 0.0f}},
                                 3, 40, 2);
  Mesh four;
  for (const float x : {-1.25f, 1.25f}) {
    for (const float z : {-0.82f, 0.82f}) {
      const glm::mat4 place = glm::translate(glm::mat4(1), {x, 0.36f, z});
      append(four, wheel, glm::rotate(place, float(kPi / 2), {0, 1, 0}));
    }
  }
  return four;
}

}  // namespace

Mesh make_car(std::string_view part) {
  if (part == "body") return lower_body();
  if (part == "cabin") return cabin();
  if (part == "wheels") return wheels();
  Mesh car = lower_body();
  append(car, cabin());
  append(car, wheels());
  return car;
}

}  // namespace brdf::render
