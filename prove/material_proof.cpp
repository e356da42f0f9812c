#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "brdf/integrals.h"
#include "io/numbers.h"
#include "io/parallel.h"
#include "io/text.h"
#include "prove/rounding_proof.h"
#include "prove/scalar/energy.h"

namespace brdf::prove {
namespace {

constexpr double kHalfWidth = 1e-3;  // of the largest albedo's interval

// A value as double has it and, for claims of float, as float rounds it.
Bounds as_stored(double x, Precision precision) {
  const double rounded = precision == Precision::float_type ? double(float(x)) : x;
  return {std::min(x, rounded), std::max(x, rounded)};
}
std::vector<Bounds> points(std::span<const double> values, Precision precision) {
  std::vector<Bounds> found;
  for (const double x : values) found.push_back(as_stored(x, precision));
  return found;
}

struct Channel {
  const Term& term;
  std::size_t index;

  std::span<const double> shape() const { return term.shape_of(index); }
  std::span<const double> weights() const { return term.weights[index]; }
};

// Whether the form mixes channels: the first channel's weights are variables of its own, then.
bool takes_first(const Channel& c) {
  return domain_of(catalogue_index(c.term.form)).variables.size() ==
         c.shape().size() + 2 * c.weights().size() + 4;
}

// The form's domain with the channel's parameters in place of their tables' ranges.
Domain domain_at(const Channel& c, const Claim& claim) {
  Domain domain = *domain_of(claim);
  std::vector<double> values(c.shape().begin(), c.shape().end());
  values.insert(values.end(), c.weights().begin(), c.weights().end());
  if (takes_first(c)) values.insert(values.end(), c.term.weights[0].begin(), c.term.weights[0].end());
  for (std::size_t k = 0; k < std::min(values.size(), domain.variables.size()); ++k) {
    const Bounds at = as_stored(values[k], claim.precision);
    domain.variables[k].low = at.lo;
    domain.variables[k].high = at.hi;
  }
  return domain;
}

void at_parameters(Proof& p, const Channel& c, const Options& options) {
  p.domain = domain_at(c, p.claim);
  p.arithmetic = "as rounded in " + std::string(name_of(p.claim.precision));
  p.cover = cover(
      *p.domain, [&](const Box& box) { return enclose(p.claim, box); },
      [&](Bounds b) { return settles(p.claim.property, b, 0); }, options.search);
  p.low = p.cover.range.lo;
  p.high = p.cover.range.hi;
  p.verdict = p.cover.open == 0 ? Verdict::proved : Verdict::bounded;
  const bool finite = p.claim.property == Property::finite;
  p.statement =
      finite ? "no overflow, no division by 0 and no domain error on the way to f" : "f is nowhere below 0";
  if (p.cover.open > 0) p.statement = std::to_string(p.cover.open) + " boxes are open: not known there";
}

// A direction for which the integrals of `brdf albedo` are above 1 by more than their error bounds.
std::optional<Witness> gain_of(const Channel& c, const std::string& file) {
  std::optional<Witness> worst;
  for (int theta = 0; theta < 90; theta += 3) {
    const AlbedoResult found = directional_albedo(c.term, c.index, degrees(theta), degrees(0));
    if (!found.converged || found.value - found.error_bound <= 1 || (worst && worst->value >= found.value))
      continue;
    worst = Witness{{},
                    {{"theta", theta}, {"phi", 0}},
                    found.value,
                    "brdf albedo --material " + file + " --theta " + io::to_text(theta)};
  }
  return worst;
}

// The largest directional albedo, between what one direction has and what none exceeds.
void largest_albedo(Proof& p, const Channel& c, const std::string& file, const Options& options) {
  p.arithmetic = "exact";
  const EnergyMethod* method = energy_method(p.claim.form);
  const auto shape = points(c.shape(), Precision::double_type),
             weights = points(c.weights(), Precision::double_type);
  const auto albedo = [&](Bounds turn, double accuracy) {
    return method->albedo(shape, weights, turn, accuracy);
  };
  if (method == nullptr || method->albedo == nullptr || !albedo({0, 0}, 1)) {
    p.statement = "no closed or regular integral of this form at these parameters is known to the prover";
    return;
  }
  // The view that is likely to reflect most, and what it certainly does.
  constexpr int kViews = 64;
  constexpr double kGlance = 0.01, kCoarse = 2e-3, kFine = 2e-4;
  double best = 0, most_likely = -1;
  for (int k = 0; k <= kViews; ++k) {
    const double turn = double(k) / kViews;
    const Bounds coarse = *albedo({turn, turn}, kGlance);
    if (coarse.lo + coarse.hi <= most_likely) continue;
    most_likely = coarse.lo + coarse.hi;
    best = turn;
  }
  const double known = albedo({best, best}, kFine / 4)->lo, most = known + 2 * kHalfWidth;
  p.domain = Domain{{{"turn_from_normal", 0, 1, Variable::Cut::middle}}};
  p.cover = cover(
      *p.domain,
      [&](const Box& box) {
        const Bounds coarse = *albedo(box[0], kCoarse);
        // Views so far apart differ by more than what the fine cells would say.
        const bool apart = box[0].hi - box[0].lo > 1.0 / 16;
        return coarse.hi <= most || apart ? coarse : *albedo(box[0], kFine);
      },
      [&](Bounds b) { return b.hi <= most; }, options.search);
  p.low = known;
  p.high = p.cover.range.hi;
  const std::string range = "the largest albedo is in [" + io::short_number(p.low, 6) + ", " +
                            io::short_number(p.high, 6) + "], all directions";
  p.verdict = p.high <= 1 + kRoundedConstants && p.cover.open == 0 ? Verdict::proved : Verdict::bounded;
  p.statement = range;
  if (p.low <= 1) return;
  if (auto witness = gain_of(c, file)) {
    p.verdict = Verdict::refuted;
    p.witness = std::move(witness);
  }
}

Proof reciprocity_of(const Reflectance& form, const std::string& file) {
  Options alone;
  alone.properties = {Property::reciprocity};
  Proof p = prove(form, alone).front();
  p.material = file;
  return p;
}

}  // namespace

std::vector<Proof> prove(const Material& material, const std::string& file, const Options& options) {
  const auto about = [&](std::size_t channel, Property property, Precision precision) {
    const auto start = std::chrono::steady_clock::now();
    const Channel c{material.terms.front(), channel};
    Proof p;
    p.claim = {catalogue_index(c.term.form), property, precision};
    p.form = c.term.form.info().name;
    p.material = file;
    p.channel = material.channels[channel];
    if (material.terms.size() > 1)
      p.statement = "nothing is known to the prover of a sum of terms";
    else if (property == Property::energy)
      largest_albedo(p, c, file, options);
    else if (property == Property::reciprocity)
      p = reciprocity_of(c.term.form, file);
    else if (property == Property::rounding)
      p.domain = domain_at(c, p.claim), prove_rounding(p, options.search);
    else
      at_parameters(p, c, options);
    p.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return p;
  };
  std::vector<std::function<Proof()>> asked;
  for (const Property property : options.properties) {
    const bool rounded = is_of_a_precision(property);
    // Reciprocity is of every channel at once.
    const std::size_t channels = property == Property::reciprocity ? 1 : material.channels.size();
    for (std::size_t k = 0; k < channels; ++k)
      for (const Precision precision : {Precision::float_type, Precision::double_type})
        if (rounded || precision == Precision::double_type)
          asked.push_back([=, &about] { return about(k, property, precision); });
  }
  std::vector<Proof> proofs(asked.size());
  io::parallel_for(asked.size(), [&](std::size_t k) { proofs[k] = asked[k](); });
  return proofs;
}

}  // namespace brdf::prove
