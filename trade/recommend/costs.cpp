#include "trade/recommend/costs.h"

#include "trade/questions/evaluations.h"
#include "trade/questions/materials.h"
#include "trade/questions/variants.h"

namespace brdf::trade {
namespace {

constexpr int kRounds = 41;

const LedgerRow* form_row(const Ledger& ledger, const Reflectance& form) {
  return ledger.find(names::families(names::kReferenceForm), info(form).name);
}

// Returns ns per evaluation, or std::nullopt if the ledger lacks the row.
std::optional<double> read_cost(const Ledger& ledger, const Reflectance& model) {
  const std::optional<Variant> variant = find_variant(model);
  if (!variant && catalogue_index(model) < 0) return std::nullopt;
  const LedgerRow* row = form_row(ledger, variant ? reference_form() : model);
  if (!row) return std::nullopt;
  const double ns = row->cost.seconds * 1e9;
  if (!variant) return ns;
  const LedgerRow* of_variant = ledger.find(names::kVariants, name_of(*variant));
  return of_variant ? std::optional(ns * of_variant->cost_ratio) : std::nullopt;
}

}  // namespace

Costs costs_of(const std::vector<Reflectance>& models, const std::optional<Ledger>& ledger) {
  Costs costs;
  std::vector<Reflectance> timed{reference_form()};  // followed by the models without a known cost
  for (const Reflectance& model : models) {
    const std::optional<double> ns = ledger ? read_cost(*ledger, model) : std::nullopt;
    costs.ns.push_back(ns.value_or(0));
    costs.measured.push_back(!ns);
    if (!ns) timed.push_back(model);
  }
  if (timed.size() == 1) return costs;
  const EvaluationTimes times = evaluation_times(timed, kRounds);
  const std::optional<double> read = ledger ? read_cost(*ledger, timed[0]) : std::nullopt;
  const double reference_ns = read.value_or(times.timings[0].lower / times.count * 1e9);
  for (std::size_t k = 0, next = 1; k < models.size(); ++k)
    if (costs.measured[k]) costs.ns[k] = reference_ns * times.timings[next++].ratio;
  return costs;
}

}  // namespace brdf::trade
