#include "prove/proof.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "io/files/numbers.h"
#include "prove/energy/energy.h"
#include "prove/rounding_proof.h"
#include "prove/scalar/swapped.h"

namespace brdf::prove {
namespace {

std::string open_boxes(const Cover& cover) {
  return std::to_string(cover.open) + (cover.open == 1 ? " box is" : " boxes are") + " undecided";
}

Proof about(const Reflectance& form, const Claim& claim) {
  Proof p;
  p.claim = claim;
  p.form = form.info().name;
  return p;
}

Proof by_boxes(const Reflectance& form, const Claim& claim, const Options& options, double most) {
  Proof p = about(form, claim);
  p.domain = domain_of(claim);
  p.arithmetic = arithmetic_of(claim);
  p.cover = cover(
      *p.domain, [&](const Box& box) { return enclose(claim, box); },
      [&](Bounds b) { return settles(claim.property, b, most); }, options.search);
  p.low = p.cover.range.lo;
  p.high = p.cover.range.hi;
  p.verdict = p.cover.open == 0 ? Verdict::proved : Verdict::bounded;
  return p;
}

Proof finite(const Reflectance& form, const Claim& claim, const Options& options) {
  Proof p = by_boxes(form, claim, options, 0);
  p.statement = p.verdict == Verdict::proved ? std::string(statement_of(claim.property))
                                             : open_boxes(p.cover) + ": an overflow is not excluded there";
  return p;
}

Proof non_negative(const Reflectance& form, const Claim& claim, const Options& options) {
  Options brief = options;
  if (form.info().violates(name_of(Property::non_negative))) brief.search.leaves = 1;  // its witness is known
  Proof p = by_boxes(form, claim, brief, 0);
  p.statement = p.verdict == Verdict::proved ? std::string(statement_of(claim.property))
                                             : open_boxes(p.cover) + ": f may be below 0 there";
  if (p.verdict == Verdict::proved) return p;
  if (auto witness = find_negative(form)) {
    p.verdict = Verdict::refuted;
    p.statement = "f is negative";
    p.high = witness->value;  // an upper bound of the least value
    p.witness = std::move(witness);
  }
  return p;
}

std::string in_words(const Growth& g) {
  return "beyond an angle of incidence of " + io::short_number(g.from, 3) +
         " degrees the largest albedo is K/" +
         (g.power == 1 ? "cos" : "cos^" + io::short_number(g.power, 2)) + ", K in [" +
         io::short_number(g.low, 3) + ", " + io::short_number(g.high, 3) + "]";
}

// Proves that the albedo is at most 1. If a violation is declared, the bound is the witness's albedo plus
// the gap.
Proof energy(const Reflectance& form, const Claim& claim, const Options& options) {
  const EnergyMethod* method = energy_method(claim.form);
  auto witness = find_gain(form);
  const bool tied = method != nullptr &&
                    std::ranges::any_of(method->domain.variables, [](const Variable& v) { return v.tied; });
  Proof p = about(form, claim);
  p.arithmetic = arithmetic_of(claim);
  if (method != nullptr) {
    const double most = witness && !tied ? witness->value + options.gap : 1 + kRoundedConstants;
    p = by_boxes(form, claim, options, most);
    p.statement =
        (p.cover.open == 0 ? "the albedo is at most " + io::short_number(p.high, 8) : open_boxes(p.cover)) +
        ": " + method->why + (tied ? ", for equal widths" : "");
  }
  if (witness) {
    p.verdict = Verdict::refuted;
    p.low = witness->value;
    if (method == nullptr || tied) p.high = std::numeric_limits<double>::infinity();
    p.statement = "the albedo is above 1" + (p.statement.empty() ? "" : "; " + p.statement);
    p.growth = growth_of(claim.form, options.search);
    if (p.growth) p.statement += "; " + in_words(*p.growth);
    p.witness = std::move(witness);
  } else if (method == nullptr) {
    p.statement = "the prover has no method for this form";
  }
  return p;
}

Proof rounding(const Reflectance& form, const Claim& claim, const Options& options) {
  Proof p = about(form, claim);
  p.domain = domain_of(claim);
  prove_rounding(p, options.search);
  return p;
}

Proof of(const Reflectance& form, const Claim& claim, const Options& options) {
  switch (claim.property) {
    case Property::finite:
      return finite(form, claim, options);
    case Property::non_negative:
      return non_negative(form, claim, options);
    case Property::reciprocity:
      return prove_reciprocity(form);
    case Property::energy:
      return energy(form, claim, options);
    case Property::rounding:
      return rounding(form, claim, options);
  }
  return about(form, claim);
}

}  // namespace

Proof prove_reciprocity(const Reflectance& form) {
  const Claim claim{catalogue_index(form), Property::reciprocity, Precision::double_type};
  Proof p = about(form, claim);
  const Swapped bits = record_both_orders(claim.form, Rules::bits);
  p.cover.boxes = bits.cases;
  if (bits.same || record_both_orders(claim.form, Rules::exact).same) {
    p.verdict = Verdict::proved;
    p.arithmetic = arithmetic_of(claim, bits.same);
    p.statement = bits.same ? "f(wi, wo) and f(wo, wi) are the same operations"
                            : "f(wi, wo) and f(wo, wi) are the same sums and products in another order";
  } else {
    p.statement = "the formulas for both orders differ";
  }
  return p;
}

std::vector<Proof> prove(const Reflectance& form, const Options& options) {
  std::vector<Proof> proofs;
  const int place = catalogue_index(form);
  const auto add = [&](Property property, Precision precision) {
    const auto start = std::chrono::steady_clock::now();
    Proof p = of(form, {place, property, precision}, options);
    p.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    proofs.push_back(std::move(p));
  };
  for (const Property property : options.properties) {
    if (is_of_a_precision(property))
      for (const Precision precision : {Precision::float_type, Precision::double_type})
        add(property, precision);
    else
      add(property, Precision::double_type);
  }
  return proofs;
}

}  // namespace brdf::prove
