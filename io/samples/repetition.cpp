#include "io/samples/repetition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <unordered_set>

#include "io/samples/degrees.h"
#include "io/samples/to_f_r.h"

namespace brdf::io {
namespace {

using Angles = std::array<double, 4>;

Angles angles_of(const SampleTable& t, std::size_t k) {
  return {t.theta_i[k], t.phi_i[k], t.theta_o[k], t.phi_o[k]};
}

// Returns four angles that are equal for all notations of a pair of directions.
Angles four_angles(const SampleTable& t, std::size_t k) {
  return {t.theta_i[k], t.theta_i[k] == 0 ? 0 : within_turn(t.phi_i[k]), t.theta_o[k],
          t.theta_o[k] == 0 ? 0 : within_turn(t.phi_o[k])};
}

// Returns whether the column writes some azimuth in two ways. A column with very many azimuths is assumed
// to do so.
bool has_turns(const std::vector<double>& azimuths) {
  constexpr std::size_t kMost = 5000;
  std::set<double> found;
  double last = std::nan("");
  for (const double phi : azimuths) {
    if (phi == last) continue;
    last = phi;
    if (found.insert(phi).second && found.size() > kMost) return true;
  }
  std::set<double> plain;
  for (const double phi : found)
    if (!plain.insert(within_turn(phi)).second) return true;
  return false;
}

bool in_one_turn(const std::vector<double>& azimuths) {
  return std::ranges::all_of(azimuths, [](double phi) { return phi >= 0 && phi < 360; });
}

bool have_turns(const std::vector<double>& azimuths) {
  return !in_one_turn(azimuths) && has_turns(azimuths);
}

bool have_same_values(const SampleTable& t, std::size_t a, std::size_t b) {
  for (const auto* columns : {&t.values, &t.sigma})
    for (const auto& column : *columns)
      if (!column.empty() && column[a] != column[b]) return false;
  return true;
}

// Hashes and compares rows by their directions and values.
struct Hash {
  const SampleTable* table;
  std::size_t operator()(std::size_t row) const {
    std::size_t hash = 0;
    const auto mix = [&](double x) {
      hash = (hash ^ (hash >> 29)) * 0x9E3779B97F4A7C15u + std::hash<double>()(x);
    };
    for (const double angle : four_angles(*table, row)) mix(angle);
    for (const auto& column : table->values) mix(column[row]);
    return hash ^ (hash >> 29);
  }
};
struct Same {
  const SampleTable* table;
  bool operator()(std::size_t a, std::size_t b) const {
    return four_angles(*table, a) == four_angles(*table, b) && have_same_values(*table, a, b);
  }
};

// Removes repeated rows among the rows that may repeat another one.
template <class MayRepeat, class IsWrittenTwice>
void leave_out(SampleTable& table, const MayRepeat& may_repeat, const IsWrittenTwice& is_written_twice) {
  std::unordered_set<std::size_t, Hash, Same> seen(0, Hash{&table}, Same{&table});
  std::vector<std::size_t> dropped;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (!may_repeat(k)) continue;
    const auto [first, is_new] = seen.insert(k);
    if (!is_new && !is_written_twice(*first, k)) dropped.push_back(k);
  }
  const std::size_t repeated = dropped.size();
  if (repeated == 0) return;
  std::vector<std::size_t> kept;
  auto next = dropped.begin();
  for (std::size_t k = 0; k < table.rows(); ++k)
    if (next == dropped.end() || k != *next)
      kept.push_back(k);
    else
      ++next;
  keep_rows(table, kept);
  table.warnings.push_back(std::to_string(repeated) + (repeated == 1 ? " row repeats" : " rows repeat") +
                           " a direction with the same values (azimuths of 0 and 360 degrees, or any azimuth "
                           "along the normal) and " +
                           (repeated == 1 ? "is" : "are") + " left out");
}

}  // namespace

void leave_out_repetitions(SampleTable& table) {
  const bool any_row = have_turns(table.phi_i) || have_turns(table.phi_o);
  leave_out(
      table, [&](std::size_t k) { return any_row || table.theta_i[k] == 0 || table.theta_o[k] == 0; },
      [&](std::size_t a, std::size_t b) { return angles_of(table, a) == angles_of(table, b); });
}

void leave_out_repetitions(SampleTable& table,
                           const std::function<bool(std::size_t, std::size_t)>& is_written_twice) {
  leave_out(
      table, [](std::size_t) { return true; }, is_written_twice);
}

}  // namespace brdf::io
