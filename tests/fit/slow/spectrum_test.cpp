// Tests that the intervals of a spectrum have their nominal coverage.
#include <gtest/gtest.h>

#include "io/files/parallel.h"
#include "tests/fit/spectra.h"

namespace brdf::fit {
namespace {

TEST(SpectrumSlow, TheIntervalsOfF0CoverTheTruthInBandsTimesReplicates) {
  const Material truth = metal_of_31_bands();
  FitOptions options;
  options.metric = Metric::log_relative;
  options.cross_validation = false;
  constexpr int kReplicates = 100;  // a fit with the profiles of 94 parameters takes several seconds
  int covered = 0, all = 0;
  const auto fitted = [&](int k) {
    return fit_one(measured(truth, {"hemisphere"}, 0.02, std::uint64_t(k + 1)), {"cook_torrance"}, options);
  };
  const auto count = [&](const FormFit& f) {
    for (const Estimate& e : f.estimates) {
      if (e.name != "f0") continue;
      const auto band = std::size_t(std::find(truth.channels.begin(), truth.channels.end(), e.channel) -
                                    truth.channels.begin());
      const double f0 = truth.terms[0].weights.at(band)[2];
      covered += e.low <= f0 && f0 <= e.high;
      ++all;
    }
  };
  io::parallel_in_order(kReplicates, int(io::all_processors()), {}, fitted, count);
  std::printf("seeds 1 to %d: %d of %d intervals of f0 cover it, %.2f %%\n", kReplicates, covered, all,
              100.0 * covered / all);
  ASSERT_EQ(all, 31 * kReplicates);
  EXPECT_GE(covered, 0.92 * all);
  EXPECT_LE(covered, 0.98 * all);
}

}  // namespace
}  // namespace brdf::fit
