#include "sheet/view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nanoflann.hpp>
#include <tuple>

#include "io/files/numbers.h"
#include "io/samples/in_plane.h"

namespace brdf::sheet {
namespace {

// Angles are compared in units of 1e-4 degrees, so that 10.0 and 9.9999999 are equal.
std::int64_t same(double angle) {
  return std::llround(angle * 1e4);
}

io::SampleTable only(const io::SampleTable& t, const std::vector<Row>& rows) {
  const auto take = [&](const auto& column) {
    std::decay_t<decltype(column)> out;
    if (column.empty()) return out;
    out.reserve(rows.size());
    for (const Row k : rows) out.push_back(column[k]);
    return out;
  };
  io::SampleTable out;
  out.channels = t.channels;
  out.theta_i = take(t.theta_i);
  out.phi_i = take(t.phi_i);
  out.theta_o = take(t.theta_o);
  out.phi_o = take(t.phi_o);
  for (const auto& column : t.values) out.values.push_back(take(column));
  for (const auto& column : t.sigma) out.sigma.push_back(take(column));
  out.lines = take(t.lines);
  out.source = t.source;
  out.format = t.format;
  return out;
}

// Returns the rows of each light, by its angles, in the order of the file; empty if there are more than
// `most` lights.
std::vector<std::vector<Row>> rows_of_lights(const io::SampleTable& t, std::size_t most) {
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Row>> lights;
  std::vector<Row>* last = nullptr;  // in most files the rows of one light are consecutive
  Row of_last = 0;
  for (Row k = 0; k < t.rows(); ++k) {
    if (!last || t.theta_i[k] != t.theta_i[of_last] || t.phi_i[k] != t.phi_i[of_last])
      last = &lights[{same(t.theta_i[k]), same(std::remainder(t.phi_i[k], 360.0))}];
    last->push_back(of_last = k);
    if (lights.size() > most) return {};
  }
  std::vector<std::vector<Row>> out;
  for (auto& [light, rows] : lights) out.push_back(std::move(rows));
  return out;
}

// Returns for each of these rows the number of earlier rows with the same direction. Along the normal all
// azimuths are one direction, which some grids repeat; this is not a second pass.
std::vector<std::size_t> passes_of(const io::SampleTable& t, const std::vector<Row>& rows) {
  std::vector<std::tuple<std::int64_t, std::int64_t, std::size_t>> order;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    const Row k = rows[j];
    if (t.theta_o[k] != 0) order.emplace_back(same(t.theta_o[k]), same(std::remainder(t.phi_o[k], 360.0)), j);
  }
  std::ranges::sort(order);
  std::vector<std::size_t> passes(rows.size(), 0);
  for (std::size_t n = 1; n < order.size(); ++n) {
    const auto& [theta, phi, j] = order[n];
    const auto& [theta_before, phi_before, j_before] = order[n - 1];
    if (theta == theta_before && phi == phi_before) passes[j] = passes[j_before] + 1;
  }
  return passes;
}

}  // namespace

// The directions of a scan's viewers, with the interface that nanoflann requires.
class View::Directions {
 public:
  Directions(const io::SampleTable& t, const std::vector<Row>& rows) : index_(3, *this) {
    for (const Row k : rows) places_.push_back(direction(degrees(t.theta_o[k]), degrees(t.phi_o[k])));
    index_.buildIndex();
  }
  Directions(const Directions&) = delete;
  Directions& operator=(const Directions&) = delete;

