#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

#include "brdf/integrals.h"
#include "io/numbers.h"
#include "io/parallel.h"
#include "io/text.h"
#include "prove/rounding_proof.h"
#include "prove/scalar/energy.h"
#include "prove/scalar/interval.h"

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

// False of other programs' models.
bool is_of_catalogue(const Channel& c) {
  return catalogue_index(c.term.form) >= 0;
}

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

// Terms of a material at a channel's parameters.
using Channels = std::vector<Channel>;

// A direction for which the integrals of `brdf albedo` are above 1 by more than their error bounds.
std::optional<Witness> gain_of(const Channels& terms, const std::string& file) {
  std::vector<double> angles{89, 89.9, 89.99, 89.999, 89.9999, 89.999999};  // where Ward's lobes grow
  for (int theta = 0; theta < 89; theta += 3) angles.push_back(theta);
  std::optional<Witness> worst;
  for (const double theta : angles) {
    double value = 0, error = 0;
    for (const Channel& c : terms) {
      const AlbedoResult found = directional_albedo(c.term, c.index, degrees(theta), degrees(0));
      value += found.value;
      error += (found.converged ? 1 : 10) * found.error_bound;
    }
    if (!(value - error > 1) || (worst && worst->value >= value)) continue;
    worst = Witness{{},
                    {{"theta", theta}, {"phi", 0}},
                    value,
                    "brdf albedo --material " + file + " --theta " + io::to_text(theta)};
  }
  return worst;
}

// The directional albedo of all terms, enclosed over views of a range of turns. A view has one turn for every width by which
// its tangent is stretched; these are of the least.
class SumOfAlbedos {
 public:
  explicit SumOfAlbedos(const Channels& terms) {
    double least = 1;
    for (const Channel& c : terms) {
      const EnergyMethod* method = is_of_catalogue(c) ? energy_method(catalogue_index(c.term.form)) : nullptr;
      known_ = known_ && method != nullptr && method->albedo != nullptr;
      if (!known_) return;
      Part p{method, points(c.shape(), Precision::double_type), points(c.weights(), Precision::double_type)};
      if (method->stretch != nullptr) p.stretch = method->stretch(p.shape);
      least = std::min(least, p.stretch);
      parts_.push_back(std::move(p));
    }
    for (Part& p : parts_) {
      p.stretch /= least;
      known_ = known_ && p.method->albedo(p.shape, p.weights, {0, 0}, 1);
    }
  }
  bool known() const { return known_; }
  Bounds operator()(Bounds turn, double accuracy) const {
    Interval<double> sum;
    for (const Part& p : parts_) {
      const Bounds b = *p.method->albedo(p.shape, p.weights, stretched(turn, p.stretch), accuracy);
      sum = sum + Interval<double>::of(b.lo, b.hi);
    }
    return {sum.lo, sum.hi};
  }

 private:
  struct Part {
    const EnergyMethod* method;
    std::vector<Bounds> shape, weights;
    double stretch = 1;  // beyond the least
  };
  // Turns are t/(1 + t) of tangents t.
  static Bounds stretched(Bounds turn, double by) {
    using I = Interval<double>;
    if (by == 1) return turn;
    const auto at = [&](double t) {
      const I along = I::widened(by, by) * I::of(t, t);
      return t == 0 ? I() : along / (along + (I(1) - I::of(t, t)));
    };
    return {std::max(at(turn.lo).lo, 0.0), std::min(at(turn.hi).hi, 1.0)};
  }
  std::vector<Part> parts_;
  bool known_ = true;
};

