#include "io/samples/mirror_side.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "io/columns/supplied.h"
#include "io/files/numbers.h"

namespace brdf::io {
namespace {

double sum_of_channels(const SampleTable& table, std::size_t row) {
  double sum = 0;
  for (const auto& column : table.values) sum += column[row];
  return sum;
}

// Returns the side of the largest value for one angle of incidence: 1 positive, -1 negative, 0 undecided.
// The largest value decides if it exceeds the largest value at the same angle on the other side, or the
// median if there is no such value, by the factor kStandsOut, and if it is near the angle of incidence.
int side_of_the_peak(const SampleTable& table, const std::vector<std::size_t>& rows, double theta_i) {
  constexpr double kReach = 6, kStandsOut = 1.25;
  std::vector<double> values;
  std::size_t peak = rows.front();
  for (const std::size_t k : rows) {
    values.push_back(sum_of_channels(table, k));
    if (values.back() > sum_of_channels(table, peak)) peak = k;
  }
  const double angle = table.theta_o[peak], value = sum_of_channels(table, peak);
  double opposite = -1;  // the largest value there
  for (const std::size_t k : rows)
    if (std::abs(table.theta_o[k] + angle) <= kReach)
      opposite = std::max(opposite, sum_of_channels(table, k));
  const double other = opposite >= 0 ? opposite : median(std::move(values));
  const bool is_near = std::abs(std::abs(angle) - theta_i) <= std::max(30.0, theta_i / 2);
  if (angle == 0 || !is_near || !(value > kStandsOut * other)) return 0;
  return angle > 0 ? 1 : -1;
}

struct Votes {
  int positive = 0, negative = 0;
};

Votes votes_of(const SampleTable& table) {
  // Nearer the normal both sides lie within one highlight.
  constexpr double kSteep = 20;
  std::map<double, std::vector<std::size_t>> lights;
  for (std::size_t k = 0; k < table.rows(); ++k) lights[table.theta_i[k]].push_back(k);
  Votes votes;
  for (const double least : {kSteep, kSteep / 2}) {
    for (const auto& [theta_i, rows] : lights) {
      if (theta_i < least) continue;
      const int side = side_of_the_peak(table, rows, theta_i);
      votes.positive += side > 0;
      votes.negative += side < 0;
    }
    if (votes.positive + votes.negative > 0) break;
  }
  return votes;
}

struct Decision {
  bool is_negative;  // the mirror side is at negative angles
  bool has_one_scale;
  std::string note;
};

Decision decide(const SampleTable& table, MirrorSide asked) {
  if (std::ranges::any_of(table.theta_i, [](double theta) { return theta < 0; }))
    return {false, true,
            "both angles have signs on the same scale (some angles of incidence are negative), so the mirror "
            "direction is at -theta_i"};
  if (asked != MirrorSide::automatic)
    return {asked == MirrorSide::negative, false,
            asked == MirrorSide::negative ? "negative viewing angles are on the mirror side, as requested"
                                          : "positive viewing angles are on the mirror side, as requested"};
  const Votes votes = votes_of(table);
  const std::string other = " (if not: --mirror-side ";
  if (votes.negative > 2 * votes.positive)
    return {true, false,
            "negative viewing angles are on the mirror side, because the largest values are there" + other +
                "positive, for a retroreflective sample)"};
  if (votes.positive > 2 * votes.negative)
    return {false, false,
            "positive viewing angles are on the mirror side, because the largest values are there" + other +
                "negative)"};
  return {false, false,
          "positive viewing angles are assumed to be on the mirror side, because the values do not decide" +
              other + "negative)"};
}

}  // namespace

void place_in_plane(SampleTable& table, MirrorSide asked) {
  const Decision decision = decide(table, asked);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double theta_o = decision.is_negative ? -table.theta_o[k] : table.theta_o[k];
    const bool is_back = theta_o < 0, is_turned = table.theta_i[k] < 0;
    // On one scale the positive side is at azimuth 0. A light without a sign is placed opposite the mirror
    // side.
    table.phi_i[k] += decision.has_one_scale && !is_turned ? 0 : 180;
    table.phi_o[k] += is_back ? 180 : 0;
    table.theta_i[k] = std::abs(table.theta_i[k]);
    table.theta_o[k] = std::abs(theta_o);
  }
  table.assume("two angles in the plane of incidence: " + decision.note);
}

}  // namespace brdf::io
