// Conclusions from the ledger's rows, as text.
#pragma once

#include <string>
#include <vector>

#include "trade/ledger/ledger.h"

namespace brdf::trade {

// A mean error up to this value counts as exact: it is caused only by rounding in double precision.
inline constexpr double kExact = 1e-14;

// Returns the cheapest row of a question with a mean error of at most `mean_error`, if its cost is below
// 0.95 of the exact choice's cost; otherwise null. Rows without a measured cost are ignored.
const LedgerRow* cheapest_within(const std::vector<const LedgerRow*>& rows, double mean_error);

// Returns one sentence that recommends a choice at 1 % and at 0.01 % of mean error.
std::string conclusion(const std::vector<const LedgerRow*>& rows);

}  // namespace brdf::trade