// The largest directional albedo, between what one direction has and what none exceeds.
void enclose_largest(Proof& p, const SumOfAlbedos& albedo, const Options& options) {
  // The view that is likely to reflect most, and what it certainly does.
  constexpr int kViews = 64;
  constexpr double kGlance = 0.01, kCoarse = 2e-3, kFine = 2e-4;
  double best = 0, most_likely = -1;
  for (int k = 0; k <= kViews; ++k) {
    const double turn = double(k) / kViews;
    const Bounds coarse = albedo({turn, turn}, kGlance);
    if (coarse.lo + coarse.hi <= most_likely) continue;
    most_likely = coarse.lo + coarse.hi;
    best = turn;
  }
  const double known = albedo({best, best}, kFine / 4).lo, most = known + 2 * kHalfWidth;
  p.domain = Domain{{{"turn_from_normal", 0, 1, Variable::Cut::middle}}};
  p.cover = cover(
      *p.domain,
      [&](const Box& box) {
        const Bounds coarse = albedo(box[0], kCoarse);
        // Views so far apart differ by more than what the fine cells would say.
        const bool apart = box[0].hi - box[0].lo > 1.0 / 16;
        return coarse.hi <= most || apart ? coarse : albedo(box[0], kFine);
      },
      [&](Bounds b) { return b.hi <= most; }, options.search);
  p.low = known;
  p.high = p.cover.range.hi;
  p.statement = "the largest albedo is in [" + io::short_number(p.low, 6) + ", " +
                io::short_number(p.high, 6) + "], all directions";
  p.verdict = p.high <= 1 + kRoundedConstants && p.cover.open == 0 ? Verdict::proved : Verdict::bounded;
}

void largest_albedo(Proof& p, const Channels& terms, const std::string& file, const Options& options) {
  p.arithmetic = "exact";
  const SumOfAlbedos albedo(terms);
  if (albedo.known())
    enclose_largest(p, albedo, options);
  else
    p.statement = "no closed or regular integral at these parameters is known to the prover";
  if (albedo.known() && p.low <= 1) return;
  if (auto witness = gain_of(terms, file)) {
    p.verdict = Verdict::refuted;
    if (!albedo.known()) {
      p.low = witness->value;
      p.high = std::numeric_limits<double>::infinity();
      p.statement = "the albedo is above 1; " + p.statement;
    }
    p.witness = std::move(witness);
  }
}

Proof of_term(const Channel& c, const Claim& claim, const Options& options) {
  Proof p;
  p.claim = claim;
  p.form = c.term.form.info().name;
  if (!is_of_catalogue(c)) {
    p.statement = "nothing is known to the prover of another program's model";
    return p;
  }
  if (claim.property == Property::reciprocity) {
    Options alone;
    alone.properties = {Property::reciprocity};
    return prove(c.term.form, alone).front();
  }
  if (claim.property == Property::rounding)
    p.domain = domain_at(c, claim), prove_rounding(p, options.search);
  else if (claim.property != Property::energy)
    at_parameters(p, c, options);
  return p;
}

// What is known of every term: all that is computed beside the terms is their sum.
Proof of_sum(std::vector<Proof> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  Proof sum = parts.front();
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const Proof& p = parts[k];
    sum.form += " + " + p.form;
    sum.low += p.low;
    sum.high += p.high;
    const bool weaker =
        sum.verdict == Verdict::proved && (p.verdict != Verdict::proved || p.arithmetic.starts_with("exact"));
    if (!weaker) continue;
    sum.verdict = p.verdict;
    sum.arithmetic = p.arithmetic;
    sum.statement = p.statement + (p.verdict == Verdict::proved ? "" : " (" + p.form + ")");
  }
  sum.domain.reset();
  sum.cover = {};
  sum.lobes.clear();
  const double largest = sum.claim.precision == Precision::float_type
                             ? double(std::numeric_limits<float>::max())
                             : std::numeric_limits<double>::max();
  if (sum.claim.property == Property::rounding) {
    sum.verdict = Verdict::no_method;
    sum.statement = "nothing is known to the prover of the rounding of a sum of terms";
  } else if (sum.claim.property == Property::finite && sum.high > 0.5 * largest) {
    sum.verdict = Verdict::bounded;
    sum.statement = "an overflow of the sum is not excluded";
  }
  return sum;
}

}  // namespace

std::vector<Proof> prove(const Material& material, const std::string& file, const Options& options) {
  const auto about = [&](std::size_t channel, Property property, Precision precision) {
    const auto start = std::chrono::steady_clock::now();
    Channels terms;
    for (const Term& term : material.terms) terms.push_back({term, channel});
    std::vector<Proof> parts;
    for (const Channel& c : terms)
      parts.push_back(of_term(c, {catalogue_index(c.term.form), property, precision}, options));
    Proof p = of_sum(std::move(parts));
    if (property == Property::energy) largest_albedo(p, terms, file, options);
    p.material = file;
    if (property != Property::reciprocity) p.channel = material.channels[channel];
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
