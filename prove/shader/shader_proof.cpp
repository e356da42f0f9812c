#include "prove/shader/shader_proof.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>

#include "brdf/integrals.h"
#include "io/numbers.h"
#include "io/samples.h"
#include "io/text.h"
#include "prove/shader/albedo_bound.h"
#include "prove/shader/on_box.h"

namespace brdf::prove {
namespace {

constexpr double kAlbedoSlack = 1e-6;   // above 1: of constants like 3.14159265
constexpr double kLowestTried = 1e-12;  // a cosine

// The shader's parameters as variables, then its directions.
struct Subject {
  const shader::ShaderReflectance& model;
  const Material& material;
  std::string words;
  bool turns = true;  // the light has to be turned: no symmetry of the program is shown

  const shader::Function& function() const { return model.function(); }
  std::size_t parameters() const { return function().parameters.size(); }
  // Whole numbers where parameters are: the function computes with those, whatever it is given between them.
  std::vector<double> possible(std::vector<double> point) const {
    for (std::size_t k = 0; k < parameters(); ++k)
      if (function().parameters[k].whole) point[k] = std::floor(point[k] + 0.5);
    return point;
  }

  Domain domain(bool with_viewer) const {
    Domain d;
    for (const shader::Parameter& p : function().parameters)
      d.variables.push_back({p.name, p.min, p.max,
                             p.log_scale && p.min > 0 ? Variable::Cut::logarithmic : Variable::Cut::middle});
    add_direction(d, "i", turns);
    if (with_viewer) add_direction(d, "o", true);
    return d;
  }
  static void add_direction(Domain& d, const std::string& which, bool turns) {
    d.variables.push_back({"cos_" + which, kLeastShaderCosine, 1, Variable::Cut::cosine});
    d.variables.push_back({"turn_" + which, turns ? -2.0 : 0.0, turns ? 2.0 : 0.0, Variable::Cut::middle});
  }
  // A colour's three components are anywhere in its range, each.
  ShaderInputs inputs(std::span<const Bounds> box) const {
    ShaderInputs in;
    in.values.resize(function().values);
    std::size_t at = 0;
    for (const shader::Parameter& p : function().parameters) {
      for (std::size_t k = 0; k < (p.colour ? 3u : 1u); ++k) in.values[p.first + k] = box[at];
      ++at;
    }
    in.cos_i = box[at];
    in.turn_i = box[at + 1];
    if (box.size() > at + 2) {
      in.cos_o = box[at + 2];
      in.turn_o = box[at + 3];
    }
    return in;
  }
};

// A point of the domain: any, or a corner.
std::vector<double> point_of(const Domain& domain, std::mt19937_64& e) {
  std::vector<double> at;
  const bool corner = e() % 4 == 0;
  for (const Variable& v : domain.variables) {
    const double u = corner ? double(e() % 2) : double(e() >> 11) * 0x1p-53;
    at.push_back(v.cut == Variable::Cut::middle ? v.low + u * (v.high - v.low)
                                                : v.low * std::pow(v.high / v.low, u));
  }
  return at;
}

// The material with these parameters, in the function's order; the words that say so.
Material at_parameters(const Subject& s, std::span<const double> values, std::string& words) {
  Material m = s.material;
  Term& term = m.terms.front();
  const auto& weights = s.model.weight_parameters();
  const auto& shape = s.model.shape_parameters();
  for (std::size_t k = 0; k < weights.size(); ++k)
    for (auto& w : term.weights) w[k] = values[weights[k]];
  for (std::size_t k = 0; k < shape.size(); ++k)
    for (auto& values_of_shape : term.shape) values_of_shape[k] = values[shape[k]];
  for (std::size_t k = 0; k < s.parameters(); ++k)
    words += " --set " + s.function().parameters[k].name + "=" + io::to_text(values[k]);
  return m;
}

std::vector<std::pair<std::string, double>> named(const Subject& s, std::span<const double> values) {
  std::vector<std::pair<std::string, double>> all;
  for (std::size_t k = 0; k < s.parameters(); ++k)
    all.emplace_back(s.function().parameters[k].name, values[k]);
  return all;
}

// A point of the domain as a material and a pair of directions.
struct Trial {
  std::vector<double> at;
  std::string words;
  Material material;
  double theta_i, phi_i, theta_o, phi_o;  // degrees
  Vec3<double> wi, wo;

