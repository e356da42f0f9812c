#include "fit/assess/findings.h"

#include <map>

#include "io/numbers.h"
#include "io/text.h"

namespace brdf::fit {
namespace {

constexpr const char* kNeverTurned =
    "the sample was never turned (no two azimuths of it were measured under the same angles), so that a "
    "second width "
    "may be the form's own error: turn the sample, or fit without --anisotropic";

}  // namespace

std::string unidentified_finding(const std::vector<Reported>& all, const Grounds& on, const Uncertainty& u) {
  const auto names = names_with(all, Status::unidentified, on.model.channels().size());
  const std::string reason = on.unturned ? kNeverTurned : advice(all, on.model);
  if (u.determined())
    return "what the model gives at the samples is determined (standard error " +
           io::percent(*u.prediction_error) + "), how it divides into " + listed(names) +
           " is not: " + reason;
  return listed(names) + (names.size() > 1 ? " are" : " is") + " not identified: " + reason;
}

void add_bound_findings(const std::vector<Reported>& all, const Grounds& on, Uncertainty& out) {
  const Model& model = on.model;
  const std::size_t channels = model.channels().size();
  std::map<std::string, std::vector<std::string>> bounds;
  for (const Reported& r : all) {
    if (r.estimate.status != Status::at_bound) continue;
    const bool lower = r.estimate.value - r.min <= r.max - r.estimate.value;
    bounds[r.estimate.name + " is at its " + (lower ? "lower" : "upper") + " bound " +
           io::to_text(lower ? r.min : r.max)]
        .push_back(r.estimate.channel);
  }
  for (const auto& [text, list] : bounds) {
    const bool some = !list[0].empty() && list.size() < channels;
    out.findings.push_back(text + (some ? " in " + io::joined(list) : ""));
  }
  if (const NaturalWeights::Sum sum = model.bounded_sum(on.minimum.p); !sum.at_bound.empty()) {
    std::vector<std::string> where;
    for (const std::size_t channel : sum.at_bound) where.push_back(model.channels()[channel]);
    out.findings.push_back(sum.name + " is at its bound 1" +
                           (where.size() < channels ? " in " + io::joined(where) : "") + " (--physical)");
  }
}

}  // namespace brdf::fit
