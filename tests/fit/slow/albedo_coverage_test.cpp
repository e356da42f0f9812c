// Tests the coverage of the interval of a derived value, the albedo of a fitted material.
#include <iostream>

#include "../albedo_coverage.h"

namespace brdf::fit {
namespace {

// For 500 replicates of each material, the interval must hold the truth 92 to 98 % of the time at every
// angle.
TEST(AlbedoInterval, CoversTheTruthIn92To98PercentOf500Replicates) {
  constexpr int kReplicates = 500;
  for (const CoverageCase& c : coverage_cases())
    for (const auto& [theta, covered] : covered_albedos(c, kReplicates, 17)) {
      const double share = double(covered.inside) / kReplicates;
      std::cout << "[ coverage ] " << c.form << ", albedo at " << theta << " degrees: " << 100 * share
                << " %\n";
      EXPECT_GE(share, 0.92) << c.form << " " << theta;
      EXPECT_LE(share, 0.98) << c.form << " " << theta;
    }
}

}  // namespace
}  // namespace brdf::fit