  Trial(const Subject& s, std::vector<double> point)
      : at(s.possible(std::move(point))), words(s.words), material(at_parameters(s, at, words)) {
    const std::size_t d = s.parameters();
    const auto theta = [](double cosine) { return std::acos(cosine) * 180 / kPi; };
    theta_i = theta(at[d]), phi_i = 90 * at[d + 1];
    theta_o = theta(at[d + 2]), phi_o = 90 * at[d + 3];
    wi = io::unit_vector(theta_i, phi_i), wo = io::unit_vector(theta_o, phi_o);
  }
  std::optional<shader::UndefinedValue> undefined(const Subject& s, Precision precision) const {
    std::vector<double> values(s.function().values);
    for (std::size_t k = 0; k < s.parameters(); ++k) {
      const shader::Parameter& p = s.function().parameters[k];
      for (std::size_t c = 0; c < (p.colour ? 3u : 1u); ++c) values[p.first + c] = at[k];
    }
    return precision == Precision::float_type ? shader::undefined_value<float>(s.function(), values, wi, wo)
                                              : shader::undefined_value<double>(s.function(), values, wi, wo);
  }
  Witness witness(const Subject& s, double value) const {
    Witness w;
    w.parameters = named(s, at);
    w.angles = {{"theta_i", theta_i}, {"phi_i", phi_i}, {"theta_o", theta_o}, {"phi_o", phi_o}};
    w.value = value;
    w.command = "printf 'theta_i,phi_i,theta_o,phi_o\\n" + io::to_text(theta_i) + "," + io::to_text(phi_i) +
                "," + io::to_text(theta_o) + "," + io::to_text(phi_o) + "\\n' | brdf eval" + words +
                " /dev/stdin";
    return w;
  }
};

constexpr int kTrials = 4000;

// A direction in which f is defined and not as the property says, by trial.
std::optional<Witness> fault_of(const Subject& s, const Claim& claim, const Domain& domain) {
  std::mt19937_64 e(1);
  for (int k = 0; k < kTrials; ++k) {
    const Trial trial(s, point_of(domain, e));
    std::vector<double> f(trial.material.channels.size());
    eval(trial.material, trial.wi, trial.wo, f);
    for (const double x : f) {
      if (claim.property == Property::finite ? std::isfinite(x) : !(x < 0)) continue;
      if (trial.undefined(s, claim.precision)) break;
      return trial.witness(s, x);
    }
  }
  return std::nullopt;
}

// A value that the language leaves undefined, by trial.
std::optional<std::string> undefined_of(const Subject& s, Precision precision, const Domain& domain) {
  std::mt19937_64 e(3);
  for (int k = 0; k < kTrials; ++k)
    if (const auto found = Trial(s, point_of(domain, e)).undefined(s, precision))
      return shader::to_text(s.function(), *found);
  return std::nullopt;
}

// The same domain for cosines below the least one, where nothing is claimed.
Domain below(Domain domain) {
  for (Variable& v : domain.variables)
    if (v.name.starts_with("cos_")) v.high = v.low, v.low = kLowestTried;
  return domain;
}

// The largest albedo of a few materials, integrated with an error bound.
std::optional<Witness> largest_albedo(const Subject& s) {
  constexpr int kMaterials = 40;
  const Domain domain = s.domain(false);
  std::mt19937_64 e(2);
  std::optional<Witness> best;
  for (int k = 0; k < kMaterials; ++k) {
    std::vector<double> at = point_of(domain, e);
    for (std::size_t j = 0; j < s.parameters() && k == 0; ++j) at[j] = domain.variables[j].high;
    std::string words = s.words;
    const Material m = at_parameters(s, at, words);
    const double theta = std::acos(at[s.parameters()]) * 180 / kPi, phi = 90 * at[s.parameters() + 1];
    AlbedoOptions few;
    few.max_evaluations = 40'000;
    for (const AlbedoResult& a : directional_albedo(m, degrees(theta), degrees(phi), few)) {
      const double sure = a.value - a.error_bound;
      if (!a.converged || (best && best->value - 1e-9 >= sure)) continue;
      best = Witness{named(s, at),
                     {{"theta", theta}, {"phi", phi}},
                     a.value,
                     "brdf albedo" + words + " --theta " + io::to_text(theta) + " --phi " + io::to_text(phi)};
    }
  }
  return best;
}

// The domain in words, for every sentence that rests on it.
std::string within_domain() {
  return ", for cosines from " + io::short_number(kLeastShaderCosine, 3);
}

// What is known where the boxes do not decide.
void by_trial(Proof& p, const Subject& s, const std::optional<shader::UndefinedValue>& may_be) {
  const bool finite = p.claim.property == Property::finite;
  p.statement = std::to_string(p.cover.open) + (p.cover.open == 1 ? " box is" : " boxes are") + " open";
  if (auto witness = fault_of(s, p.claim, *p.domain)) {
    p.verdict = Verdict::refuted;
    p.statement = finite ? "f is no finite number" : "f is negative";
    p.witness = std::move(witness);
  } else if (const auto undefined = undefined_of(s, p.claim.precision, *p.domain)) {
    p.verdict = Verdict::no_method;
    p.statement = "undefined: " + *undefined;
  } else if (may_be) {
    p.statement += ": the value may be undefined there: " + shader::to_text(s.function(), *may_be);
  }
}

void by_boxes(Proof& p, const Subject& s, const Options& options) {
  const bool in_float = p.claim.precision == Precision::float_type;
  p.domain = s.domain(true);
  p.arithmetic = in_float ? "as rounded in float" : "as rounded in double";
  std::optional<shader::UndefinedValue> may_be;
  p.cover = cover(
      *p.domain,
      [&](const Box& box) {
        const ShaderInputs in = s.inputs(box);
        const ShaderBounds b =
            in_float ? shader_on_box<float>(s.function(), in) : shader_on_box<double>(s.function(), in);
        if (b.undefined) may_be = b.undefined;
        return b.value;
      },
      [&](Bounds b) { return settles(p.claim.property, b, 0); }, options.search);
  p.low = p.cover.range.lo;
  p.high = p.cover.range.hi;
  p.verdict = p.cover.open == 0 ? Verdict::proved : Verdict::bounded;
  if (p.cover.open > 0) return by_trial(p, s, may_be);
  const bool finite = p.claim.property == Property::finite;
  p.statement = (finite ? "f is a number" : "f is nowhere below 0") + within_domain();
  if (const auto beyond = fault_of(s, p.claim, below(*p.domain)))
    p.statement += std::string("; below that f ") + (finite ? "is no finite number" : "is negative") + ": " +
                   beyond->command;
  else if (const auto undefined = undefined_of(s, p.claim.precision, below(*p.domain)))
    p.statement += "; below that f is undefined: " + *undefined;
}

void energy(Proof& p, const Subject& s, const Options& options) {
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
  p.cover = bound_albedo(*p.domain, viewers, 1 + kAlbedoSlack, search);
  p.low = witness ? witness->value : 0;
  p.high = p.cover.range.hi;
  p.verdict = refuted ? Verdict::refuted : p.cover.open == 0 ? Verdict::proved : Verdict::bounded;
  if (refuted) {
    p.statement = "the albedo is above 1";
    p.witness = witness;
  } else if (p.cover.open == 0) {
    p.statement = "the albedo is at most " + io::short_number(p.high, 7) + within_domain() + " of the light";
  } else if (const auto undefined = undefined_of(s, Precision::double_type, s.domain(true))) {
    p.verdict = Verdict::no_method;
    p.statement = "undefined: " + *undefined;
  } else {
    p.statement = std::to_string(p.cover.open) + (p.cover.open == 1 ? " box is" : " boxes are") +
                  " open after " + std::to_string(p.cover.boxes) +
                  " were enclosed: the albedo may be above 1 there; more --seconds go on";
    if (may_be) p.statement += "; the value may be undefined: " + shader::to_text(s.function(), *may_be);
  }
}

}  // namespace

std::vector<Proof> prove(const shader::ShaderReflectance& model, const Material& material,
                         const std::string& words, const Options& options) {
  std::vector<Proof> proofs;
  const auto add = [&](Property property, Precision precision) {
    const auto start = std::chrono::steady_clock::now();
    Proof p;
    p.claim = {-1, property, precision};
    p.form = model.info().name;
    const bool in_float = precision == Precision::float_type;
    const shader::Function& f = model.function();
    const Subject subject{model, material, words,
                          !(in_float ? f.turning<float>() : f.turning<double>()).isotropic};
    const std::string unknown = unknown_operation(in_float ? f.as_written : f.as_meant);
    if (property == Property::reciprocity || property == Property::rounding)
      p.statement = "not shown of shaders";
    else if (!unknown.empty())
      p.statement = "it has " + unknown;
    else if (property == Property::energy)
      energy(p, subject, options);
    else
      by_boxes(p, subject, options);
    p.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    proofs.push_back(std::move(p));
  };
  for (const Property property : options.properties)
    for (const Precision precision : {Precision::float_type, Precision::double_type})
      if (is_of_a_precision(property) || precision == Precision::double_type) add(property, precision);
  return proofs;
}

}  // namespace brdf::prove
