// Two ledgers of one machine side by side: do the cost ratios agree?
#pragma once

#include "trade/ledger/ledger.h"

namespace brdf::trade {

inline constexpr double kLeastCompared = 1e-9;  // seconds; shorter calls are at the mercy of code placement
inline constexpr double kLargestDifference = 0.25;  // of cost ratios that agree

struct CostPair {
  std::string question, choice;
  Unit unit = Unit::evaluation;
  double before = 0, after = 0;  // cost ratios
  // Larger over smaller ratio, less 1.
  double difference() const;
};

struct Comparison {
  std::vector<CostPair> compared;  // rows of both ledgers above kLeastCompared in both, farthest apart first
  std::vector<std::string> missing;  // "question: choice", in one ledger only
  std::size_t shorter = 0;           // rows below kLeastCompared
  std::size_t apart() const;         // rows that differ by more than kLargestDifference
};

// Throws InputError where one of them is quick and the other is not.
Comparison compare(const Ledger& before, const Ledger& after);
io::Json to_json(const Comparison& comparison);
// The rows that differ most, and the counts.
std::string to_terminal(const Comparison& comparison);

}  // namespace brdf::trade
