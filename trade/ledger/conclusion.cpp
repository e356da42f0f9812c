#include "trade/ledger/conclusion.h"

#include "io/files/numbers.h"

namespace brdf::trade {
namespace {

constexpr double kCheaper = 0.95;  // of the exact choice's cost; smaller savings may be chance

std::string named(const LedgerRow& row) {
  return row.choice + " at " + io::short_number(row.cost_ratio, 2) + " of the exact cost (largest error " +
         (row.error.max <= kExact ? "none" : io::short_number(row.error.max, 2)) + ")";
}

}  // namespace

const LedgerRow* cheapest_within(const std::vector<const LedgerRow*>& rows, double mean_error) {
  const LedgerRow* best = nullptr;
  for (const LedgerRow* row : rows)
    if (row->choice != row->exact && row->cost.rounds > 0 && row->error.mean <= mean_error &&
        row->cost_ratio < kCheaper && (!best || row->cost_ratio < best->cost_ratio))
      best = row;
  return best;
}

std::string conclusion(const std::vector<const LedgerRow*>& rows) {
  const LedgerRow *coarse = cheapest_within(rows, 1e-2), *fine = cheapest_within(rows, 1e-4);
  const std::string exact = rows.front()->exact;
  if (!coarse) return "No cheaper choice has a mean error below 0.01: use " + exact + ".";
  const std::string within = "The cheapest choice with a mean error below 0.01 is " + named(*coarse);
  if (coarse == fine) return within + "; its mean error is also below 0.0001.";
  return within + "; below 0.0001 " +
         (fine ? "it is " + named(*fine) : "no choice is cheaper than " + exact) + ".";
}

}  // namespace brdf::trade
