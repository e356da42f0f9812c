#include "prove/shader/shader_proof.h"

#include <chrono>
#include <cmath>
#include <random>

#include "brdf/integrals.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "prove/shader/albedo_bound.h"
#include "prove/shader/on_box.h"
#include "prove/shader/trial.h"

namespace brdf::prove {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr long kTriedOf = 7;           // of so many open boxes, the centre of one is tried
constexpr double kAlbedoSlack = 1e-6;  // above 1: for constants like 3.14159265

// Returns the largest albedo of a few materials, integrated with an error bound.
std::optional<Witness> largest_albedo(const ShaderSubject& s) {
  constexpr int kMaterials = 40;
  const Domain domain = s.domain(false);
  std::mt19937_64 e(2);
  std::optional<Witness> best;
  for (int k = 0; k < kMaterials; ++k) {
    std::vector<double> at = point_of(domain, e);
    for (std::size_t j = 0; j < s.parameters() && k == 0; ++j) at[j] = domain.variables[j].high;
    at = s.possible(std::move(at));
    std::string words = s.words;
    const Material m = s.at(at, words);
    const double theta = std::acos(at[s.parameters()]) * 180 / kPi, phi = 90 * at[s.parameters() + 1];
    AlbedoOptions few;
    few.max_evaluations = 40'000;
    for (const AlbedoResult& a : directional_albedo(m, degrees(theta), degrees(phi), few)) {
      const double sure = a.value - a.error_bound;
      if (!a.converged || (best && best->value - 1e-9 >= sure)) continue;
      best = Witness{s.named(at),
                     {{"theta", theta}, {"phi", phi}},
                     a.value,
                     "brdf albedo" + words + " --theta " + io::to_text(theta) + " --phi " + io::to_text(phi)};
    }
  }
  return best;
}

// Returns the limit of the domain in words, for every sentence that depends on the domain.
std::string within_domain() {
  return ", for cosines from " + io::short_number(kLeastShaderCosine, 3);
}

void refute(Proof& p, Witness witness) {
  p.verdict = Verdict::refuted;
  p.statement = p.claim.property == Property::finite ? "f is not finite" : "f is negative";
  p.witness = std::move(witness);
}

// Returns the limit that ended a search with open boxes, in words.
std::string said_of_limit(long used, Clock::time_point start, const SearchOptions& search) {
  if (used >= search.leaves)
    return "the search ended at its limit of " + std::to_string(search.leaves) + " boxes";
  if (seconds_since(start) > search.seconds) return "a larger --seconds continues the search";
  return "smaller boxes do not decide it";
}

std::vector<double> centre_of(const Box& box) {
  std::vector<double> out;
  for (const Bounds& b : box) out.push_back((b.lo + b.hi) / 2);
  return out;
}

// Returns a violation at the centre of an open box, or elsewhere in the domain.
std::optional<Witness> violation(const Proof& p, const ShaderSubject& s) {
  for (const Box& box : p.cover.left)
    if (auto witness = fault_at(s, p.claim, centre_of(box))) return witness;
  return fault_of(s, p.claim, *p.domain);
}

// Completes a proof by trial evaluations if the boxes do not decide.
void by_trial(Proof& p, const ShaderSubject& s, const std::string& limit,
              const std::optional<shader::UndefinedValue>& may_be) {
  p.statement =
      std::to_string(p.cover.open) + (p.cover.open == 1 ? " box is" : " boxes are") + " undecided: " + limit;
  if (auto witness = violation(p, s)) {
    refute(p, *std::move(witness));
  } else if (const auto undefined = undefined_of(s, p.claim.precision, *p.domain)) {
    p.verdict = Verdict::no_method;
    p.statement = "undefined: " + *undefined;
  } else if (may_be) {
    p.statement += "; the value may be undefined there: " + shader::to_text(s.function(), *may_be);
  }
}

void by_boxes(Proof& p, const ShaderSubject& s, const Options& options) {
  const bool in_float = p.claim.precision == Precision::float_type;
  p.domain = s.domain(true);
  p.arithmetic = in_float ? "as rounded in float" : "as rounded in double";
  std::optional<shader::UndefinedValue> may_be;
  std::optional<Witness> witness;
  long open = 0;
  const auto start = Clock::now();
  p.cover = cover(
      *p.domain,
      [&](const Box& box) {
        const ShaderInputs in = s.inputs(box);
        const ShaderBounds b =
            in_float ? shader_on_box<float>(s.function(), in) : shader_on_box<double>(s.function(), in);
        if (b.undefined) may_be = b.undefined;
        // Every value of a box below 0 is a violation: halves of it would be open without end.
        const bool may_be_negative = std::isfinite(b.value.lo) && b.value.lo < 0;
        if (!witness && may_be_negative && p.claim.property == Property::non_negative &&
            (b.value.hi < 0 || ++open % kTriedOf == 0))
          witness = fault_at(s, p.claim, centre_of(box));
        return b.value;
      },
      [&](Bounds b) { return witness || settles(p.claim.property, b, 0); }, options.search);
  p.low = p.cover.range.lo;
  p.high = p.cover.range.hi;
  if (witness) return refute(p, *std::move(witness));
  p.verdict = p.cover.open == 0 ? Verdict::proved : Verdict::bounded;
  const long leaves = long(p.cover.nodes.size() + 1) / 2;
  if (p.cover.open > 0) return by_trial(p, s, said_of_limit(leaves, start, options.search), may_be);
  const bool finite = p.claim.property == Property::finite;
  p.statement = (finite ? "f is finite" : "f is never below 0") + within_domain();
  if (const auto beyond = fault_of(s, p.claim, below(*p.domain)))
    p.statement +=
        std::string("; below that f ") + (finite ? "is not finite" : "is negative") + ": " + beyond->command;
  else if (const auto undefined = undefined_of(s, p.claim.precision, below(*p.domain)))
    p.statement += "; below that f is undefined: " + *undefined;
}

void energy(Proof& p, const ShaderSubject& s, const Options& options) {
  p.domain = s.domain(false);
  p.arithmetic = "as rounded in double";
  const auto witness = largest_albedo(s);
  const bool refuted = witness && witness->value > 1 + 10 * kAlbedoSlack;
  SearchOptions search = options.search;
  if (refuted) search.leaves = 1;
  std::optional<shader::UndefinedValue> may_be;
  const auto viewers = [&](const Box& box) -> ViewerBounds {
    return [&s, &may_be, in = s.inputs(box)](Bounds cos_o, Bounds turn_o) mutable {
      in.cos_o = cos_o;
      in.turn_o = turn_o;
      const ShaderBounds f = shader_on_box<double>(s.function(), in);
      if (f.undefined) may_be = f.undefined;
      return f.value;
    };
  };
  const auto start = Clock::now();
  p.cover = bound_albedo(*p.domain, viewers, 1 + kAlbedoSlack, search);
  const std::string limit = said_of_limit(p.cover.boxes, start, search);
  p.low = witness ? witness->value : 0;
  p.high = p.cover.range.hi;
  p.verdict = refuted ? Verdict::refuted : p.cover.open == 0 ? Verdict::proved : Verdict::bounded;
  if (refuted) {
    p.statement = "the albedo is above 1";
    p.witness = witness;
  } else if (p.cover.open == 0) {
    p.statement = "the albedo is at most " + io::short_number(p.high, 7) + within_domain() +
                  " of the incident direction";
  } else if (const auto undefined = undefined_of(s, Precision::double_type, s.domain(true))) {
    p.verdict = Verdict::no_method;
    p.statement = "undefined: " + *undefined;
  } else {
    p.statement = std::to_string(p.cover.open) + (p.cover.open == 1 ? " box is" : " boxes are") +
                  " undecided after " + std::to_string(p.cover.boxes) +
                  " were enclosed: the albedo may be above 1 there; " + limit;
    if (may_be) p.statement += "; the value may be undefined: " + shader::to_text(s.function(), *may_be);
  }
}

}  // namespace

