// A procedural car: a body lofted along x with arches cut out of its sides, a cabin whose windows are parts
// of one surface, and wheels made by the lathe.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "brdf/scalar.h"
#include "render/mesh/lathe.h"
#include "render/mesh/loft.h"
#include "render/mesh/mesh.h"
#include "render/mesh/spline.h"

namespace brdf::render {
namespace {

using glm::vec3;

constexpr float kHalfLength = 2.2f, kSill = 0.19f, kWidest = 0.52f;  // the height at which the body is widest
constexpr float kTyreRadius = 0.34f;
constexpr float kAxle = 1.34f, kHub = kTyreRadius, kArch = 0.425f;
constexpr float kInner = 0.5f;  // from the middle to the wall behind a wheel

// --- The body ---------------------------------------------------------------------------------------------

// Returns how far the body is open at x: 1 along most of the body, 0 at its ends, rounded like a
// superellipse.
float openness(float x) {
  constexpr float kEnd = 0.36f;
  const float into = std::clamp((std::abs(x) - (kHalfLength - kEnd)) / kEnd, 0.0f, 1.0f);
  return std::pow(1 - std::pow(into, 3.0f), 1 / 3.0f);
}

// Returns the height of bonnet, roof line's foot and boot lid, and the half width, from tail to nose.
glm::vec2 deck_and_width(float x) {
  static const NaturalSpline<vec3> lines({{-2.2f, 0.86f, 0.80f},
                                          {-1.6f, 0.93f, 0.87f},
                                          {-0.6f, 0.94f, 0.90f},
                                          {0.5f, 0.92f, 0.90f},
                                          {1.4f, 0.83f, 0.88f},
                                          {2.2f, 0.66f, 0.78f}});
  float low = 0, high = float(lines.pieces());
  for (int k = 0; k < 24; ++k) {
    const float middle = (low + high) / 2;
    (lines.at(middle).x < x ? low : high) = middle;
  }
  const vec3 found = lines.at(low);
  return {found.y, found.z};
}

// Returns half a section from the middle of the floor (v = 0) by the widest place (v = 1) to the middle of
// the deck (v = 2): two quarters of superellipses.
vec3 body_at(float x, float v) {
  const glm::vec2 line = deck_and_width(x);
  const float open = openness(x), width = line.y * std::pow(open, 0.8f);
  const float end = v < 1 ? kWidest - (kWidest - kSill) * open : kWidest + (line.x - kWidest) * open;
  const float angle = std::abs(v - 1) * float(kPi) / 2, c = std::cos(angle), s = std::sin(angle);
  const float power = v < 1 ? 6.0f : 4.0f;
  const float reach = std::pow(std::pow(std::abs(c), power) + std::pow(std::abs(s), power), 1 / power);
  return {x, kWidest + (end - kWidest) * s / reach, width * c / reach};
}

float arch_height(float x) {
  const float from_axle = std::abs(std::abs(x) - kAxle);
  return from_axle < kArch ? kHub + std::sqrt(kArch * kArch - from_axle * from_axle) : 0;
}

// Returns v at the upper end of the arch in this section; 0 if the section has no arch.
float lower_edge(float x) {
  const float height = arch_height(x);
  if (body_at(x, 0).y >= height) return 0;
  float low = 0, high = 1.8f;
  for (int k = 0; k < 24; ++k) {
    const float middle = (low + high) / 2;
    (body_at(x, middle).y < height ? low : high) = middle;
  }
  return low;
}

// Stations are dense at the closing ends of the body and round the arches, with a pair of stations at each
// upright end of an arch.
std::vector<float> stations() {
  std::vector<float> out;
  for (int k = 0; k <= 90; ++k) {
    const float t = float(k) / 90;
    out.push_back(kHalfLength * std::sin(float(kPi / 2) * (2 * t - 1)));
  }
  for (const float axle : {-kAxle, kAxle}) {
    std::erase_if(out, [&](float x) { return std::abs(x - axle) < kArch + 0.01f; });
    for (const float end : {-1.0f, 1.0f}) out.push_back(axle + end * (kArch + 1e-4f));
    for (int k = 0; k <= 40; ++k)
      out.push_back(axle - (kArch - 1e-4f) * std::cos(float(kPi) * float(k) / 40));
  }
  std::ranges::sort(out);
  return out;
}

Mesh body() {
  // v of the mesh runs from the lower edge (0) to the deck (1); the normal is that of the complete section.
  const std::vector<float> xs = stations();
  const std::vector<float> vs = divided({0, 1}, {96});
  Mesh mesh = loft([](float x, float v) { return body_at(x, glm::mix(lower_edge(x), 2.0f, v)); }, xs, vs, 1);
  std::size_t k = 0;
  for (const float x : xs) {
    for (const float v : vs) {
      constexpr float kStep = 1e-3f;
      const float at = glm::mix(lower_edge(x), 2.0f, v);
      const float inside = std::clamp(x, -kHalfLength + 2 * kStep, kHalfLength - 2 * kStep);
      const float along = std::clamp(at, kStep, 2 - kStep);
      const vec3 dx = body_at(inside + kStep, along) - body_at(inside - kStep, along);
      const vec3 dv = body_at(inside, along + kStep) - body_at(inside, along - kStep);
      mesh.vertices[k++].normal = glm::normalize(glm::cross(dx, dv));
    }
  }
  return mirrored(mesh);
}

// The dark inside of an arch: its roof, the wall behind the wheel and the walls in front of and behind the
// wheel.
Mesh housing(float axle) {
  std::vector<float> xs;
  for (int k = 0; k <= 40; ++k) xs.push_back(axle - (kArch - 1e-4f) * std::cos(float(kPi) * float(k) / 40));
  const Surface roof = [](float x, float v) {
    const vec3 edge = body_at(x, lower_edge(x));
    return vec3(x, edge.y, glm::mix(edge.z, kInner, v));
  };
  Mesh half = loft(roof, xs, {0, 1}, -1);
  const Surface behind = [](float x, float v) {
    return vec3(x, glm::mix(kSill + 0.02f, std::max(arch_height(x), kHub), v), kInner);
  };
  append(half, loft(behind, xs, {0, 1}, 1));
  for (const float end : {-1.0f, 1.0f}) {
    const Surface wall = [&](float v, float outwards) {
      const vec3 edge = body_at(axle + end * (kArch - 0.0005f), v);
      return vec3(edge.x, edge.y, glm::mix(std::min(kInner, edge.z), edge.z, outwards));
    };
    const float top = lower_edge(axle + end * (kArch - 1e-4f));
    append(half, loft(wall, divided({0.3f, top}, {16}), {0, 1}, -end));
  }
  return mirrored(half);
}

// --- The cabin --------------------------------------------------------------------------------------------

// Returns a point of the cabin. u runs round its outline in degrees, from the middle of the windscreen by
// the left side; v goes up to the middle of the roof.
vec3 cabin_at(float u, float v) {
  // Foremost x, rearmost x, half width, height.
  static const NaturalSpline<glm::vec4> levels({{1.12f, -1.72f, 0.80f, 0.82f},
                                                {0.86f, -1.46f, 0.75f, 1.02f},
                                                {0.50f, -1.12f, 0.67f, 1.27f},
                                                {0.30f, -0.94f, 0.60f, 1.37f},
                                                {0.05f, -0.72f, 0.44f, 1.415f},
                                                {-0.32f, -0.34f, 0.01f, 1.43f}});
  const glm::vec4 level = levels.at(v);
  const float angle = u * float(kPi) / 180, c = std::cos(angle), s = std::sin(angle);
  const float reach = std::pow(std::pow(std::abs(c), 4.5f) + std::pow(std::abs(s), 4.5f), 1 / 4.5f);
  const float middle = (level.x + level.y) / 2, half = (level.x - level.y) / 2;
  // The windscreen and the rear window are slightly curved.
  const float bow = 1 + 0.06f * c * c;
  return {middle + half * c / reach * bow, level.w, level.z * s / reach};
}

constexpr float kGlassFrom = 0.62f, kGlassTo = 2.35f;  // of v

bool is_glass(float u, float v) {
  if (v < kGlassFrom || v > kGlassTo) return false;
  const float around = u > 180 ? 360 - u : u;
  return around < 41 || (around > 47 && around < 92) || (around > 95 && around < 129) || around > 141;
}

Mesh cabin(bool glass) {
  const std::vector<float> us = divided({0, 41, 47, 92, 95, 129, 141, 219, 231, 265, 268, 313, 319, 360},
                                        {16, 6, 24, 2, 16, 8, 28, 8, 16, 2, 24, 6, 16});
  const std::vector<float> vs = divided({0, kGlassFrom, kGlassTo, 5}, {6, 20, 24});
  return loft(cabin_at, us, vs, -1, [&](float u, float v) { return is_glass(u, v) == glass; });
}

// --- Wheels, lamps and dark parts
// -----------------------------------------------------------------------------

// Turns a mesh of the lathe, which has the axis y, onto the axle.
Mesh onto_axle(const Mesh& turned) {
  Mesh out;
  append(out, turned, glm::rotate(glm::mat4(1), float(kPi / 2), {1, 0, 0}));
  return out;
}

Mesh tyre() {
  return onto_axle(lathe(filleted({{{0, -0.1f}},
                                   {{0.3f, -0.1f}, 0.02f},
                                   {{kTyreRadius, -0.07f}, 0.05f},
                                   {{kTyreRadius, 0.07f}, 0.05f},
                                   {{0.30f, 0.105f}, 0.03f},
                                   {{0.235f, 0.09f}, 0.01f},
                                   {{0.225f, 0.02f}, 0.01f},
                                   {{0, 0.0f}}},
                                  6),
                         96));
}

// Ten spokes.
Mesh rim() {
  const Mesh ring = lathe(
      filleted({{{0.236f, 0.03f}}, {{0.236f, 0.1f}, 0.006f}, {{0.214f, 0.1f}, 0.006f}, {{0.214f, 0.0f}}}, 4),
      96);
  const Mesh hub = lathe(filleted({{{0.055f, 0.0f}}, {{0.055f, 0.085f}, 0.02f}, {{0, 0.085f}}}, 6), 48);
  Mesh all = onto_axle(ring);
  append(all, onto_axle(hub));
  const Mesh rod = make_sphere(24, 16);
  for (int k = 0; k < 10; ++k) {
    const glm::mat4 turn = glm::rotate(glm::mat4(1), 2 * float(kPi) * float(k) / 10, {0, 0, 1});
    append(all, placed(rod, {0.135f, 0, 0.058f}, {0.1f, 0.02f, 0.022f}), turn);
  }
  return all;
}

// Places a wheel at each axle end. The axle of `wheel` runs along z, its outer side is at positive z.
Mesh at_every_wheel(const Mesh& wheel) {
  const Mesh lying = placed(wheel, vec3(0));
  Mesh all;
  for (const float x : {-kAxle, kAxle}) append(all, placed(lying, {x, kHub, 0.75f}));
  return mirrored(all);
}

Mesh lamps() {
  const Mesh ball = make_sphere(48, 24);
  Mesh half = placed(ball, {2.02f, 0.62f, 0.56f}, {0.12f, 0.055f, 0.17f}, 30);
  append(half, placed(ball, {-2.06f, 0.74f, 0.56f}, {0.1f, 0.06f, 0.17f}, -30));
  return mirrored(half);
}

Mesh trim() {
  Mesh all = housing(-kAxle);
  append(all, housing(kAxle));
  append(all, at_every_wheel(tyre()));
  const Mesh ball = make_sphere(64, 32);
  append(all, placed(ball, {2.03f, 0.40f, 0}, {0.2f, 0.06f, 0.5f}));   // the air intake
  append(all, placed(ball, {-2.03f, 0.38f, 0}, {0.2f, 0.05f, 0.5f}));  // below the boot
  return all;
}

Mesh painted() {
  Mesh all = body();
  append(all, cabin(false));
  const Mesh mirror = placed(make_sphere(32, 16), {0.62f, 0.98f, 0.86f}, {0.07f, 0.055f, 0.09f}, 12);
  append(all, mirrored(mirror));
  return all;
}

}  // namespace

Mesh make_sedan(std::string_view part) {
  const auto wanted = [&](std::string_view name) { return part.empty() || part == name; };
  Mesh sedan;
  if (wanted("body")) append(sedan, painted());
  if (wanted("windows")) append(sedan, cabin(true));
  if (wanted("trim")) append(sedan, trim());
  if (wanted("metal")) append(sedan, at_every_wheel(rim()));
  if (wanted("lamps")) append(sedan, lamps());
  make_tangents(sedan);
  clean(sedan, "sedan");
  return sedan;
}

}  // namespace brdf::render
