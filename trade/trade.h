// The work of `brdf trade`: measures every row and judges the documents' claims.
#pragma once

#include <functional>
#include <string>

#include "trade/ledger/ledger.h"

namespace brdf::trade {

struct TradeOptions {
  bool quick = false;
  // Kernels, batches, families, fits, frames, or questions with names that contain this text.
  std::string only;
  std::function<void(double fraction, const std::string& what)> progress = [](double, const std::string&) {};
};

// Measures the ledger. Without a Vulkan driver, the rows of frames and shaders are left out, and the ledger
// records the omission. Throws EnvironmentError if only these rows are requested.
Ledger measure_ledger(const TradeOptions& options);

// Returns the ledger as text for the terminal: per question the front and the dominated rows.
std::string to_terminal(const Ledger& ledger);

}  // namespace brdf::trade
