#include "validate/against.h"

#include <algorithm>
#include <cmath>

#include "io/error.h"
#include "io/numbers.h"
#include "io/settings.h"
#include "validate/pair_search.h"

namespace brdf::validate {
namespace {

constexpr double kSame = 1e-3;  // nobody sees less

double value_of(const std::vector<std::pair<std::string, double>>& parameters, std::string_view name) {
  for (const auto& [known, value] : parameters)
    if (known == name) return value;
  return NAN;
}

// The form with the parameters that belong to the subject's; values beyond its table are held at its ends.
Material counterpart(const Subject& subject, const Against& against, const Material& at) {
  Material m = make_material(against.form, at.channels);
  const auto parameters = subject.parameters(at);
  const ReflectanceInfo& f = info(against.form);
  const auto set = [&](const std::string& name, double value) {
    const ParameterInfo p = io::parameter_named(m, name, "--map");
    io::apply_settings(m, {{name, {std::clamp(std::isnan(value) ? p.initial : value, p.min, p.max)}}});
  };
  for (const auto table : {f.weights, f.shape})
    for (const ParameterInfo& p : table)
      if (const double value = value_of(parameters, p.name); !std::isnan(value))
        set(std::string(p.name), value);
  for (const auto& [name, expression] : against.map)
    set(name, expression.value([&](std::string_view of) { return value_of(parameters, of); }));
  return m;
}

}  // namespace

Against parse_against(const Subject& subject, const std::string& form, const std::vector<std::string>& maps) {
  Against out{io::require_form(form), {}};
  const Material sample = make_material(out.form, {"fr"});
  const auto parameters = subject.parameters(subject.own());
  for (const std::string& text : maps) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos || equals == 0)
      throw InputError("--map '" + text + "': must be NAME=FORMULA, as alpha=roughness*roughness");
    const std::string name = text.substr(0, equals);
    io::parameter_named(sample, name, "--map");
    io::Expression formula(text.substr(equals + 1), "--map");
    for (const std::string& of : formula.names())
      if (std::isnan(value_of(parameters, of))) {
        std::vector<std::string> known;
        for (const auto& [p, value] : parameters) known.push_back(p);
        throw InputError("--map '" + text + "': " + of + " is no parameter of " + subject.name() +
                         " (known: " + io::joined(known) + ")");
      }
    out.map.emplace_back(name, std::move(formula));
  }
  return out;
}

Finding check_against(const Subject& subject, const Against& against, const CheckOptions& options) {
  const PairMeasure measure = [&](const Material& at, const Pair& p) {
    const Material other = counterpart(subject, against, at);
    std::vector<double> a(at.channels.size()), b(a.size());
    eval(at, p.wi, p.wo, a);
    eval(other, p.wi, p.wo, b);
    double worst = 0;
    for (std::size_t c = 0; c < a.size(); ++c)
      worst = std::max(worst, std::isfinite(a[c]) ? difference(a[c], b[c], kFaintest) : 1);
    return worst;
  };
  const Best best = worst_pair(subject, measure, options);
  const Material at = subject.at(best.point), other = counterpart(subject, against, at);
  const Pair pair = pair_of(subject, best.point);
  std::vector<double> a(at.channels.size()), b(a.size());
  eval(at, pair.wi, pair.wo, a);
  eval(other, pair.wi, pair.wo, b);
  Finding finding{subject.name(), "against"};
  finding.value = best.value;
  finding.bound = kSame;
  finding.evaluations = 2 * best.calls;
  finding.witness = pair_witness(subject, at, pair);
  std::string with;
  for (const auto& [name, expression] : against.map)
    with += (with.empty() ? " with " : ", ") + name + " = " +
            io::short_number(
                expression.value([&](std::string_view of) { return value_of(subject.parameters(at), of); }));
  const std::string name(info(against.form).name);
  finding.conclude(!(best.value > kSame), "is " + name + " to " + io::percent(best.value, 2),
                   "differs from " + name + with + " by " + io::percent(best.value, 3) + " of the larger: " +
                       io::short_number(a[0], 5) + " against " + io::short_number(b[0], 5) + " /sr");
  return finding;
}

}  // namespace brdf::validate