std::vector<Proof> prove(const shader::ShaderReflectance& model, const Material& material,
                         const std::string& words, const Options& options) {
  std::vector<Proof> proofs;
  const auto add = [&](Property property, Precision precision) {
    const auto start = Clock::now();
    Proof p;
    p.claim = {-1, property, precision};
    p.form = model.info().name;
    const bool in_float = precision == Precision::float_type;
    const shader::Function& f = model.function();
    const ShaderSubject subject{model, material, words,
                                !(in_float ? f.turning<float>() : f.turning<double>()).isotropic};
    const std::string unknown = unknown_operation(in_float ? f.as_written : f.as_meant);
    if (property == Property::reciprocity || property == Property::rounding)
      p.statement = "the prover has no method for this property of shaders";
    else if (in_float && (f.in_half || !f.half_unknown.empty()))
      p.statement =
          "the shader has values that have or may have 16 bits, and the prover does not enclose half "
          "precision";
    else if (!unknown.empty())
      p.statement = "the shader has " + unknown;
    else if (property == Property::energy)
      energy(p, subject, options);
    else
      by_boxes(p, subject, options);
    p.seconds = seconds_since(start);
    proofs.push_back(std::move(p));
  };
  for (const Property property : options.properties)
    for (const Precision precision : {Precision::float_type, Precision::double_type})
      if (is_of_a_precision(property) || precision == Precision::double_type) add(property, precision);
  return proofs;
}

}  // namespace brdf::prove
