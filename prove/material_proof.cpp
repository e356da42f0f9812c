#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>

#include "brdf/least_of_matt.h"
#include "io/files/numbers.h"
#include "io/files/parallel.h"
#include "io/files/shell.h"
#include "io/files/text.h"
#include "io/samples/degrees.h"
#include "prove/energy/energy.h"
#include "prove/largest_albedo.h"
#include "prove/rounding_proof.h"

namespace brdf::prove {
namespace {

constexpr double kHalfWidth = 1e-3;  // of the interval of the largest albedo

// Returns the pair of directions at which a term with weights of either sign is below 0.
std::optional<LeastOfMatt> below_zero(const Channel& c) {
  const MattBasis* basis = c.term.form.info().basis;
  if (!basis) return std::nullopt;
  const LeastOfMatt least = least_of_matt(*basis, c.weights(), 0);
  return least.value < 0 ? std::optional(least) : std::nullopt;
}

// Returns the witness if the sum of the terms is negative at that pair of directions.
std::optional<Witness> negative_at(const Channels& terms, const LeastOfMatt& least, const std::string& file) {
  const auto angle = [](double radian) { return radians(radian).degrees(); };
  const double theta_i = angle(std::acos(std::clamp(least.wi.z, 0.0, 1.0))),
               theta_o = angle(std::acos(std::clamp(least.wo.z, 0.0, 1.0))),
               phi_o = angle(std::atan2(least.wo.y, least.wo.x));
  const Vec3<double> wi = io::unit_vector(theta_i, 0), wo = io::unit_vector(theta_o, phi_o);
  double sum = 0;
  for (const Channel& c : terms) {
    double f = 0;
    eval_batch(c.term, c.index, one_pair(wi, wo), &f);
    sum += f;
  }
  if (!(sum < 0)) return std::nullopt;
  return Witness{{},
                 {{"theta_i", theta_i}, {"phi_i", 0}, {"theta_o", theta_o}, {"phi_o", phi_o}},
                 sum,
                 "printf 'theta_i,phi_i,theta_o,phi_o\\n" + io::to_text(theta_i) + ",0," +
                     io::to_text(theta_o) + "," + io::to_text(phi_o) + "\\n' | brdf eval " +
                     io::shell_file(file) + " -"};
}

// Refutes a sum with a term whose weights of either sign make the sum negative.
void refute_negative(Proof& p, const Channels& terms, const std::string& file) {
  for (const Channel& c : terms)
    if (const auto least = below_zero(c))
      if (auto witness = negative_at(terms, *least, file)) {
        p.verdict = Verdict::refuted;
        p.statement = "f is negative";
        p.low = terms.size() == 1 ? least->bound : -std::numeric_limits<double>::infinity();
        p.high = witness->value;  // an upper bound of the least value
        p.witness = std::move(witness);
        return;
      }
}

void at_parameters(Proof& p, const Channel& c, SearchOptions search) {
  const auto negative = p.claim.property == Property::non_negative ? below_zero(c) : std::nullopt;
  if (negative) search.leaves = 1;  // no division of the domain can prove it
  p.domain = domain_at(c, p.claim);
  p.arithmetic = arithmetic_of(p.claim);
  p.cover = cover(
      *p.domain, [&](const Box& box) { return enclose(p.claim, box); },
      [&](Bounds b) { return settles(p.claim.property, b, 0); }, search);
  p.low = p.cover.range.lo;
  p.high = p.cover.range.hi;
  p.verdict = p.cover.open == 0 ? Verdict::proved : Verdict::bounded;
  p.statement = statement_of(p.claim.property);
  if (p.cover.open > 0)
    p.statement = negative
                      ? "this term is below 0 at some directions (" + io::short_number(negative->value, 3) +
                            " /sr), and whether the sum of the terms is has not been examined elsewhere"
                      : std::to_string(p.cover.open) +
                            (p.cover.open == 1 ? " box is undecided" : " boxes are undecided");
}

// Returns a direction for which the integrals of `brdf albedo` exceed 1 by more than their error bounds.
std::optional<Witness> gain_of(const Channels& terms, const std::string& file) {
  // Ward's lobes grow near these angles.
  std::vector<double> angles{89, 89.9, 89.99, 89.999, 89.9999, 89.999999};
  for (int theta = 0; theta < 89; theta += 3) angles.push_back(theta);
  const bool turns = std::ranges::any_of(terms, [](const Channel& c) {
    const auto axes = c.term.form.info().axes();
    return axes.across >= 0 && c.shape()[std::size_t(axes.along)] != c.shape()[std::size_t(axes.across)];
  });
  std::optional<Witness> worst;
  for (const double phi : turns ? std::vector<double>{0, 30, 60, 90} : std::vector<double>{0})
    for (const double theta : angles) {
      const MeasuredAlbedo found = measured_albedo(terms, theta, phi);
      if (!(found.least > 1) || (worst && worst->value >= found.value)) continue;
      worst = Witness{{},
                      {{"theta", theta}, {"phi", phi}},
                      found.value,
                      "brdf albedo " + io::shell_file(file) + " --theta " + io::to_text(theta) +
                          (phi > 0 ? " --phi " + io::to_text(phi) : "")};
    }
  return worst;
}

void state_largest(Proof& p, const SumOfAlbedos& albedo, const Options& options) {
  const LargestAlbedo found = largest_of(albedo, kHalfWidth, 1 + kRoundedConstants, options.search);
  p.domain = found.domain;
  p.cover = found.cover;
  p.low = found.low;
  p.high = found.cover.range.hi;
  p.low_at = found.low_at;
  p.statement = "the largest albedo is in [" + io::short_number(p.low, 6) + ", " +
                io::short_number(p.high, 6) + "], all directions";
  if (p.cover.open > 0)
    p.statement += "; the search stopped with " + std::to_string(p.cover.open) +
                   (p.cover.open == 1 ? " undecided box" : " undecided boxes");
  p.verdict = p.high <= 1 + kRoundedConstants ? Verdict::proved
              : p.low > 1 + kRoundedConstants ? Verdict::refuted
                                              : Verdict::bounded;
}

void largest_albedo(Proof& p, const Channels& terms, const std::string& file, const Options& options) {
  p.arithmetic = kExact;
  const SumOfAlbedos albedo(terms);
  if (albedo.known())
    state_largest(p, albedo, options);
  else
    p.statement = "the prover has no closed form or regular integral at these parameters";
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

void values_of_term(Proof& p, const Channel& c, const SearchOptions& search) {
  if (p.claim.property == Property::reciprocity)
    p = prove_reciprocity(c.term.form);
  else
    at_parameters(p, c, search);
}

// Combines the proofs of the terms. Apart from the terms, only their sum is computed.
Proof of_sum(std::vector<Proof> parts) {
  if (parts.size() == 1) {
    Proof alone = parts.front();
    alone.terms = std::move(parts);
    return alone;
  }
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
  if (sum.claim.property == Property::rounding) {
    sum.verdict = Verdict::no_method;
    sum.statement = "the prover has no method for the rounding of a sum of terms";
  } else if (sum.claim.property == Property::finite && may_overflow(sum.high, sum.claim.precision)) {
    sum.verdict = Verdict::bounded;
    sum.statement = "an overflow of the sum is not excluded";
  }
  sum.terms = std::move(parts);
  return sum;
}

using OfTerm = std::function<void(Proof&, const Channel&)>;
using OfSum = std::function<void(Proof&, const Channels&)>;

// Calls `of_term` for each term that has a method, and `of_whole` for the sum of the terms.
Proof of_channel(const Channels& terms, Property property, Precision precision, const OfTerm& of_term,
                 const OfSum& of_whole) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<Proof> parts;
  for (const Channel& c : terms) {
    Proof& p = parts.emplace_back();
    p.claim = {catalogue_index(c.term.form), property, precision};
    p.form = c.term.form.info().name;
    if (is_of_catalogue(c))
      of_term(p, c);
    else
      p.statement = "the prover has no method for a model of another program";
  }
  Proof p = of_sum(std::move(parts));
  of_whole(p, terms);
  p.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return p;
}

std::vector<Proof> of_channels(const Material& material, const std::string& file,
                               std::span<const Property> properties, const OfTerm& of_term,
                               const OfSum& of_whole) {
  const auto about = [&](std::size_t channel, Property property, Precision precision) {
    Proof p = of_channel(channels_of(material, channel), property, precision, of_term, of_whole);
    p.material = file;
    if (property != Property::reciprocity) p.channel = material.channels[channel];
    return p;
  };
  std::vector<std::function<Proof()>> asked;
  for (const Property property : properties) {
    const bool rounded = is_of_a_precision(property);
    // Reciprocity is proved for all channels at once.
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

}  // namespace

std::vector<Proof> prove(const Material& material, const std::string& file, const Options& options) {
  const auto of_term = [&](Proof& p, const Channel& c) {
    if (p.claim.property == Property::rounding)
      p.domain = domain_at(c, p.claim), prove_rounding(p, options.search);
    else if (p.claim.property != Property::energy)
      values_of_term(p, c, options.search);
  };
  const auto of_whole = [&](Proof& p, const Channels& terms) {
    if (p.claim.property == Property::energy) largest_albedo(p, terms, file, options);
    if (p.claim.property == Property::non_negative) refute_negative(p, terms, file);
  };
  return of_channels(material, file, options.properties, of_term, of_whole);
}

std::vector<Proof> prove_values(const Material& material, const std::string& file,
                                const SearchOptions& search) {
  const auto of_term = [&](Proof& p, const Channel& c) { values_of_term(p, c, search); };
  const auto of_whole = [&](Proof& p, const Channels& terms) {
    if (p.claim.property == Property::non_negative) refute_negative(p, terms, file);
  };
  return of_channels(material, file, kPropertiesOfValues, of_term, of_whole);
}

}  // namespace brdf::prove
