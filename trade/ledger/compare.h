// Comparison of two ledgers of one machine: checks whether the cost ratios agree.
#pragma once

#include "trade/ledger/ledger.h"

namespace brdf::trade {

// Seconds. The time of shorter calls depends on code placement.
inline constexpr double kLeastCompared = 1e-9;
inline constexpr double kLargestDifference = 0.25;  // largest difference of cost ratios that agree

// The cost ratios of one row in both ledgers.
struct CostPair {
  std::string question, choice;
  Unit unit = Unit::evaluation;
  double before = 0, after = 0;  // cost ratios
  // Returns the larger ratio divided by the smaller ratio, minus 1.
  double difference() const;
};

// The result of compare().
struct Comparison {
  // Rows in both ledgers with costs above kLeastCompared, largest difference first.
  std::vector<CostPair> compared;
  std::vector<std::string> missing;  // "question: choice", in one ledger only
  std::size_t shorter = 0;           // number of rows below kLeastCompared
  std::size_t apart() const;         // number of rows that differ by more than kLargestDifference
};

// Throws InputError if one ledger is quick and the other is not.
Comparison compare(const Ledger& before, const Ledger& after);
io::Json to_json(const Comparison& comparison);
// Returns the rows that differ most, and the counts.
std::string to_terminal(const Comparison& comparison);

}  // namespace brdf::trade
