#include "prove/shader/trial.h"

#include <algorithm>
#include <cmath>

#include "io/files/text.h"
#include "io/samples/degrees.h"
#include "io/samples/samples.h"
#include "prove/shader/shader_proof.h"

namespace brdf::prove {
namespace {

constexpr double kLowestTried = 1e-12;  // the least cosine of a trial
constexpr int kTrials = 4000;

void add_direction(Domain& d, const std::string& which, bool turns) {
  d.variables.push_back({"cos_" + which, kLeastShaderCosine, 1, Variable::Cut::cosine});
  d.variables.push_back({"turn_" + which, turns ? -2.0 : 0.0, turns ? 2.0 : 0.0, Variable::Cut::middle});
}

// Returns the first and the last whole number of a range. A range without whole numbers makes no claim: the
// whole number below it represents it.
Bounds whole_within(Bounds range) {
  const double last = std::floor(range.hi);
  return {std::min(std::ceil(range.lo), last), last};
}

// A point of the domain as a material and a pair of directions.
struct Trial {
  std::vector<double> at;
  std::string words;
  Material material;
  double theta_i, phi_i, theta_o, phi_o;  // degrees
  Vec3<double> wi, wo;

  Trial(const ShaderSubject& s, std::vector<double> point)
      : at(s.possible(std::move(point))), words(s.words), material(s.at(at, words)) {
    const std::size_t d = s.parameters();
    const auto theta = [](double cosine) { return std::acos(cosine) * 180 / kPi; };
    theta_i = theta(at[d]), phi_i = 90 * at[d + 1];
    theta_o = theta(at[d + 2]), phi_o = 90 * at[d + 3];
    wi = io::unit_vector(theta_i, phi_i), wo = io::unit_vector(theta_o, phi_o);
  }
  // Returns the value of every channel as the claim's scalar computes it.
  std::vector<double> values(Precision precision) const {
    std::vector<double> f(material.channels.size());
    if (precision == Precision::double_type) {
      eval(material, wi, wo, f);
      return f;
    }
    const Vec3<float> i{float(wi.x), float(wi.y), float(wi.z)}, o{float(wo.x), float(wo.y), float(wo.z)};
    for (std::size_t c = 0; c < f.size(); ++c) {
      float value;
      eval_batch(material.terms.front(), c, one_pair(i, o), &value);
      f[c] = double(value);
    }
    return f;
  }
  std::optional<shader::UndefinedValue> undefined(const ShaderSubject& s, Precision precision) const {
    const std::vector<double> values = s.values(std::span<const double>(at));
    return precision == Precision::float_type ? shader::undefined_value<float>(s.function(), values, wi, wo)
                                              : shader::undefined_value<double>(s.function(), values, wi, wo);
  }
  // Returns a witness of a violation of the claim, if the value is defined here.
  std::optional<Witness> fault(const ShaderSubject& s, const Claim& claim) const {
    for (const double x : values(claim.precision)) {
      if (claim.property == Property::finite ? std::isfinite(x) : !(x < 0)) continue;
      if (undefined(s, claim.precision)) return std::nullopt;
      return witness(s, claim.precision, x);
    }
    return std::nullopt;
  }

