#include "render/compare/measured.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <nanoflann.hpp>

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
  phi_d = std::min(phi_d, float(kPi) - phi_d);
  return {std::sqrt(theta_h), theta_d,
          phi_d * std::sin(theta_d) * std::min(1.0f, 2 * std::sqrt(theta_h)) * 0.5f};
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

// The rows as nanoflann asks for them, and its tree over them.
class Rows {
 public:
  explicit Rows(std::vector<Row> rows) : rows_(std::move(rows)), tree_(kDimensions, *this) {}
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  std::size_t kdtree_get_point_count() const { return rows_.size(); }
  float kdtree_get_pt(std::size_t row, std::size_t axis) const { return rows_[row].at[axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

  // The mean of the rows round a place, by distance; of the logarithms where all are positive.
  glm::vec3 mean_at(const Point& at) const {
    std::array<std::uint32_t, kNeighbours> row{};
    std::array<float, kNeighbours> d2{};  // squared distances, the nearest first
    const std::size_t count = tree_.knnSearch(at.data(), kNeighbours, row.data(), d2.data());
    glm::vec3 logs(0), plain(0);
    float total = 1e-20f;
    bool positive = true;
    for (std::size_t k = 0; k < count; ++k) {
      const glm::vec3& f = rows_[row[k]].value;
      // 0 at the farthest one: rows that come and go among the nearest leave no edge.
      const float inside = 1 - d2[k] / (d2[count - 1] + 1e-8f);
      const float weight = inside * inside / (d2[k] + 1e-8f);
      total += weight;
      plain += weight * f;
      positive = positive && f.r > 0 && f.g > 0 && f.b > 0;
      if (positive) logs += weight * glm::log(f);
    }
    return positive ? glm::exp(logs / total) : glm::max(plain / total, glm::vec3(0));
  }

 private:
  std::vector<Row> rows_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Rows>, Rows, kDimensions> tree_;
};

}  // namespace

Measured interpolate(const io::SampleTable& table) {
  const std::array<std::size_t, 3> colours = require_colours(table.channels, table.source).of;
  if (table.rows() == 0) throw InputError(table.source + ": has no rows");
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const Directions<double> d = arrays.view();
  std::vector<Row> rows;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    Row row;
    row.at = coordinates(glm::vec3(glm::dvec3(d.wi_x[k], d.wi_y[k], d.wi_z[k])),
                         glm::vec3(glm::dvec3(d.wo_x[k], d.wo_y[k], d.wo_z[k])));
    for (std::size_t c = 0; c < 3; ++c) row.value[int(c)] = float(table.values[colours[c]][k]);
    rows.push_back(row);
  }
  const auto table_rows = std::make_shared<const Rows>(merged(std::move(rows)));
  return [table_rows](const glm::vec3& wi, const glm::vec3& wo) {
    return wi.z > 0 && wo.z > 0 ? table_rows->mean_at(coordinates(wi, wo)) * wi.z : glm::vec3(0);
  };
}

}  // namespace brdf::render
