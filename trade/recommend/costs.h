// What an evaluation of each model costs: read from a ledger where it has the row, measured where it has not.
#pragma once

#include <optional>

#include "brdf/reflectance.h"
#include "trade/ledger/ledger.h"

namespace brdf::trade {

struct Costs {
  std::vector<double> ns;      // per evaluation, by model
  std::vector<bool> measured;  // now, and not read
};
// What the ledger lacks is timed beside the reference form, of which the ledger's time counts.
Costs costs_of(const std::vector<Reflectance>& models, const std::optional<Ledger>& ledger);

}  // namespace brdf::trade
