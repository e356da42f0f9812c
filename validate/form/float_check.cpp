// Compares float with double of the same code. This check does for outside code what the numerics table
// does for the catalogue.
#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "validate/form/checks.h"
#include "validate/search/pair_search.h"

namespace brdf::validate {
namespace {

constexpr double kSeen = 0.01;  // a visible relative difference

Vec3<double> rounded(const Vec3<double>& w) {
  return {double(float(w.x)), double(float(w.y)), double(float(w.z))};
}

// The parameters rounded to float.
Material rounded(Material m) {
  for (Term& term : m.terms)
    for (auto* sets : {&term.shape, &term.weights})
      for (std::vector<double>& set : *sets)
        for (double& x : set) x = double(float(x));
  return m;
}

// Relative difference of one channel; infinite if float has no finite value but double does.
double difference_at(const Term& term, std::size_t channel, const Vec3<double>& wi, const Vec3<double>& wo) {
  const Vec3<float> i{float(wi.x), float(wi.y), float(wi.z)}, o{float(wo.x), float(wo.y), float(wo.z)};
  float single;
  double wide;
  eval_batch(term, channel, one_pair(i, o), &single);
  eval_batch(term, channel, one_pair(wi, wo), &wide);
  if (!std::isfinite(wide)) return 0;  // float is not the cause
  if (!std::isfinite(single)) return HUGE_VAL;
  return difference(double(single), wide, kFaintest);
}

}  // namespace

Finding check_float(const Subject& subject, const CheckOptions& options) {
  const PairMeasure measure = [](const Material& at, const Pair& p) {
    const Material m = rounded(at);
    const Vec3<double> wi = rounded(p.wi), wo = rounded(p.wo);
    double worst = 0;
    for (std::size_t c = 0; c < m.channels.size(); ++c)
      worst = std::max(worst, difference_at(m.terms.front(), c, wi, wo));
    return worst;
  };
  const Best best = worst_pair(subject, measure, options);
  Finding finding{subject.name(), "float"};
  finding.value = best.value;
  finding.bound = kSeen;
  finding.evaluations = 2 * best.calls;
  const Material at = subject.at(best.point);
  const Pair pair = pair_of(subject, best.point);
  finding.witness = pair_witness(subject, at, pair);
  finding.conclude(!(finding.value > kSeen),
                   "float and double of the same code agree to " + io::percent(finding.value, 2),
                   std::isinf(finding.value)
                       ? "not finite in float at directions at which double is finite"
                       : "float and double of the same code differ by " + io::percent(finding.value, 3));
  if (finding.outcome == Outcome::fail)
    finding.statement += subject.explained(finding.check, at, pair.wi, pair.wo);
  return finding;
}

}  // namespace brdf::validate
