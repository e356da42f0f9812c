#include "render/mesh/lathe.h"

#include <algorithm>
#include <cmath>

#include "brdf/scalar.h"
#include "render/mesh/spline.h"

namespace brdf::render {
namespace {

glm::vec2 direction(const glm::vec2& from, const glm::vec2& to) {
  const glm::vec2 d = to - from;
  const float length = glm::length(d);
  return length > 0 ? d / length : glm::vec2(0);
}

glm::vec2 right_of(const glm::vec2& tangent) {
  return {tangent.y, -tangent.x};
}

// Appends the arc that touches both legs of a corner at the distance `reach` from the corner.
void append_fillet(Profile& out, const glm::vec2& corner, const glm::vec2& in, const glm::vec2& away,
                   float reach, int pieces) {
  const float turn = std::atan2(in.x * away.y - in.y * away.x, glm::dot(in, away));
  const float radius = reach / std::tan(std::abs(turn) / 2);
  const float side = turn > 0 ? 1.0f : -1.0f;  // a left turn has its centre on the left
  const glm::vec2 start = corner - in * reach, center = start - side * radius * right_of(in);
  for (int k = 0; k <= pieces; ++k) {
    const float angle = turn * float(k) / float(pieces), c = std::cos(angle), s = std::sin(angle);
    const glm::vec2 tangent(c * in.x - s * in.y, s * in.x + c * in.y);
    out.push_back({center + side * radius * right_of(tangent), tangent});
  }
}

}  // namespace

Profile filleted(const std::vector<ProfileCorner>& corners, int pieces) {
  Profile out;
  const std::size_t last = corners.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    const glm::vec2 at = corners[k].at;
    if (k == 0 || k == last) {
      out.push_back({at, k == 0 ? direction(at, corners[1].at) : direction(corners[k - 1].at, at)});
      continue;
    }
    const glm::vec2 in = direction(corners[k - 1].at, at), away = direction(at, corners[k + 1].at);
    const float half_turn = std::acos(std::clamp(glm::dot(in, away), -1.0f, 1.0f)) / 2;
    const float room =
        0.5f * std::min(glm::distance(corners[k - 1].at, at), glm::distance(at, corners[k + 1].at));
    const float reach = std::min(corners[k].fillet * std::tan(half_turn), room);
    if (reach > 1e-6f) {
      append_fillet(out, at, in, away, reach, pieces);
    } else {
      out.push_back({at, in});
      out.push_back({at, away});
    }
  }
  return out;
}

Profile arc(glm::vec2 center, float radius, float from, float to, int pieces) {
  Profile out;
  const float sense = to > from ? 1.0f : -1.0f;
  for (int k = 0; k <= pieces; ++k) {
    const float angle = from + (to - from) * float(k) / float(pieces);
    const glm::vec2 outward(std::cos(angle), std::sin(angle));
    out.push_back({center + radius * outward, sense * glm::vec2(-outward.y, outward.x)});
  }
  return out;
}

Profile spline(const std::vector<glm::vec2>& points, int pieces) {
  const NaturalSpline<glm::vec2> curve(points);
  Profile out;
  for (std::size_t k = 0; k < curve.pieces(); ++k) {
    for (int i = k == 0 ? 0 : 1; i <= pieces; ++i) {
      const float t = float(i) / float(pieces);
      out.push_back({curve.at(k, t), glm::normalize(curve.slope(k, t))});
    }
  }
  return out;
}

Profile joined(const std::vector<Profile>& parts) {
  Profile out;
  for (const Profile& part : parts) {
    for (const ProfilePoint& point : part) {
      const bool repeated = !out.empty() && glm::distance(out.back().at, point.at) < 1e-6f &&
                            glm::dot(out.back().tangent, point.tangent) > 0.9999f;
      if (!repeated) out.push_back(point);
    }
  }
  return out;
}

Mesh lathe(const Profile& profile, int slices) {
  Mesh mesh;
  float along = 0;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    if (k > 0) along += glm::distance(profile[k - 1].at, profile[k].at);
    const glm::vec2 outward = right_of(profile[k].tangent);
    for (int i = 0; i <= slices; ++i) {
      const double phi = 2 * kPi * i / slices;
      const auto c = float(std::cos(phi)), s = float(std::sin(phi));
      mesh.vertices.push_back({{profile[k].at.x * c, profile[k].at.y, -profile[k].at.x * s},
                               {outward.x * c, outward.y, -outward.x * s},
                               {-s, 0, -c, 1},
                               {float(i) / float(slices), along}});
    }
  }
  const auto row = std::uint32_t(slices + 1);
  for (std::uint32_t k = 0; k + 1 < std::uint32_t(profile.size()); ++k) {
    if (glm::distance(profile[k].at, profile[k + 1].at) < 1e-6f) continue;  // a corner
    for (std::uint32_t i = 0; i < std::uint32_t(slices); ++i) {
      const std::uint32_t a = k * row + i, b = a + 1, c = a + row, d = c + 1;
      if (profile[k].at.x > 0) mesh.indices.insert(mesh.indices.end(), {a, b, c});
      if (profile[k + 1].at.x > 0) mesh.indices.insert(mesh.indices.end(), {b, d, c});
    }
  }
  for (Vertex& vertex : mesh.vertices) vertex.uv.y /= along;
  return mesh;
}

}  // namespace brdf::render
