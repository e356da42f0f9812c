#include "sheet/scatter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "io/files/numbers.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

constexpr double kSteepest = 80;  // degrees
constexpr std::size_t kFewestPairsOfRows = 8;
constexpr double kCopies = 1e-6;  // values that agree this well were not measured twice

using Rows = std::vector<std::pair<Row, Row>>;
using Direction = std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t>;

// Rounds to thousandths of a degree.
std::int32_t unit(double angle) {
  return std::int32_t(std::lround(angle * 1e3));
}

bool is_far_from_grazing(const io::SampleTable& t, Row k) {
  return t.theta_i[k] <= kSteepest && t.theta_o[k] <= kSteepest;
}

// Returns the rows by their directions; for rows of the same directions, the first row.
std::map<Direction, Row> by_direction(const View& view, Rows& repeated) {
  std::map<Direction, Row> places;
  const io::SampleTable& t = view.table();
  // Very many rows are thinned; a pair keeps both partners or loses both.
  constexpr double kMost = 60'000, kGolden = 0.6180339887498949;
  const double share = kMost / double(t.rows());
  for (Row k = 0; k < t.rows(); ++k) {
    if (!is_far_from_grazing(t, k)) continue;
    const double lot = kGolden * std::round(t.theta_i[k] * 1e3) + 0.7071 * std::round(t.theta_o[k] * 1e3) +
                       0.4142 * std::round(std::abs(view.turn(k)) * 1e3);
    if (share < 1 && lot - std::floor(lot) >= share) continue;
    const Direction at{unit(t.theta_i[k]), unit(std::remainder(t.phi_i[k], 360.0)), unit(t.theta_o[k]),
                       t.theta_o[k] == 0 ? 0 : unit(view.turn(k))};
    const auto [first, is_new] = places.try_emplace(at, k);
    if (!is_new) repeated.emplace_back(first->second, k);
  }
  return places;
}

// Returns pairs of rows on both sides of the plane of incidence.
Rows mirrored_rows(const std::map<Direction, Row>& places) {
  constexpr std::int32_t kHalfTurn = 180000;
  Rows rows;
  for (const auto& [at, k] : places) {
    const auto& [theta_i, phi_i, theta_o, turn] = at;
    if (turn <= 0 || turn >= kHalfTurn) continue;
    if (const auto other = places.find({theta_i, phi_i, theta_o, -turn}); other != places.end())
      rows.emplace_back(k, other->second);
  }
  return rows;
}

void add_agreement(const View& view, std::string_view name, const Rows& rows, bool needs_isotropy,
                   Scatter& s) {
  std::vector<double> differences;
  for (const auto& [a, b] : rows)
    for (const std::vector<double>& v : view.table().values)
      if (v[a] > 0 && v[b] > 0)
        if (const double d = std::abs(std::log(v[a] / v[b])); d > kCopies) differences.push_back(d);
  const std::size_t values = rows.size() * view.table().channels.size();
  if (rows.size() < kFewestPairsOfRows || differences.size() < kFewestPairsOfRows ||
      2 * differences.size() < values)
    return;
  const std::size_t count = rows.size();
  s.agreements.push_back(
      {name, 1.4826 * io::median(std::move(differences)) / std::sqrt(2.0), count, needs_isotropy});
}

// Adds interpolated reciprocal pairs with an uncertainty of less than a fifth of the usual difference of
// pairs.
void add_interpolated(const View& view, const std::vector<Pair>& pairs, Scatter& s) {
  constexpr double kShare = 0.2;
  std::vector<double> all, sure;
  for (const Pair& p : pairs)
    if (is_far_from_grazing(view.table(), p.forward)) all.push_back(std::abs(p.log_ratio));
  if (all.empty()) return;
  const double usual = io::median(all);
  for (const Pair& p : pairs)
    if (is_far_from_grazing(view.table(), p.forward) && p.uncertainty < kShare * usual)
      sure.push_back(std::abs(p.log_ratio));
  if (sure.size() < kFewestPairsOfRows || 4 * sure.size() < all.size()) return;
  const std::size_t count = sure.size();
  s.agreements.push_back({"reciprocal", 1.4826 * io::median(std::move(sure)) / std::sqrt(2.0), count, true});
}

// The relative error of a standard deviation from n pairs is 1.2/sqrt(n). The margin is twice that, so that
// the largest of several is not due to chance.
double by_chance(const Agreement& a) {
  return 1 + 2.4 / std::sqrt(double(a.count));
}

}  // namespace

const Agreement* Scatter::decisive(bool may_be_isotropic) const {
  constexpr double kShape = 2;  // the neighbours' noise is known within a factor of 1.5
  const double about = neighbours.value.value_or(0);
  const bool counts = may_be_isotropic && isotropy != Isotropy::refuted;
  const Agreement *largest = nullptr, *smallest = nullptr;
  for (const Agreement& a : agreements) {
    const double chance = by_chance(a);
    if (a.needs_isotropy && about > kShape * chance * a.value && (!smallest || a.value < smallest->value))
      smallest = &a;
    if ((counts || !a.needs_isotropy) && a.value > about * chance && (!largest || a.value > largest->value))
      largest = &a;
  }
  return smallest ? smallest : largest;
}

std::optional<double> Scatter::value(bool may_be_isotropic) const {
  if (const Agreement* const a = decisive(may_be_isotropic)) return a->value;
  return neighbours.value;
}

std::optional<double> Scatter::least(bool may_be_isotropic) const {
  constexpr double kMost = 0.2;  // larger differences of symmetric rows are no noise of an instrument
  const Agreement* const a = decisive(may_be_isotropic);
  if (!a || !a->needs_isotropy || isotropy == Isotropy::seen || a->value < neighbours.value.value_or(0))
    return value(may_be_isotropic);
  if (neighbours.value) return neighbours.value;
  return a->value > kMost ? std::nullopt : std::optional(a->value);
}

Scatter scatter_of(const View& view, io::Noise neighbours, const std::vector<Pair>& pairs,
                   Isotropy isotropy) {
  Scatter s;
  s.isotropy = isotropy;
  s.neighbours = std::move(neighbours);
  if (view.scans().empty()) return s;  // no instrument scans such a table
  Rows repeated, reciprocal;
  const std::map<Direction, Row> places = by_direction(view, repeated);
  add_agreement(view, "repeated", repeated, false, s);
  add_agreement(view, "mirrored", mirrored_rows(places), true, s);
  for (const Pair& p : pairs)
    if (p.exact() && is_far_from_grazing(view.table(), p.forward))
      reciprocal.emplace_back(p.forward, p.backward);
  add_agreement(view, "reciprocal", reciprocal, true, s);
  if (reciprocal.size() < kFewestPairsOfRows) add_interpolated(view, pairs, s);
  return s;
}

}  // namespace brdf::sheet
