#include "study/verdict.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/reported.h"
#include "fit/report/report.h"
#include "io/numbers.h"

namespace brdf::study {
namespace {

constexpr double kWeakFactor = 3, kWeakWidth = 0.05;

// The wider of the two intervals.
fit::Extent widest(const fit::Estimate& e) {
  if (!std::isfinite(e.with_lack_of_fit.low)) return {e.low, e.high};
  return {std::min(e.low, e.with_lack_of_fit.low), std::max(e.high, e.with_lack_of_fit.high)};
}

bool is_weak(const fit::Estimate& e) {
  if (e.status != fit::Status::free) return false;
  const fit::Extent extent = widest(e);
  return extent.high > kWeakFactor * extent.low && extent.high - extent.low > kWeakWidth;
}

std::string sentence_of(const fit::FormFit& best) {
  const std::string error = io::percent(best.median_relative_error, 2);
  switch (best.verdict) {
    case fit::Verdict::converged:
    case fit::Verdict::at_bound:
    case fit::Verdict::determined:
      return best.lack_of_fit.beyond_scatter
                 ? best.form + " comes closest: off by " + error +
                       " in the median, more than the values scatter."
                 : best.form + " describes the samples, to " + error + " in the median.";
    case fit::Verdict::not_identifiable:
      return best.form + " comes within " + error + " in the median, but these samples cannot determine it.";
    case fit::Verdict::misfit:
      return "No form describes the samples: the best, " + best.form + ", is off by " + error +
             " in the median.";
    case fit::Verdict::interrupted:
      return "Interrupted: " + best.form + " with the best parameters so far.";
    default:
      return "No form could be fitted.";
  }
}

}  // namespace

std::vector<std::string> weakly_determined(const fit::FormFit& fit) {
  std::vector<std::pair<std::string, std::vector<std::string>>> names;  // with their channels
  for (const fit::Estimate& e : fit.estimates) {
    if (!is_weak(e)) continue;
    auto known = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == e.name; });
    if (known == names.end()) known = names.insert(names.end(), {e.name, {}});
    if (!e.channel.empty()) known->second.push_back(e.channel);
  }
  std::vector<std::string> texts;
  for (const auto& [name, channels] : names)
    texts.push_back(channels.empty() ? name : name + " (" + io::joined(channels) + ")");
  return texts;
}

Judgement judge(const fit::FitResult& result) {
  const fit::FormFit& best = result.ranking.front();
  Judgement out;
  out.sentence = sentence_of(best);
  out.warnings = best.findings;
  if (!best.solved()) return out;
  if (const std::vector<std::string> weak = weakly_determined(best); !weak.empty())
    out.warnings.push_back("weakly determined: " + fit::listed(weak) +
                           "; other values would describe the samples nearly as well");
  if (best.lack_of_fit.beyond_scatter)
    out.warnings.push_back("lack of fit: " + fit::in_words(best.lack_of_fit));
  if (!result.input_fault.empty()) out.warnings.push_back("the samples: " + result.input_fault);
  const bool plain = best.verdict == fit::Verdict::converged && out.warnings.empty();
  out.mark = !fit::usable(best.verdict) ? io::Mark::bad : plain ? io::Mark::good : io::Mark::warn;
  return out;
}

}  // namespace brdf::study
