#include "fit/assess/findings.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

constexpr const char* kNeverTurned =
    "the sample was never rotated (no two of its azimuths were measured at the same angles), so a second "
    "width may be an error of the form: rotate the sample, or fit without --anisotropic";

// Returns "ks f0 = 0.038 (0.034 to 0.043); " for every channel, or for the first ones of a spectrum.
std::string products_text(const std::vector<Estimate>& products) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < std::min(products.size(), kMost); ++k) {
    const Estimate& e = products[k];
    texts.push_back((products.size() > 1 ? label(e) : e.name) + " = " + io::short_number(e.value) + " (" +
                    extent_text(interval_of(e)) + ")");
  }
  if (texts.empty()) return "";
  return "identifiable in combination: " + listed(texts) + (products.size() > kMost ? " and so on" : "") +
         "; ";
}

}  // namespace

std::string unidentified_finding(const std::vector<Reported>& all, const Grounds& on, const Uncertainty& u) {
  const auto names = names_with(all, Status::unidentified, on.model.channels().size());
  const std::string reason = on.unturned ? kNeverTurned : products_text(u.products) + advice(all, on.model);
  if (u.determined())
    return "the fitted values at the measured directions are well determined (standard error " +
           io::percent(*u.prediction_error) + "), but their division into " + listed(names) +
           " is not identifiable: " + reason;
  return listed(names) + (names.size() > 1 ? " are" : " is") + " not identifiable: " + reason;
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

namespace {

constexpr double kFewRows = 4;  // effective number of rows below which a finding is added

// Returns the rows that contribute most to the variance of a parameter, by their positions in the table,
// counted from 1.
std::vector<std::size_t> deciding_rows(const Reported& r, const Grounds& on, const SampleStream& stream,
                                       std::size_t count) {
  const Eigen::VectorXd v = on.curvature.inverse * gradient_vector(r, on.curvature.inverse.rows());
  const auto [values, along] = stream.value_errors(on.minimum.p, matrix_of(v * v.transpose()));
  const auto slopes = stream.slopes_of(values);
  std::vector<std::pair<double, std::size_t>> parts;
  for (std::size_t k = 0; k < stream.data().rows(); ++k) {
    double part = 0;
    for (std::size_t c = 0; c < values.size(); ++c)
      part += square(square(slopes[c][k]) * values[c][k] * along[c][k]);
    parts.emplace_back(part, stream.data().row[k] + 1);
  }
  count = std::min(count, parts.size());
  std::ranges::partial_sort(parts, parts.begin() + std::ptrdiff_t(count), std::greater());
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < count; ++k) rows.push_back(parts[k].second);
  std::ranges::sort(rows);
  return rows;
}

}  // namespace

std::string few_rows_finding(const std::vector<Reported>& all, const Grounds& on,
                             const SampleStream& stream) {
  const Reported* fewest = nullptr;
  std::vector<std::string> names;
  for (const Reported& r : all) {
    const Estimate& e = r.estimate;
    const bool known = e.status == Status::free || e.status == Status::at_bound;
    if (!known || !(e.deciding < kFewRows)) continue;
    if (!fewest || e.deciding < fewest->estimate.deciding) fewest = &r;
    if (const bool tied = r.slot != kNoSlot && on.model.slots()[r.slot].members.size() > 1;
        std::ranges::find(names, tied ? on.model.slots()[r.slot].name : e.name) == names.end())
      names.push_back(tied ? on.model.slots()[r.slot].name : e.name);
  }
  if (!fewest) return "";
  const std::size_t count = std::max<std::size_t>(1, std::size_t(std::lround(fewest->estimate.deciding)));
  std::vector<std::string> rows;
  for (const std::size_t row : deciding_rows(*fewest, on, stream, count)) rows.push_back(std::to_string(row));
  const bool one = count == 1;
  return std::to_string(count) + (one ? " row determines " : " rows determine ") + listed(names) + " (" +
         (one ? "row " : "rows ") + listed(rows) +
         " of the table): " + (names.size() > 1 ? "their intervals assume" : "its interval assumes") +
         " that the noise of " + (one ? "this row" : "these rows") + " is like that of the others";
}

}  // namespace brdf::fit
