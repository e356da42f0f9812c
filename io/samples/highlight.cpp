#include "io/samples/highlight.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "io/files/numbers.h"
#include "io/samples/degrees.h"

namespace brdf::io {
namespace {

constexpr double kNoSum = -std::numeric_limits<double>::infinity();

// The largest sums over the channels on both sides, for one incident direction.
struct Sides {
  double mirror = kNoSum, light = kNoSum;
};

double sum_of_row(const SampleTable& table, std::size_t row) {
  double sum = 0;
  for (const auto& column : table.values) sum += column[row];
  return sum;
}

}  // namespace

void check_highlight(SampleTable& table) {
  constexpr double kSteep = 20, kStandsOut = 1.25;
  std::map<std::pair<double, double>, Sides> lights;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (table.theta_i[k] < kSteep) continue;
    // The viewer is nearer the mirror direction if its azimuth is more than 90 degrees from the light's.
    const double side = sin_degrees(table.theta_o[k]) * cos_degrees(table.phi_o[k] - table.phi_i[k]);
    constexpr double kMiddle = 1e-6;
    if (std::abs(side) < kMiddle) continue;
    Sides& sides = lights[{table.theta_i[k], table.phi_i[k]}];
    double& largest = side < 0 ? sides.mirror : sides.light;
    largest = std::max(largest, sum_of_row(table, k));
  }
  std::size_t mirror = 0, light = 0;
  for (const auto& [direction, sides] : lights) {
    if (sides.mirror == kNoSum || sides.light == kNoSum) continue;
    mirror += sides.mirror > kStandsOut * sides.light;
    light += sides.light > kStandsOut * sides.mirror;
  }
  if (light > 2 * mirror)
    table.assume("the largest values are on the side of the incident light for " +
                 plural(light, "incident direction") +
                 ": the sample is retroreflective, or the azimuths of the file follow another convention");
}

}  // namespace brdf::io
