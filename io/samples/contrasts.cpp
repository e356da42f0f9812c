#include "io/samples/contrasts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "io/samples/degrees.h"

namespace brdf::io {
namespace {

constexpr double kStepsPerDegree = 1000;
constexpr std::int32_t kHalfTurn = 180000, kTurn = 2 * kHalfTurn;

std::int32_t unit(double angle) {
  return std::int32_t(std::lround(angle * kStepsPerDegree));
}

std::int32_t azimuth_unit(double angle) {
  const std::int32_t u = unit(std::fmod(angle, 360.0)) % kTurn;
  return u < 0 ? u + kTurn : u;
}

std::uint64_t mixed(std::uint64_t x) {  // the finalizer of SplitMix64 (Steele, Lea and Flood 2014)
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

using Key = std::array<std::int32_t, 4>;
constexpr std::ptrdiff_t kScanOfPairs = 3;  // members of a pair's key that identify the scan of the pairs

bool in_pairs(Neighbours n) {
  return n == Neighbours::repeated || n == Neighbours::mirrored || n == Neighbours::reciprocal;
}

// Returns one of 4096 buckets, chosen by the scan.
std::size_t bucket_of(const Key& key, Neighbours n) {
  const auto both = [](std::int32_t a, std::int32_t b) {
    return std::uint64_t(std::uint32_t(a)) << 32 | std::uint32_t(b);
  };
  return mixed(mixed(both(key[0], key[1])) ^ both(key[2], in_pairs(n) ? 0 : key[3])) >> 52;
}

// Converts a polar angle to a signed one, so that one scan passes through the normal.
void put_polar(std::int32_t theta, std::int32_t azimuth, std::int32_t& plane, std::int32_t& x) {
  const bool far = azimuth >= kHalfTurn;
  plane = far ? azimuth - kHalfTurn : azimuth;
  x = far ? -theta : theta;
}

}  // namespace

// A row on its scan. Rows with equal keys are on the same scan, ordered by x.
struct Contrasts::Place {
  Key key;
  std::int32_t x;
  std::uint32_t row;
};

namespace {

// Returns the divided difference of the values at these places, with weights scaled so that their squares
// add to 1.
template <class Place>
Contrast divided_difference(std::span<const Place> places) {
  Contrast c;
  c.count = places.size();
  double squares = 0;
  for (std::size_t j = 0; j < c.count; ++j) {
    double product = 1;
    for (std::size_t m = 0; m < c.count; ++m)
      if (m != j) product *= (places[j].x - places[m].x) / kStepsPerDegree;
    c.rows[j] = places[j].row;
    c.weights[j] = 1 / product;
    squares += c.weights[j] * c.weights[j];
  }
  for (std::size_t j = 0; j < c.count; ++j) c.weights[j] /= std::sqrt(squares);
  return c;
}

template <class Place>
void along_scans(std::span<const Place> places, std::size_t first_order, const Contrasts::Use& use) {
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    while (end < places.size() && places[end].key == places[begin].key) ++end;
    for (std::size_t order = first_order; order <= kMostOrder; ++order)
      for (std::size_t k = begin; k + order < end; ++k)
        use(order, divided_difference(places.subspan(k, order + 1)));
  }
}

template <class Place>
// Repeated rows follow no common function along a scan, so that any two pairs of them count as neighbours.
void of_pairs(std::span<const Place> places, std::ptrdiff_t scan, const Contrasts::Use& use) {
  const double half = 0.5, one = std::sqrt(half);
  const Place* before = nullptr;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const Place &a = places[k], &b = places[k + 1];
    if (a.key != b.key) continue;
    use(1, {{a.row, b.row}, {one, -one}, 2});
    if (before && std::equal(a.key.begin(), a.key.begin() + scan, before->key.begin()))
      use(2, {{before[0].row, before[1].row, a.row, b.row}, {half, -half, -half, half}, 4});
    before = &a;
  }
}

}  // namespace

Contrasts::Contrasts(const SampleTable& table, std::span<const std::uint32_t> rows)
    : table_(table), rows_(rows) {
  units_.reserve(rows.size());
  for (const std::uint32_t k : rows)
    units_.push_back({unit(table.theta_i[k]), azimuth_unit(table.phi_i[k]), unit(table.theta_o[k]),
                      azimuth_unit(table.phi_o[k])});
}

void Contrasts::for_each(Neighbours neighbours, std::size_t most, const Use& use) {
  const bool by_half_vector = std::ranges::find(kOfHalfVectors, neighbours) != kOfHalfVectors.end();
  if (by_half_vector && half_.empty())
    for (const std::uint32_t k : rows_) {
      const Vec3<double> wi = unit_vector(table_.theta_i[k], table_.phi_i[k]),
                         wo = unit_vector(table_.theta_o[k], table_.phi_o[k]), h = wi + wo;
      const double across = std::hypot(h.x, h.y), length = std::hypot(across, h.z);
      // The incident direction in the frame of the half vector: along its meridian, and perpendicular to
      // the meridian.
      const double along =
          across > 0 ? (h.z * (h.x * wi.x + h.y * wi.y) / across - across * wi.z) / length : wi.x;
      const double aside = across > 0 ? (h.x * wi.y - h.y * wi.x) / across : wi.y;
      half_.push_back({unit(radians(std::atan2(across, h.z)).degrees()),
                       unit(radians(std::acos(std::min(length / 2, 1.0))).degrees()),
                       azimuth_unit(radians(std::atan2(aside, along)).degrees()) % kHalfTurn,
                       azimuth_unit(radians(std::atan2(h.y, h.x)).degrees())});
    }
  const std::vector<Place> found = places(neighbours, most);
  const std::span<const Place> all(found);
  if (in_pairs(neighbours))
    of_pairs(all, neighbours == Neighbours::repeated ? 0 : kScanOfPairs, use);
  else
    along_scans(all, neighbours == Neighbours::turn ? 1 : 2, use);
}

