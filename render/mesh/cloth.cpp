// A cloth laid over a ball: masses on springs (Provot 1995), moved by Verlet steps with a correction of the
// springs' lengths after each step (Jakobsen 2001), then smoothed as a B-spline surface and given two
// sides.
#include <algorithm>
#include <cmath>

#include "brdf/random.h"
#include "render/mesh/mesh.h"

namespace brdf::render {
namespace {

constexpr int kPoints = 61;  // along each side
constexpr float kClothSide = 4.2f, kBall = 0.75f, kClothFloor = -0.75f, kThickness = 0.008f;
// Distance from the middle of the cloth to the surface below it.
constexpr float kClear = 0.01f;
constexpr int kSteps = 420, kCorrections = 5;

struct Spring {
  int a, b;
  float length, stiffness;
};

int index(int i, int j) {
  return j * kPoints + i;
}

// Returns springs along the threads, diagonally, and over two threads against bending.
std::vector<Spring> springs(const std::vector<glm::vec3>& at) {
  std::vector<Spring> all;
  const auto add = [&](int i, int j, int di, int dj, float stiffness) {
    if (i + di < 0 || i + di >= kPoints || j + dj >= kPoints) return;
    const int a = index(i, j), b = index(i + di, j + dj);
    all.push_back({a, b, glm::distance(at[std::size_t(a)], at[std::size_t(b)]), stiffness});
  };
  for (int j = 0; j < kPoints; ++j) {
    for (int i = 0; i < kPoints; ++i) {
      add(i, j, 1, 0, 1);
      add(i, j, 0, 1, 1);
      add(i, j, 1, 1, 0.3f);
      add(i, j, -1, 1, 0.3f);
      add(i, j, 2, 0, 0.12f);
      add(i, j, 0, 2, 0.12f);
    }
  }
  return all;
}

// Moves a point out of the ball and above the floor; friction slows down points in contact.
void collide(glm::vec3& at, glm::vec3& before) {
  const float distance = glm::length(at);
  bool touches = false;
  if (distance < kBall + kClear) {
    at *= (kBall + kClear) / std::max(distance, 1e-6f);
    touches = true;
  }
  if (at.y < kClothFloor + kClear) {
    at.y = kClothFloor + kClear;
    touches = true;
  }
  if (touches) before = glm::mix(before, at, 0.5f);
}

std::vector<glm::vec3> laid() {
  std::vector<glm::vec3> at;
  Random random(7);
  // The cloth is rotated, off the centre and slightly uneven, so that its folds fall irregularly.
  const float c = std::cos(0.35f), s = std::sin(0.35f);
  for (int j = 0; j < kPoints; ++j) {
    for (int i = 0; i < kPoints; ++i) {
      const float x = kClothSide * (float(i) / float(kPoints - 1) - 0.5f),
                  z = kClothSide * (float(j) / float(kPoints - 1) - 0.5f);
      at.push_back({c * x - s * z + 0.05f, 0.8f + float(random.uniform(0, 0.004)), s * x + c * z - 0.08f});
    }
  }
  return at;
}

std::vector<glm::vec3> fallen() {
  std::vector<glm::vec3> at = laid(), before = at;
  const std::vector<Spring> all = springs(at);
  for (int step = 0; step < kSteps; ++step) {
    for (std::size_t k = 0; k < at.size(); ++k) {
      const glm::vec3 moved = (at[k] - before[k]) * 0.985f;
      before[k] = at[k];
      at[k] += moved - glm::vec3(0, 0.0004f, 0);
    }
    for (int correction = 0; correction < kCorrections; ++correction) {
      for (const Spring& spring : all) {
        glm::vec3 &a = at[std::size_t(spring.a)], &b = at[std::size_t(spring.b)];
        const glm::vec3 along = b - a;
        const float length = std::max(glm::length(along), 1e-6f);
        const glm::vec3 move = along * (0.5f * spring.stiffness * (length - spring.length) / length);
        a += move;
        b -= move;
      }
      for (std::size_t k = 0; k < at.size(); ++k) collide(at[k], before[k]);
    }
  }
  return at;
}

struct SurfacePoint {
  glm::vec3 place, along_u, along_v;
};

// Returns a point of the uniform cubic B-spline with these control points; u and v count threads.
SurfacePoint surface(const std::vector<glm::vec3>& control, float u, float v) {
  const int i = std::min(int(u), kPoints - 2), j = std::min(int(v), kPoints - 2);
  const auto weights = [](float t, float(&w)[4], float(&d)[4]) {
    const float r = 1 - t;
    w[0] = r * r * r / 6, w[1] = (3 * t * t * t - 6 * t * t + 4) / 6,
    w[2] = (3 * r * r * r - 6 * r * r + 4) / 6;
    w[3] = t * t * t / 6;
    d[0] = -r * r / 2, d[1] = t * (3 * t - 4) / 2, d[2] = -r * (3 * r - 4) / 2, d[3] = t * t / 2;
  };
  float wu[4], du[4], wv[4], dv[4];
  weights(u - float(i), wu, du);
  weights(v - float(j), wv, dv);
  SurfacePoint out{glm::vec3(0), glm::vec3(0), glm::vec3(0)};
  for (int n = 0; n < 4; ++n) {
    for (int m = 0; m < 4; ++m) {
      const glm::vec3& p = control[std::size_t(
          index(std::clamp(i + m - 1, 0, kPoints - 1), std::clamp(j + n - 1, 0, kPoints - 1)))];
      out.place += wu[m] * wv[n] * p;
      out.along_u += du[m] * wv[n] * p;
      out.along_v += wu[m] * dv[n] * p;
    }
  }
  return out;
}

// Returns one side, at the distance `lift` from the middle; the lower side faces the other way.
Mesh side(const std::vector<glm::vec3>& control, float lift) {
  constexpr int kFine = 4 * (kPoints - 1);
  Mesh mesh;
  for (int j = 0; j <= kFine; ++j) {
    for (int i = 0; i <= kFine; ++i) {
      const SurfacePoint p = surface(control, float(i) / 4, float(j) / 4);
      const glm::vec3 up = glm::normalize(glm::cross(p.along_v, p.along_u));
      const glm::vec3 normal = lift > 0 ? up : -up;
      const glm::vec3 tangent = glm::normalize(p.along_u - normal * glm::dot(normal, p.along_u));
      const glm::vec2 uv{float(i) / float(kFine), float(j) / float(kFine)};
      mesh.vertices.push_back({p.place + lift * up, normal, glm::vec4(tangent, lift > 0 ? -1.f : 1.f), uv});
    }
  }
  constexpr auto kRow = std::uint32_t(kFine + 1);
  for (std::uint32_t j = 0; j + 1 < kRow; ++j) {
    for (std::uint32_t i = 0; i + 1 < kRow; ++i) {
      const std::uint32_t a = j * kRow + i, b = a + 1, c = a + kRow, d = c + 1;
      if (lift > 0) mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
      if (lift < 0) mesh.indices.insert(mesh.indices.end(), {a, b, c, b, d, c});
    }
  }
  return mesh;
}

// Returns the hem between the borders of the upper and the lower side, which have the same points in the
// same order.
Mesh hem(const Mesh& upper, const Mesh& lower) {
  constexpr std::uint32_t kRow = 4 * (kPoints - 1) + 1;
  std::vector<std::uint32_t> border;  // round the cloth
  for (std::uint32_t i = 0; i + 1 < kRow; ++i) border.push_back(i);
  for (std::uint32_t j = 0; j + 1 < kRow; ++j) border.push_back(j * kRow + kRow - 1);
  for (std::uint32_t i = kRow - 1; i > 0; --i) border.push_back((kRow - 1) * kRow + i);
  for (std::uint32_t j = kRow - 1; j > 0; --j) border.push_back(j * kRow);
  Mesh mesh;
  for (std::size_t k = 0; k < border.size(); ++k) {
    const Vertex &a = upper.vertices[border[k]], &b = upper.vertices[border[(k + 1) % border.size()]];
    const glm::vec3 along = glm::normalize(b.position - a.position);
    const glm::vec3 outwards = glm::normalize(glm::cross(a.normal, along));
    const auto first = std::uint32_t(mesh.vertices.size());
    for (const Mesh* side : {&upper, &lower}) {
      for (const std::size_t at : {k, (k + 1) % border.size()}) {
        Vertex vertex = side->vertices[border[at]];
        vertex.normal = outwards;
        vertex.tangent = glm::vec4(along, 1);
        mesh.vertices.push_back(vertex);
      }
    }
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first + 1, first + 3, first + 2});
  }
  return mesh;
}

}  // namespace

Mesh make_cloth() {
  static const std::vector<glm::vec3> control = fallen();
  const Mesh upper = side(control, kThickness / 2), lower = side(control, -kThickness / 2);
  Mesh mesh = upper;
  append(mesh, lower);
  append(mesh, hem(upper, lower));
  mesh.closed = true;
  return mesh;
}

}  // namespace brdf::render
