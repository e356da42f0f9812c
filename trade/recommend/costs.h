// Cost of an evaluation of each model: read from a ledger if it has the row, otherwise measured.
#pragma once

#include <optional>

#include "brdf/reflectance.h"
#include "trade/ledger/ledger.h"

namespace brdf::trade {

struct Costs {
  std::vector<double> ns;      // per evaluation, by model
  std::vector<bool> measured;  // true: measured now; false: read from the ledger
};
// Returns the costs. Models that the ledger lacks are timed together with the reference form, and their time
// is scaled by the ledger's time of the reference form.
Costs costs_of(const std::vector<Reflectance>& models, const std::optional<Ledger>& ledger);

}  // namespace brdf::trade