// Computes the place of a row. Returns false if the row is on no scan of this kind.
bool Contrasts::place(std::size_t index, Neighbours neighbours, Place& p) const {
  const auto& [ti, pi, to, po] = units_[index];
  const std::int32_t turned = (po - pi + kTurn) % kTurn, apart = std::min(turned, kTurn - turned);
  p.row = rows_[index];
  switch (neighbours) {
    case Neighbours::repeated:
      p.key = {ti, pi, to, po};
      p.x = 0;
      return true;
    case Neighbours::viewer_polar:
      p.key = {ti, pi, 0, 0};
      put_polar(to, po, p.key[2], p.x);
      return true;
    case Neighbours::viewer_azimuth:
      p.key = {ti, pi, to, 0};
      p.x = turned;
      return to != 0;
    case Neighbours::light_polar:
      p.key = {to, po, 0, 0};
      put_polar(ti, pi, p.key[2], p.x);
      return true;
    case Neighbours::light_azimuth:
      p.key = {to, po, ti, 0};
      p.x = turned;
      return ti != 0;
    case Neighbours::turn:
      p.key = {ti, to, turned, 0};
      p.x = pi;
      return true;
    case Neighbours::mirrored:
      p.key = {ti, pi, to, apart};
      p.x = turned != apart;
      return ti != 0 && to != 0 && apart != 0 && apart != kHalfTurn;
    case Neighbours::reciprocal:
      p.key = {std::min(ti, to), apart, pi, std::max(ti, to)};
      p.x = ti > to;
      return ti != to;
    default:
      return place_by_half_vector(index, neighbours, p);
  }
}

bool Contrasts::place_by_half_vector(std::size_t index, Neighbours neighbours, Place& p) const {
  const auto& [half, difference, azimuth, turn] = half_[index];
  if (neighbours == Neighbours::half_polar) {
    p.key = {difference, azimuth, turn, 0};
    p.x = half;
  } else if (neighbours == Neighbours::difference_polar) {
    p.key = {half, azimuth, turn, 0};
    p.x = difference;
  } else {
    p.key = {half, difference, turn, 0};
    p.x = azimuth;
  }
  return true;
}

// Returns a pseudo-random number from the values of a row. Among several rows of the same directions the
// row with the smallest number is taken, which does not depend on the order of rows.
std::uint64_t Contrasts::lot(std::uint32_t row) const {
  std::uint64_t h = 0;
  for (const std::vector<double>& column : table_.values)
    h = mixed(h ^ std::bit_cast<std::uint64_t>(column[row]));
  return h;
}

// Returns the places on whole scans, sorted. Each place appears once, or twice for Neighbours::repeated.
std::vector<Contrasts::Place> Contrasts::places(Neighbours neighbours, std::size_t most) const {
  std::vector<std::size_t> counts(4096);
  std::size_t end = counts.size(), taken = 0;
  Place p;
  if (rows_.size() > most) {
    for (std::size_t k = 0; k < rows_.size(); ++k)
      if (place(k, neighbours, p)) ++counts[bucket_of(p.key, neighbours)];
    for (end = 0; end < counts.size() && taken < most; ++end) taken += counts[end];
  }
  std::vector<Place> all;
  for (std::size_t k = 0; k < rows_.size(); ++k)
    if (place(k, neighbours, p) && (end == counts.size() || bucket_of(p.key, neighbours) < end))
      all.push_back(p);
  std::ranges::sort(
      all, [](const Place& a, const Place& b) { return a.key != b.key ? a.key < b.key : a.x < b.x; });
  return neighbours == Neighbours::repeated ? two_each(all) : one_each(all);
}

// Keeps one of several rows of the same directions.
std::vector<Contrasts::Place> Contrasts::one_each(std::span<const Place> sorted) const {
  std::vector<Place> single;
  for (const Place& next : sorted)
    if (single.empty() || single.back().key != next.key || single.back().x != next.x)
      single.push_back(next);
    else if (lot(next.row) < lot(single.back().row))
      single.back().row = next.row;
  return single;
}

// Keeps two rows with different values of each group of the same directions.
std::vector<Contrasts::Place> Contrasts::two_each(std::span<const Place> sorted) const {
  std::vector<Place> pairs;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end].key == sorted[begin].key) ++end;
    std::map<std::uint64_t, Place> different;
    for (std::size_t k = begin; end - begin > 1 && k < end; ++k)
      different.emplace(lot(sorted[k].row), sorted[k]);
    if (different.size() < 2) continue;
    pairs.push_back(different.begin()->second);
    pairs.push_back(std::next(different.begin())->second);
  }
  return pairs;
}

}  // namespace brdf::io
