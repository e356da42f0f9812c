// Tests how often equal surfaces are called different, how often different ones are, and how often the
// consensus of whole tables holds the truth. The tables have the errors that their budgets state.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <iostream>
#include <random>

#include "../laboratories.h"
#include "fit/between/difference.h"
#include "fit/between/round_robin.h"
#include "io/files/parallel.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kPairs = 400;

// Returns a pair of tables. `alpha`: width of the second surface.
std::vector<TableToFit> drawn_pair(double alpha, const Structure& structure, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<TableToFit> tables;
  for (int which = 0; which < 2; ++which)
    tables.push_back({{laboratory(gloss(which == 0 ? 0.25 : alpha), which == 0 ? 0 : 2.5,
                                  drawn_errors(0.01, 0.15, 0.005, random), random, structure),
                       {},
                       budget_of(0.01, 0.15, 0.005)},
                      laboratory_options()});
  return tables;
}

// Returns the share of pairs with a property, in per cent.
double share_of_pairs(double alpha, const Structure& structure, std::uint64_t seed,
                      const std::function<bool(std::vector<TableToFit>&)>& has) {
  std::atomic<std::size_t> count = 0;
  io::parallel_for(kPairs, [&](std::size_t k) {
    std::vector<TableToFit> tables = drawn_pair(alpha, structure, seed * 10000 + k);
    count += has(tables);
  });
  return 100.0 * double(count) / double(kPairs);
}

// Returns the share of pairs that are called different.
double alarms(double alpha, const Structure& structure, std::uint64_t seed) {
  return share_of_pairs(alpha, structure, seed, [](std::vector<TableToFit>& tables) {
    const Difference d = difference_of(fit_tables(tables, laboratory_model()), tables);
    EXPECT_EQ(d.obstacle, "");
    return d.sameness == Sameness::different;
  });
}

// Returns the share of pairs for which the intervals of some parameter from the scatter alone exclude each
// other.
double exclusions(const Structure& structure, std::uint64_t seed) {
  return share_of_pairs(0.25, structure, seed, [](std::vector<TableToFit>& tables) {
    for (TableToFit& t : tables) t.samples.budget = nullptr;
    const FittedTables fits = fit_tables(tables, laboratory_model());
    const std::vector<Estimate>&a = fits.tables[0].fit.estimates, &b = fits.tables[1].fit.estimates;
    for (std::size_t k = 0; k < a.size(); ++k)
      if (a[k].status == Status::free && (a[k].high < b[k].low || b[k].high < a[k].low)) return true;
    return false;
  });
}

TEST(Difference, IsAnAlarmForFewEqualPairs) {
  const double exact = alarms(0.25, no_structure, 1), structured = alarms(0.25, structure_of_3_percent, 2);
  std::cout << "equal pairs called different: " << exact << " %, with 3 % of structure " << structured
            << " %\n";
  const double excluded = exclusions(no_structure, 1), also_excluded = exclusions(structure_of_3_percent, 2);
  std::cout << "intervals of scatter alone exclude each other: " << excluded << " %, with structure "
            << also_excluded << " %\n";
  EXPECT_GE(excluded, 70);
  EXPECT_GE(also_excluded, 40);
  EXPECT_LE(exact, 7);
  EXPECT_LE(structured, 7);
  EXPECT_GE(exact, 0.5);  // the uncertainties are not exaggerated
}

TEST(Difference, OfFivePercentInTheWidthIsFound) {
  const double three = alarms(0.25 * 1.03, structure_of_3_percent, 3),
               five = alarms(0.25 * 1.05, structure_of_3_percent, 4);
  std::cout << "found: alpha + 3 % in " << three << " %, alpha + 5 % in " << five << " % of pairs\n";
  EXPECT_GE(three, 75);
  EXPECT_GE(five, 95);
}

TEST(RoundRobin, OfWholeTablesHoldsTheTruth) {
  constexpr std::size_t kRobins = 400;
  const std::vector<double> scales{0.004, 0.006, 0.008, 0.01, 0.012, 0.02};
  const std::vector<AskedDirections> at{{}};
  const double truth = std::log(values_at(gloss(), at)[0]);
  std::atomic<std::size_t> held = 0, decided = 0;
  io::parallel_for(kRobins, [&](std::size_t k) {
    std::mt19937_64 random(50000 + k);
    std::vector<TableToFit> tables;
    for (std::size_t j = 0; j < scales.size(); ++j)
      tables.push_back({{laboratory(gloss(), 0.5 * double(j),
                                    drawn_errors(std::hypot(scales[j], 0.01), 0.15, 0.005, random), random),
                         {},
                         budget_of(scales[j], 0.15, 0.005)},
                        laboratory_options()});
    const RoundRobin result = round_robin(fit_tables(tables, laboratory_model()), {at, {}});
    const RoundRobinQuantity& f = result.quantities.front();
    if (!f.consensus) return;
    ++decided;
    held += std::abs(f.consensus->value - truth) <= f.consensus->half_width;
  });
  const double coverage = 100.0 * double(held) / double(decided);
  std::cout << "the interval of f(0:45) holds the truth in " << coverage << " % of " << decided
            << " round robins\n";
  EXPECT_EQ(decided, kRobins);
  EXPECT_GE(coverage, 92);  // 400 round robins know a coverage to 1.1 %
  EXPECT_LE(coverage, 98);
}

}  // namespace
}  // namespace brdf::fit
