// What the ledger's rows say, in words.
#pragma once

#include <string>
#include <vector>

#include "trade/ledger/ledger.h"

namespace brdf::trade {

// Means up to this are exact: nothing but the rounding of double precision.
inline constexpr double kExact = 1e-14;

// The cheapest of a question's rows whose mean error is at most this, if it costs less than 0.95 of the exact
// way; else null. Rows whose cost was not measured are left out.
const LedgerRow* cheapest_within(const std::vector<const LedgerRow*>& rows, double mean_error);

// What to take at 1 % and at 0.01 % of mean error, one sentence.
std::string conclusion(const std::vector<const LedgerRow*>& rows);

}  // namespace brdf::trade