 private:
  Witness witness(const ShaderSubject& s, Precision precision, double value) const {
    Witness w;
    w.parameters = s.named(at);
    w.angles = {{"theta_i", theta_i}, {"phi_i", phi_i}, {"theta_o", theta_o}, {"phi_o", phi_o}};
    w.value = value;
    w.command = "printf 'theta_i,phi_i,theta_o,phi_o\\n" + io::to_text(theta_i) + "," + io::to_text(phi_i) +
                "," + io::to_text(theta_o) + "," + io::to_text(phi_o) + "\\n' | brdf eval" + words +
                (precision == Precision::float_type ? " --float -" : " -");
    return w;
  }
};

}  // namespace

std::size_t ShaderSubject::place(std::size_t parameter) const {
  std::size_t out = 0;
  for (std::size_t k = 0; k < parameter; ++k) out += width(function().parameters[k]);
  return out;
}

std::vector<double> ShaderSubject::possible(std::vector<double> point) const {
  for (std::size_t k = 0; k < function().parameters.size(); ++k)
    if (function().parameters[k].whole) point[place(k)] = std::floor(point[place(k)] + 0.5);
  return point;
}

Domain ShaderSubject::domain(bool with_viewer) const {
  Domain d;
  for (const shader::Parameter& p : function().parameters)
    for (std::size_t c = 0; c < width(p); ++c)
      d.variables.push_back({width(p) > 1 ? p.name + "_" + "rgb"[c] : p.name, p.min, p.max,
                             p.log_scale && p.min > 0 ? Variable::Cut::logarithmic : Variable::Cut::middle});
  add_direction(d, "i", turns);
  if (with_viewer) add_direction(d, "o", true);
  return d;
}

ShaderInputs ShaderSubject::inputs(std::span<const Bounds> box) const {
  ShaderInputs in;
  in.values = values(box);
  for (const shader::Parameter& p : function().parameters)
    if (p.whole) in.values[p.first] = whole_within(in.values[p.first]);
  const std::size_t at = parameters();
  in.cos_i = box[at];
  in.turn_i = box[at + 1];
  if (box.size() > at + 2) {
    in.cos_o = box[at + 2];
    in.turn_o = box[at + 3];
  }
  return in;
}

Material ShaderSubject::at(std::span<const double> values, std::string& said) const {
  Material m = material;
  Term& term = m.terms.front();
  if (model.reads_first_channel() && m.channels.size() == 1) {
    m.channels = {"r", "g", "b"};
    term.weights.resize(3, term.weights.front());
    term.shape.resize(3, term.shape.front());
  }
  const auto& weights = model.weight_parameters();
  const auto& shape = model.shape_parameters();
  for (std::size_t k = 0; k < weights.size(); ++k)
    for (std::size_t c = 0; c < term.weights.size(); ++c)
      term.weights[c][k] = values[place(weights[k]) + (width(function().parameters[weights[k]]) > 1 ? c : 0)];
  for (std::size_t k = 0; k < shape.size(); ++k)
    for (auto& values_of_shape : term.shape) values_of_shape[k] = values[place(shape[k])];
  for (std::size_t k = 0; k < function().parameters.size(); ++k) {
    const shader::Parameter& p = function().parameters[k];
    said += " --set " + p.name + "=" + io::to_text(values[place(k)]);
    for (std::size_t c = 1; c < width(p); ++c) said += "," + io::to_text(values[place(k) + c]);
  }
  return m;
}

std::vector<std::pair<std::string, double>> ShaderSubject::named(std::span<const double> values) const {
  std::vector<std::pair<std::string, double>> all;
  const Domain names = domain(false);
  for (std::size_t k = 0; k < parameters(); ++k) all.emplace_back(names.variables[k].name, values[k]);
  return all;
}

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

Domain below(Domain domain) {
  for (Variable& v : domain.variables)
    if (v.name.starts_with("cos_")) v.high = v.low, v.low = kLowestTried;
  return domain;
}

namespace {

// Tries the domain. If it holds a single turn of the light, because the function is isotropic in real
// numbers, other turns are tried as well: they round differently.
template <class Try>
auto first_found(const Domain& domain, std::uint64_t seed, Try&& attempt)
    -> decltype(attempt(std::vector<double>{})) {
  Domain turned = domain;
  bool is_one_turn = false;
  for (Variable& v : turned.variables)
    if (v.name == "turn_i" && v.low == v.high) is_one_turn = true, v.low = -2, v.high = 2;
  std::mt19937_64 e(seed);
  for (int k = 0; k < (is_one_turn ? 2 : 1) * kTrials; ++k)
    if (auto found = attempt(point_of(k < kTrials ? domain : turned, e))) return found;
  return std::nullopt;
}

}  // namespace

std::optional<Witness> fault_at(const ShaderSubject& s, const Claim& claim, std::vector<double> point) {
  return Trial(s, std::move(point)).fault(s, claim);
}

std::optional<Witness> fault_of(const ShaderSubject& s, const Claim& claim, const Domain& domain) {
  return first_found(domain, 1, [&](std::vector<double> at) { return fault_at(s, claim, std::move(at)); });
}

std::optional<std::string> undefined_of(const ShaderSubject& s, Precision precision, const Domain& domain) {
  const auto found = first_found(
      domain, 3, [&](std::vector<double> at) { return Trial(s, std::move(at)).undefined(s, precision); });
  return found ? std::optional(shader::to_text(s.function(), *found)) : std::nullopt;
}

}  // namespace brdf::prove
