#include "fit/model/row_groups.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace brdf::fit {
namespace {

constexpr std::size_t kFewest = 2, kFew = 5, kMost = 1000;
constexpr double kSame = 1e-3;             // degrees: closer directions count as one
constexpr double kCell = 1, kSector = 30;  // degrees

// Uses whole numbers for steps below 1, so that 30 degrees are exactly 30.
double degrees_of(std::int32_t count, double step) {
  return step < 1 ? count / std::round(1 / step) : count * step;
}

// A direction in steps of theta and phi.
struct Key {
  std::int32_t theta = 0, phi = 0;
  friend auto operator<=>(const Key&, const Key&) = default;
};

struct PairKey {
  Key first, second;
  friend auto operator<=>(const PairKey&, const PairKey&) = default;
};

struct Hash {
  // Gives the same result on every machine, whatever the width of its pointers.
  static std::uint64_t of(const PairKey& k) {
    std::uint64_t h = 0;
    for (std::int32_t v : {k.first.theta, k.first.phi, k.second.theta, k.second.phi})
      h = (h ^ std::uint32_t(v)) * 0x9e3779b97f4a7c15, h ^= h >> 29;
    return h;
  }
  std::size_t operator()(const PairKey& k) const { return std::size_t(of(k)); }
};

// At the normal, the azimuth is undefined and is set to 0.
Key key_of(const Vec3<double>& v, double theta_step, double phi_step) {
  const double theta = radians(std::atan2(std::hypot(v.x, v.y), v.z)).degrees();
  const double phi = radians(std::atan2(v.y, v.x)).degrees();
  const auto turn = std::int32_t(std::lround(360 / phi_step));
  Key key{std::int32_t(std::lround(theta / theta_step)), 0};
  if (key.theta != 0) key.phi = (std::int32_t(std::lround(phi / phi_step)) + turn) % turn;
  return key;
}

enum class Side { light, viewer, pair };

class Numbering {
 public:
  // Stops after more than `most` distinct directions.
  Numbering(const Directions<double>& d, std::size_t rows, Side of, double theta_step, double phi_step,
            std::size_t most)
      : side(of), theta_step_(theta_step), phi_step_(phi_step) {
    std::unordered_map<PairKey, std::uint32_t, Hash> number;
    group_of.reserve(rows);
    for (std::size_t k = 0; k < rows && keys.size() <= most; ++k) {
      PairKey key{key_of(side == Side::viewer ? d.wo(k) : d.wi(k), theta_step, phi_step), {}};
      if (side == Side::pair) key.second = key_of(d.wo(k), theta_step, phi_step);
      const auto [it, added] = number.try_emplace(key, std::uint32_t(keys.size()));
      if (added) keys.push_back(key);
      group_of.push_back(it->second);
    }
  }

  bool many() const { return keys.size() > kMost; }
  bool enough() const { return keys.size() >= kFewest; }

  RowGroups sorted() && {
    const std::vector<PairKey> turned = turned_keys();
    std::vector<std::uint32_t> order(keys.size()), place(keys.size());
    for (std::uint32_t g = 0; g < order.size(); ++g) order[g] = g;
    std::ranges::sort(order, [&](auto a, auto b) { return turned[a] < turned[b]; });
    const std::size_t folds = std::min(keys.size(), kMostFolds);
    std::vector<std::size_t> fold(keys.size());
    std::vector<std::uint32_t> dealt = order;
    if (keys.size() > folds)
      std::ranges::stable_sort(dealt,
                               [&](auto a, auto b) { return Hash::of(turned[a]) < Hash::of(turned[b]); });
    for (std::size_t k = 0; k < dealt.size(); ++k) fold[dealt[k]] = k % folds;
    std::ranges::stable_sort(order, [&](auto a, auto b) { return fold[a] < fold[b]; });
    RowGroups out{side == Side::viewer, side == Side::pair, {}, std::move(group_of), folds};
    out.held_out = side == Side::pair   ? HeldOut::interpolation
                   : keys.size() < kFew ? HeldOut::few
                                        : HeldOut::many;
    for (std::uint32_t k = 0; k < order.size(); ++k) {
      place[order[k]] = k;
      const Key& key = keys[order[k]].first;
      out.groups.push_back(
          {degrees_of(key.theta, theta_step_), degrees_of(key.phi, phi_step_), {}, fold[order[k]]});
    }
    for (std::uint32_t& g : out.group_of) ++out.groups[g = place[g]].range.rows;
    for (std::size_t g = 1; g < out.groups.size(); ++g)
      out.groups[g].range.first = out.groups[g - 1].range.first + out.groups[g - 1].range.rows;
    return out;
  }

  // Returns the keys with azimuths measured from the end of the largest gap between them. The second
  // azimuth of a pair is measured from the first.
  std::vector<PairKey> turned_keys() const {
    const auto turn = std::int32_t(std::lround(360 / phi_step_));
    std::vector<std::int32_t> azimuths;
    for (const PairKey& key : keys)
      if (key.first.theta != 0) azimuths.push_back(key.first.phi);
    std::ranges::sort(azimuths);
    std::int32_t start = azimuths.empty() ? 0 : azimuths.front();
    std::int32_t largest = azimuths.empty() ? 0 : azimuths.front() + turn - azimuths.back();
    for (std::size_t k = 1; k < azimuths.size(); ++k)
      if (const std::int32_t gap = azimuths[k] - azimuths[k - 1]; gap > largest)
        largest = gap, start = azimuths[k];
    std::vector<PairKey> out = keys;
    for (PairKey& key : out) {
      if (key.second.theta != 0) key.second.phi = (key.second.phi - key.first.phi + turn) % turn;
      if (key.first.theta != 0) key.first.phi = (key.first.phi - start + turn) % turn;
    }
    return out;
  }

  Side side;
  std::vector<PairKey> keys;
  std::vector<std::uint32_t> group_of;

 private:
  double theta_step_, phi_step_;
};

}  // namespace

RowRange rows_of_fold(const RowGroups& groups, std::size_t fold) {
  RowRange out;
  for (const RowGroup& g : groups.groups) {
    if (g.fold != fold) continue;
    if (out.rows == 0) out.first = g.range.first;
    out.rows += g.range.rows;
  }
  return out;
}

RowGroups group_rows(const Directions<double>& d, std::size_t rows) {
  Numbering light(d, rows, Side::light, kSame, kSame, kMost);
  Numbering viewer(d, rows, Side::viewer, kSame, kSame, kMost);
  const bool light_will_do = light.enough() && !light.many(),
             viewer_will_do = viewer.enough() && !viewer.many(),
             one_stood_still = light.keys.size() == 1 || viewer.keys.size() == 1;
  const auto grouped = [&](Numbering& by) {
    RowGroups out = std::move(by).sorted();
    if (one_stood_still) out.held_out = HeldOut::interpolation;
    return out;
  };
  if (viewer_will_do && !(light_will_do && light.keys.size() <= viewer.keys.size())) return grouped(viewer);
  if (light_will_do) return grouped(light);
  for (const Numbering* many : {&light, &viewer}) {
    if (!many->many()) continue;
    Numbering cells(d, rows, many->side, kCell, kSector, rows);
    if (cells.enough()) return std::move(cells).sorted();
  }
  return Numbering(d, rows, Side::pair, kSame, kSame, rows).sorted();
}

}  // namespace brdf::fit