  std::size_t kdtree_get_point_count() const { return places_.size(); }
  double kdtree_get_pt(std::size_t place, std::size_t axis) const {
    const Vec3<double>& p = places_[place];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
  // Finds the `count` nearest places, including the place itself; returns their number.
  std::size_t nearest(std::size_t place, std::size_t count, std::uint32_t* found) const {
    const std::array<double, 3> at{places_[place].x, places_[place].y, places_[place].z};
    std::array<double, View::kNeighbours + 1> squared;
    return index_.knnSearch(at.data(), count, found, squared.data());
  }

 private:
  std::vector<Vec3<double>> places_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Directions>, Directions, 3> index_;
};

View::~View() = default;

View::View(const io::SampleTable& read, const std::vector<bool>& keep) : read_(read) {
  if (std::ranges::find(keep, false) != keep.end()) {
    for (std::size_t k = 0; k < read.rows(); ++k)
      if (keep[k]) origin_.push_back(Row(k));
    kept_ = only(read, origin_);
    if (origin_.empty()) origin_.push_back(0);  // no row of an empty table is requested
  }
  const io::SampleTable& t = table();
  turns_.resize(t.rows());
  for (std::size_t k = 0; k < t.rows(); ++k) turns_[k] = std::remainder(t.phi_o[k] - t.phi_i[k], 360.0);
  find_levels();
  find_scans();
}

void View::find_levels() {
  constexpr double kUsable = 0.9;
  const io::SampleTable& t = table();
  std::vector<std::size_t> positive, usable;
  double least = HUGE_VAL;
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const std::vector<double>& v = t.values[c];
    positive.push_back(std::size_t(std::ranges::count_if(v, [](double x) { return x > 0; })));
    if (double(positive[c]) >= kUsable * double(t.rows())) usable.push_back(c);
    if (const double middle = io::median(v); middle < least) {
      least = middle;
      darkest_ = c;
    }
  }
  if (usable.empty() && !positive.empty())
    usable.push_back(std::size_t(std::ranges::max_element(positive) - positive.begin()));
  levels_.assign(t.rows(), 0);
  for (const std::size_t c : usable)
    for (std::size_t k = 0; k < t.rows(); ++k)
      levels_[k] += t.values[c][k] > 0 ? std::log(t.values[c][k]) / double(usable.size()) : std::nan("");
}

void View::find_scans() {
  const io::SampleTable& t = table();
  const auto lights = rows_of_lights(t, kMostLights);
  if (!lights.empty()) places_.resize(t.rows());
  for (const std::vector<Row>& rows : lights) {
    const std::vector<std::size_t> passes = passes_of(t, rows);
    const std::size_t first = scans_.size();
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const Row k = rows[j];
      const std::size_t of = first + passes[j];
      while (scans_.size() <= of) scans_.push_back({t.theta_i[rows.front()], t.phi_i[rows.front()], {}});
      places_[k] = {std::uint32_t(of), std::uint32_t(scans_[of].rows.size())};
      scans_[of].rows.push_back(k);
    }
  }
}

std::span<const Row> View::near(std::size_t row) const {
  if (scans_.empty()) return {};
  if (near_.empty()) {
    near_.resize(table().rows());
    trees_.resize(scans_.size());
  }
  Found& found = near_[row];
  const Place& place = places_[row];
  const std::vector<Row>& rows = scans_[place.scan].rows;
  if (found.count == Found::kNotYet) {
    found.count = 0;
    if (rows.size() < kFewestRows) return {};
    auto& tree = trees_[place.scan];
    if (!tree) tree = std::make_unique<const Directions>(table(), rows);
    std::array<std::uint32_t, kNeighbours + 1> nearest;
    const std::size_t count = tree->nearest(place.index, nearest.size(), nearest.data());
    for (std::size_t n = 0; n < count && found.count < kNeighbours; ++n)
      if (nearest[n] != place.index) found.rows[found.count++] = rows[nearest[n]];
  }
  return {found.rows.data(), found.count};
}

std::vector<InPlane> in_plane(const View& view, const Scan& scan) {
  std::vector<InPlane> line;
  bool has_normal = false;
  for (const Row k : scan.rows) {
    const double angle = io::in_plane_angle(view.table(), k);
    if (std::isnan(angle) || (view.table().theta_o[k] == 0 && std::exchange(has_normal, true))) continue;
    line.push_back({angle, k});
  }
  std::ranges::sort(line, {}, &InPlane::angle);
  return line;
}

}  // namespace brdf::sheet
