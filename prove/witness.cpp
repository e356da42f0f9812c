#include <algorithm>
#include <array>

#include "brdf/integrals.h"
#include "brdf/material.h"
#include "io/files/text.h"
#include "io/material/settings.h"
#include "io/samples/degrees.h"
#include "prove/check/channel.h"
#include "prove/proof.h"

namespace brdf::prove {
namespace {

using Angles = std::array<double, 3>;  // theta_i, theta_o, phi_o, degrees

// The declared violation of a property as a material of one channel.
struct Declared {
  Material material;
  Witness witness;  // its parameters
  std::string options;
};
Declared declared(const Reflectance& form, const Violation& v) {
  std::vector<std::string_view> fields;
  io::split_blanks(v.witness, fields);
  Declared d{declared_material(form, v), {}, " --form " + std::string(form.info().name)};
  d.witness.violation = int(&v - form.info().violations.data());
  const auto settings = io::parse_settings({fields.begin(), fields.end()}, "witness");
  for (const io::Setting& s : settings) {
    d.witness.parameters.emplace_back(s.name, s.values.front());
    d.options += " --set " + s.name + "=" + io::to_text(s.values.front());
  }
  return d;
}

double value_at(const Material& material, const Angles& at) {
  double f = 0;
  eval(material, io::unit_vector(at[0], 0), io::unit_vector(at[1], at[2]), {&f, 1});
  return f;
}

// Returns the place of the least value between these angles, by a grid that is refined around its least
// value.
Angles least(const Material& material, const Angles& low, const Angles& high) {
  constexpr int kSteps = 12, kRounds = 8;
  Angles best = low, from = low, to = high;
  double value = value_at(material, best);
  for (int round = 0; round < kRounds; ++round) {
    for (int k = 0; k < (kSteps + 1) * (kSteps + 1) * (kSteps + 1); ++k) {
      const int steps[] = {k % (kSteps + 1), k / (kSteps + 1) % (kSteps + 1),
                           k / (kSteps + 1) / (kSteps + 1)};
      Angles at;
      for (std::size_t j = 0; j < at.size(); ++j) at[j] = from[j] + (to[j] - from[j]) * steps[j] / kSteps;
      const double here = value_at(material, at);
      if (here < value) {
        value = here;
        best = at;
      }
    }
    for (std::size_t j = 0; j < best.size(); ++j) {
      const double reach = 1.5 * (to[j] - from[j]) / kSteps;
      from[j] = std::max(low[j], best[j] - reach);
      to[j] = std::min(high[j], best[j] + reach);
    }
  }
  return best;
}

}  // namespace

std::optional<Witness> find_negative(const Reflectance& form) {
  for (const Violation& v : form.info().violations) {
    if (v.check != name_of(Property::non_negative)) continue;
    Declared d = declared(form, v);
    const Angles at = least(d.material, {v.theta, 0, 0}, {v.theta, 90, 180});
    d.witness.value = value_at(d.material, at);
    if (!(d.witness.value < 0)) continue;
    d.witness.angles = {{"theta_i", at[0]}, {"phi_i", 0}, {"theta_o", at[1]}, {"phi_o", at[2]}};
    d.witness.command = "printf 'theta_i,phi_i,theta_o,phi_o\\n" + io::to_text(at[0]) + ",0," +
                        io::to_text(at[1]) + "," + io::to_text(at[2]) + "\\n' | brdf eval" + d.options + " -";
    return d.witness;
  }
  return std::nullopt;
}

std::optional<Witness> find_gain(const Reflectance& form) {
  std::optional<Witness> worst;
  for (const Violation& v : form.info().violations) {
    if (v.check != name_of(Property::energy)) continue;
    Declared d = declared(form, v);
    const AlbedoResult albedo = directional_albedo(d.material, degrees(v.theta), degrees(0)).front();
    if (!albedo.converged || albedo.value - albedo.error_bound <= 1) continue;
    if (worst && worst->value >= albedo.value) continue;
    d.witness.value = albedo.value;
    d.witness.angles = {{"theta", v.theta}, {"phi", 0}};
    d.witness.command = "brdf albedo" + d.options + " --theta " + io::to_text(v.theta);
    worst = d.witness;
  }
  return worst;
}

}  // namespace brdf::prove
