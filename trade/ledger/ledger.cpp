#include "trade/ledger/ledger.h"

#include <fstream>
#include <thread>

namespace brdf::trade {
namespace {

constexpr double kSameCost = 0.05;  // smaller differences of cost are noise of the machine

bool no_worse(const Error& a, const Error& b) {
  return a.max <= b.max && a.mean <= b.mean && a.p99 <= b.p99;
}
bool better(const Error& a, const Error& b) {
  return a.max < b.max || a.mean < b.mean || a.p99 < b.p99;
}
bool dominates(const LedgerRow& a, const LedgerRow& b) {
  if (a.error.measure != b.error.measure || a.quantity != b.quantity) return false;
  if (a.image_error && b.image_error && *a.image_error > *b.image_error) return false;
  if (a.cost_ratio > b.cost_ratio * (1 + kSameCost) || !no_worse(a.error, b.error)) return false;
  return a.cost_ratio < b.cost_ratio * (1 - kSameCost) || better(a.error, b.error);
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

const LedgerRow* Ledger::find(std::string_view question, std::string_view choice) const {
  for (const LedgerRow& row : rows)
    if (row.question == question && row.choice == choice) return &row;
  return nullptr;
}

Machine this_machine() {
#ifdef BRDF_FEW_CLONES
  const char* const flags = BRDF_TRADE_FLAGS ", clones for x86-64-v3";
#else
  const char* const flags = BRDF_TRADE_FLAGS ", clones for x86-64-v3 and v4";
#endif
  return {processor_name(), "GCC " __VERSION__, flags, std::thread::hardware_concurrency()};
}

void mark_dominated(std::vector<LedgerRow>& rows) {
  for (LedgerRow& row : rows) {
    const LedgerRow* best = nullptr;
    for (const LedgerRow& other : rows)
      if (other.question == row.question && &other != &row && dominates(other, row) &&
          (!best || other.cost_ratio < best->cost_ratio))
        best = &other;
    row.dominated_by = best ? best->choice : "";
  }
}

}  // namespace brdf::trade
