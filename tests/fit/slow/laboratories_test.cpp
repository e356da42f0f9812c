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

// Returns a table of each surface. `stated`: the noise that the budget states; the noise is 0.5 %.
std::vector<TableToFit> drawn_pair(const Material& first, const Material& second, const Structure& structure,
                                   double stated, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<TableToFit> tables;
  for (const Material* surface : {&first, &second})
    tables.push_back({{laboratory(*surface, tables.empty() ? 0 : 2.5, drawn_errors(0.01, 0.15, 0.005, random),
                                  random, structure),
                       {},
                       budget_of(0.01, 0.15, stated)},
                      laboratory_options()});
  return tables;
}

using Draw = std::function<std::vector<TableToFit>(std::uint64_t seed)>;

// Returns pairs of which the second surface has the width `alpha`.
Draw pairs(double alpha, const Structure& structure) {
  return [=](std::uint64_t seed) { return drawn_pair(gloss(), gloss(alpha), structure, 0.005, seed); };
}

// Returns the share of pairs with a property, in per cent.
double share_of_pairs(const Draw& draw, std::uint64_t seed,
                      const std::function<bool(std::vector<TableToFit>&)>& has) {
  std::atomic<std::size_t> count = 0;
  io::parallel_for(kPairs, [&](std::size_t k) {
    std::vector<TableToFit> tables = draw(seed * 10000 + k);
    count += has(tables);
  });
  return 100.0 * double(count) / double(kPairs);
}

// Returns the share of pairs that are called different.
double alarms(const Draw& draw, std::uint64_t seed) {
  return share_of_pairs(draw, seed, [](std::vector<TableToFit>& tables) {
    const Difference d = difference_of(fit_tables(tables, laboratory_model()), tables);
    EXPECT_EQ(d.obstacle, "");
    return d.sameness == Sameness::different;
  });
}

// Returns the share of pairs for which the intervals of some parameter from the scatter alone exclude each
// other.
double exclusions(const Structure& structure, std::uint64_t seed) {
  return share_of_pairs(pairs(0.25, structure), seed, [](std::vector<TableToFit>& tables) {
    for (TableToFit& t : tables) t.samples.budget = nullptr;
    const FittedTables fits = fit_tables(tables, laboratory_model());
    const std::vector<Estimate>&a = fits.tables[0].fit.estimates, &b = fits.tables[1].fit.estimates;
    for (std::size_t k = 0; k < a.size(); ++k)
      if (a[k].status == Status::free && (a[k].high < b[k].low || b[k].high < a[k].low)) return true;
    return false;
  });
}

TEST(Difference, IsAnAlarmForFewEqualPairs) {
  const double exact = alarms(pairs(0.25, no_structure), 1),
               structured = alarms(pairs(0.25, structure_of_3_percent), 2);
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

// Every value has its own noise, and the budget states the noise of a row, or leaves it to the scatter.
TEST(Difference, OfSpectraIsAnAlarmForFewEqualPairs) {
  for (const std::size_t channels : {3, 8})
    for (const double stated : {0.005, 0.0}) {
      const Material surface = spectral(channels), other = [&] {
        Material wider = surface;
        for (double& alpha : wider.terms[0].shape[0]) alpha *= 1.05;
        return wider;
      }();
      const auto drawn = [&](const Material& second) -> Draw {
        return [&, second](std::uint64_t seed) {
          return drawn_pair(surface, second, no_structure, stated, seed);
        };
      };
      const double equal = alarms(drawn(surface), 5 + channels), found = alarms(drawn(other), 7 + channels);
      std::cout << channels << " channels, noise of a row stated as " << stated << ": " << equal
                << " % of equal pairs called different, alpha + 5 % found in " << found << " %\n";
      EXPECT_LE(equal, 7);
      EXPECT_GE(found, 95);
    }
}

TEST(Difference, OfFivePercentInTheWidthIsFound) {
  const double three = alarms(pairs(0.25 * 1.03, structure_of_3_percent), 3),
               five = alarms(pairs(0.25 * 1.05, structure_of_3_percent), 4);
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
