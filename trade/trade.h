// What `brdf trade` does: measures every row and judges the documents' claims.
#pragma once

#include <functional>
#include <string>

#include "trade/ledger/ledger.h"

namespace brdf::trade {

struct TradeOptions {
  bool quick = false;
  std::string only;  // kernels, batches, families, fits, frames, or questions whose name contains this
  std::function<void(double fraction, const std::string& what)> progress = [](double, const std::string&) {};
};

// Without a Vulkan driver the rows of frames and shaders are left out, and the ledger says so; where only
// those are wanted it throws EnvironmentError.
Ledger measure_ledger(const TradeOptions& options);

// The ledger for people: per question the front and what is dominated.
std::string to_terminal(const Ledger& ledger);

}  // namespace brdf::trade
