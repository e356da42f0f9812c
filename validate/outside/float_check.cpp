// Compares float with double of the same code. This check does for outside code what the numerics table
// does for the catalogue.
#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "validate/outside/outside_checks.h"
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

// Relative difference of one channel; infinite if the value has fewer bits and is not finite, but double is.
double difference_of(double narrow, double wide) {
  if (!std::isfinite(wide)) return 0;  // the number of bits is not the cause
  if (!std::isfinite(narrow)) return HUGE_VAL;
  return difference(narrow, wide, kFaintest);
}

// The largest relative difference of all channels between double and the values that `narrow` gives for a
// material and a pair, all numbers rounded to float.
template <class Narrow>
PairMeasure measure_of(Narrow&& narrow) {
  return [narrow](const Material& at, const Pair& p) {
    const Material m = rounded(at);
    const Vec3<double> wi = rounded(p.wi), wo = rounded(p.wo);
    if (std::min(wi.z, wo.z) < 0) return 0.0;
    const std::vector<double> values = narrow(m, wi, wo);
    double worst = 0;
    for (std::size_t c = 0; c < m.channels.size(); ++c) {
      double wide;
      eval_batch(m.terms.front(), c, one_pair(wi, wo), &wide);
      worst = std::max(worst, difference_of(values[c], wide));
    }
    return worst;
  };
}

std::vector<double> in_float(const Material& m, const Vec3<double>& wi, const Vec3<double>& wo) {
  const Vec3<float> i{float(wi.x), float(wi.y), float(wi.z)}, o{float(wo.x), float(wo.y), float(wo.z)};
  std::vector<double> out;
  for (std::size_t c = 0; c < m.channels.size(); ++c) {
    float single;
    eval_batch(m.terms.front(), c, one_pair(i, o), &single);
    out.push_back(double(single));
  }
  return out;
}

// The largest difference for one number of bits, and its place.
struct ComparedBits {
  std::string name;   // of the number of bits
  std::string check;  // by which the code explains the difference
  Best best;

  bool fails() const { return best.value > kSeen; }
  std::string sentence() const {
    if (std::isinf(best.value)) return "not finite in " + name + " at directions at which double is finite";
    return name + " and double of the same code " +
           (fails() ? "differ by " + io::percent(best.value, 3) : "agree to " + io::percent(best.value, 2));
  }
};

}  // namespace

Finding check_float(const Subject& given, const CheckOptions& options) {
  const Subject subject = given.at_every_turn();
  const OutsideFacts* const facts = subject.outside_facts();
  const bool rounds = facts && facts->has_half_types;
  std::vector<ComparedBits> all{{rounds ? "float, with 16-bit types in half precision," : "float", "float",
                                 worst_pair(subject, measure_of(in_float), options)}};
  if (facts && facts->in_half)
    all.push_back({"half precision", "half", worst_pair(subject, measure_of(facts->in_half), options)});
  Finding finding{subject.name(), "float"};
  finding.bound = kSeen;
  finding.outcome = Outcome::pass;
  for (const ComparedBits& c : all) {
    const Material at = subject.at(c.best.point);
    const Pair pair = pair_of(subject, c.best.point);
    finding.evaluations += 2 * c.best.calls;
    finding.statement += (finding.statement.empty() ? "" : "; ") + c.sentence();
    if (c.fails()) {
      finding.outcome = Outcome::fail;
      finding.statement += subject.explained(c.check, at, pair.wi, pair.wo);
    }
    if (finding.witness && !(c.best.value > finding.value)) continue;
    finding.value = c.best.value;
    finding.witness = pair_witness(subject, at, pair);
  }
  if (finding.outcome == Outcome::pass && facts && !facts->half_unknown.empty()) {
    finding.outcome = Outcome::undecided;
    finding.statement += "; half precision is not evaluated: " + facts->half_unknown;
  }
  return finding;
}

}  // namespace brdf::validate
