#include "render/compare/measured.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>

#include "io/error.h"

namespace brdf::render {
namespace {

constexpr int kDimensions = 3;
constexpr std::size_t kNeighbours = 32;
using Point = std::array<float, kDimensions>;

// Isotropic half-vector coordinates: the half angle (stretched near the lobe's centre by the square root, as
// measured tables are), the difference angle, and the azimuth between them weighted by how much it matters.
Point coordinates(const glm::vec3& wi, const glm::vec3& wo) {
  const glm::vec3 sum = wi + wo;
  const float length = glm::length(sum);
  if (!(length > 1e-6f)) return {1, 1, 0};
  const glm::vec3 h = sum / length;
  const float theta_h = std::atan2(std::hypot(h.x, h.y), h.z);
  const float theta_d = std::acos(glm::clamp(length / 2, 0.0f, 1.0f));
  // Azimuth of wi about h, from the plane of h and the normal.
  const glm::vec3 side = glm::cross(glm::vec3(0, 0, 1), h);
  float phi_d = 0;
  if (glm::dot(side, side) > 1e-12f && theta_d > 1e-4f) {
    const glm::vec3 b = glm::normalize(side), t = glm::cross(b, h);
    phi_d = std::atan2(glm::dot(wi, b), glm::dot(wi, t));
  }
  // wi and wo exchanged turn phi_d by pi, a mirrored surface changes its sign: fold to [0, pi/2].
  phi_d = std::abs(phi_d);
  phi_d = std::min(phi_d, 3.14159265f - phi_d);
  return {std::sqrt(theta_h), theta_d,
          phi_d * std::sin(theta_d) * std::min(1.0f, 2 * std::sqrt(theta_h)) * 0.5f};
}

float distance2(const Point& a, const Point& b) {
  float sum = 0;
  for (int k = 0; k < kDimensions; ++k)
    sum += (a[std::size_t(k)] - b[std::size_t(k)]) * (a[std::size_t(k)] - b[std::size_t(k)]);
  return sum;
}

struct Row {
  Point at;
  glm::vec3 value;  // f_r
};

// Rows at one place become their mean: repeated measurements, and directions that the symmetries make equal
// (all azimuths at theta_o = 0). Left apart they would fill the neighbourhood and hide what lies round it.
std::vector<Row> merged(std::vector<Row> rows) {
  constexpr float kSame = 1e-3f;  // of the coordinates: a twentieth of a degree
  const auto cell = [](const Row& row) {
    std::array<long, kDimensions> out{};
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = std::lround(row.at[k] / kSame);
    return out;
  };
  std::map<std::array<long, kDimensions>, std::pair<Row, int>> cells;
  for (const Row& row : rows) {
    auto& [sum, count] = cells.try_emplace(cell(row), Row{row.at, glm::vec3(0)}, 0).first->second;
    sum.value += row.value;
    ++count;
  }
  rows.clear();
  for (const auto& [at, entry] : cells)
    rows.push_back({entry.first.at, entry.first.value / float(entry.second)});
  return rows;
}

// A balanced k-d tree in one array: the median of each range splits it along the axis of its depth.
class Tree {
 public:
  explicit Tree(std::vector<Row> rows) : rows_(std::move(rows)) { build(0, rows_.size(), 0); }

  struct Found {
    std::array<std::pair<float, std::size_t>, kNeighbours>
        nearest;  // squared distance and row, nearest first
    std::size_t count = 0;
    float reach() const {
      return count < kNeighbours ? std::numeric_limits<float>::infinity() : nearest[count - 1].first;
    }
    void add(float d2, std::size_t row) {
      if (!(d2 < reach())) return;
      if (count < kNeighbours) ++count;
      std::size_t k = count - 1;
      for (; k > 0 && nearest[k - 1].first > d2; --k) nearest[k] = nearest[k - 1];
      nearest[k] = {d2, row};
    }
  };
  Found find(const Point& at) const {
    Found found;
    search(at, 0, rows_.size(), 0, found);
    return found;
  }
  const Row& operator[](std::size_t k) const { return rows_[k]; }

 private:
  void build(std::size_t begin, std::size_t end, int axis) {
    if (end - begin < 2) return;
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::size_t k) { return rows_.begin() + std::ptrdiff_t(k); };
    std::nth_element(at(begin), at(middle), at(end), [axis](const Row& a, const Row& b) {
      return a.at[std::size_t(axis)] < b.at[std::size_t(axis)];
    });
    build(begin, middle, (axis + 1) % kDimensions);
    build(middle + 1, end, (axis + 1) % kDimensions);
  }
  void search(const Point& p, std::size_t begin, std::size_t end, int axis, Found& found) const {
    if (begin >= end) return;
    const std::size_t middle = (begin + end) / 2;
    found.add(distance2(p, rows_[middle].at), middle);
    const float side = p[std::size_t(axis)] - rows_[middle].at[std::size_t(axis)];
    const int next = (axis + 1) % kDimensions;
    const auto lower = [&] { search(p, begin, middle, next, found); };
    const auto upper = [&] { search(p, middle + 1, end, next, found); };
    side < 0 ? lower() : upper();
    if (side * side < found.reach()) side < 0 ? upper() : lower();
  }
  std::vector<Row> rows_;
};

glm::vec3 weighted_mean(const Tree& tree, const Tree::Found& found) {
  glm::vec3 logs(0), plain(0);
  float total = 1e-20f;
  bool positive = true;
  for (std::size_t k = 0; k < found.count; ++k) {
    const auto [d2, row] = found.nearest[k];
    const glm::vec3& f = tree[row].value;
    // 0 at the farthest one: rows that come and go among the nearest leave no edge.
    const float inside = 1 - d2 / (found.nearest[found.count - 1].first + 1e-8f);
    const float weight = inside * inside / (d2 + 1e-8f);
    total += weight;
    plain += weight * f;
    positive = positive && f.r > 0 && f.g > 0 && f.b > 0;
    if (positive) logs += weight * glm::log(f);
  }
  return positive ? glm::exp(logs / total) : glm::max(plain / total, glm::vec3(0));
}

}  // namespace

Measured interpolate(const io::SampleTable& table) {
  const std::size_t channels = table.channels.size();
  if (channels != 1 && channels != 3) {
    throw InputError(table.source + ": has " + std::to_string(channels) +
                     " channels; the renderer takes 1 or 3");
  }
  if (table.rows() == 0) throw InputError(table.source + ": has no rows");
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const Directions<double> d = arrays.view();
  std::vector<Row> rows;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    Row row;
    row.at = coordinates(glm::vec3(glm::dvec3(d.wi_x[k], d.wi_y[k], d.wi_z[k])),
                         glm::vec3(glm::dvec3(d.wo_x[k], d.wo_y[k], d.wo_z[k])));
    for (std::size_t c = 0; c < 3; ++c) row.value[int(c)] = float(table.values[channels == 1 ? 0 : c][k]);
    rows.push_back(row);
  }
  const auto tree = std::make_shared<const Tree>(merged(std::move(rows)));
  return [tree](const glm::vec3& wi, const glm::vec3& wo) {
    if (!(wi.z > 0 && wo.z > 0)) return glm::vec3(0);
    return weighted_mean(*tree, tree->find(coordinates(wi, wo))) * wi.z;
  };
}

}  // namespace brdf::render
