#include "validate/joint/pointwise.h"

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "validate/joint/rounded_direction.h"

namespace brdf::validate {
namespace {

constexpr double kNearlyZero = 1e-10;  // values below this are compared in absolute terms
constexpr double kUnit = 1e-5;         // of the length of a direction
constexpr double kVisible = 0.01;      // between float and double
// A cosine below 0 by less than this is the rounding of a direction at the horizon, in float.
constexpr double kAtHorizon = 1e-6;
constexpr long kMostExamined = 4096;  // differences of a case; more are not called rounding

double relative(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return a == b ? 0 : HUGE_VAL;
  const double larger = std::max(std::abs(a), std::abs(b));
  return larger < kNearlyZero ? 0 : std::abs(a - b) / larger;
}

bool finite(const Vec3<double>& w) {
  return std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.z);
}

double length_error(const Vec3<double>& w) {
  return std::abs(std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z) - 1);
}

// The value of a quantity for f and the density of a direction.
double quantity(SampleValue kind, double f, double cosine, double pdf) {
  if (kind == SampleValue::f) return f;
  return kind == SampleValue::f_cos_i ? f * cosine : f * cosine / pdf;
}

// A draw that returns no direction at all, by its truth value or by a density of 0.
bool is_no_sample(const SamplerFacts& facts, const Draw& draw) {
  return !draw.valid || (facts.gives_pdf && draw.pdf == 0);
}

std::string fault_of(const SamplerFacts& facts, const Draw& draw) {
  const bool none = is_no_sample(facts, draw);
  for (std::size_t k = 0; k < facts.values.size(); ++k)
    for (const double x : draw.values[k])
      if (!std::isfinite(x) && draw.valid) return "the value is " + io::short_number(x);
  if (facts.gives_pdf && draw.valid && !std::isfinite(draw.pdf))
    return "the density is " + io::short_number(draw.pdf);
  if (facts.gives_pdf && draw.valid && draw.pdf < 0) return "the density is below 0";
  if (none) return "";
  if (!finite(draw.wi)) return "the direction is not finite";
  if (length_error(draw.wi) > 1e-3) return "the direction is not of unit length";
  return "";
}

}  // namespace

void ComparedDraws::add(double difference, double bound, const Vec3<double>& at,
                        std::span<const double> numbers) {
  ++compared;
  if (!(difference <= bound)) ++differing;
  if (!(difference > worst)) return;
  worst = difference;
  wi = at;
  u.assign(numbers.begin(), numbers.end());
}

void ComparedDraws::add_explained(double difference) {
  ++compared, ++explained;
  worst_explained = std::max(worst_explained, difference);
}

Quantities quantities_of(const Trio& trio, std::uint64_t seed) {
  const SamplerFacts& facts = trio.facts();
  Quantities out;
  std::vector<long> as_eval(facts.values.size()), as_weight(facts.values.size());
  // Without f there are no comparisons, and a value counts as what the reflectance would return.
  if (facts.has_eval && !facts.values.empty())
    for_draws(trio, 512, seed, [&](std::span<const double>, std::span<const Draw> draws) {
      for (const Draw& draw : draws) {
        if (!counts(facts, draw)) continue;
        const double f = trio.f(std::span(&draw.wi, 1), false)[0];
        const double pdf = facts.gives_pdf     ? draw.pdf
                           : facts.has_density ? trio.density_of(draw.wi, trio.at().wo)
                                               : std::nan("");
        for (std::size_t k = 0; k < facts.values.size(); ++k) {
          const double value = draw.values[k][0];
          as_eval[k] += relative(value, quantity(facts.eval_returns, f, draw.wi.z, pdf)) <= kSameValue;
          const double weight = quantity(SampleValue::weight, f, draw.wi.z, pdf);
          as_weight[k] += relative(value, weight) <= kSameValue;
          as_weight[k] += relative(value, weight / draw.wi.z) <= kSameValue;  // judged as a weight, too
        }
      }
    });
  for (std::size_t k = 0; k < facts.values.size(); ++k) {
    const auto& value = facts.values[k];
    out.of.push_back(value.kind                  ? *value.kind
                     : as_weight[k] > as_eval[k] ? SampleValue::weight
                                                 : facts.eval_returns);
    if (!value.kind && facts.has_eval && out.announced.empty())
      out.announced =
          "the value is taken as " + std::string(name_of(out.of.back())) +
          (as_weight[k] > as_eval[k] ? ", which it equals" : ", as " + facts.eval_name + " returns");
  }
  return out;
}

void compare_draws(const Trio& trio, const Quantities& quantities, std::span<const double> u,
                   std::span<const Draw> draws, Pointwise& out) {
  const SamplerFacts& facts = trio.facts();
  std::vector<Vec3<double>> wi(draws.size());
  for (std::size_t k = 0; k < draws.size(); ++k)
    wi[k] = counts(facts, draws[k]) && finite(draws[k].wi) ? draws[k].wi : Vec3<double>{0, 0, 1};
  const std::vector<double> f = trio.f(wi, false);
  const std::vector<double> density = facts.has_density ? trio.density(wi) : std::vector<double>{};
  for (std::size_t k = 0; k < draws.size(); ++k) {
    const Draw& draw = draws[k];
    const std::span<const double> numbers = u.subspan(k * facts.randoms, facts.randoms);
    const std::string fault = fault_of(facts, draw);
    const bool of_length = fault.find("unit length") != std::string::npos;
    out.not_finite.add(!fault.empty() && !of_length, 0, draw.wi, numbers);
    if (!fault.empty() && !of_length) continue;
    if (!is_no_sample(facts, draw)) out.length.add(length_error(draw.wi), kUnit, draw.wi, numbers);
    // A direction below the horizon may be returned with a density of 0, or with a value of 0 if the sampler
    // returns no density.
    bool dark = true;
    for (std::size_t j = 0; j < facts.values.size(); ++j)
      for (const double x : draw.values[j]) dark = dark && x == 0;
    const bool is_below = draw.valid && draw.wi.z < 0 && (facts.gives_pdf ? draw.pdf > 0 : !dark);
    out.lost_below += draw.valid && draw.wi.z < 0 && !is_below;
    if (is_below && draw.wi.z > -kAtHorizon)
      out.below.add_explained(-draw.wi.z);
    else
      out.below.add(is_below ? -draw.wi.z : 0, 0, draw.wi, numbers);
    if (!counts(facts, draw)) continue;
    std::optional<RoundedDirection> rounded;  // found only if there is a difference
    const auto is_rounding = [&](double returned, const auto& value_at) {
      if (!rounded && ++out.examined > kMostExamined) return false;
      if (!rounded) rounded.emplace(trio, draw.wi);
      return rounded->explains(returned, value_at);
    };
    if (facts.has_density) {
      const bool is_dark = density[k] <= 0;
      const auto has_density = [](const RoundedDirection& r, std::size_t n) {
        return double(r.density(n) > 0);
      };
      if (is_dark && is_rounding(1, has_density))
        out.impossible.add_explained(1);
      else
        out.impossible.add(is_dark, 0, draw.wi, numbers);
    }
    if (facts.gives_pdf && facts.has_density) {
      const double difference = relative(draw.pdf, density[k]);
      if (difference > kSameValue &&
          is_rounding(draw.pdf, [](const RoundedDirection& r, std::size_t n) { return r.density(n); })) {
        out.density.add_explained(difference);
      } else {
        out.density.add(difference, kSameValue, draw.wi, numbers);
        if (difference > kSameValue && out.returned.size() < 256)
          out.returned.push_back({draw.wi, density[k], draw.pdf, {}});
      }
    }
    const double pdf = facts.gives_pdf ? draw.pdf : facts.has_density ? density[k] : std::nan("");
    for (std::size_t j = 0; facts.has_eval && j < facts.values.size(); ++j) {
      if (std::isnan(pdf) && quantities.of[j] == SampleValue::weight) continue;
      double worst = 0, worst_rounded = 0;
      for (std::size_t c = 0; c < std::min<std::size_t>(trio.channels(), 3); ++c) {
        const double difference =
            relative(draw.values[j][c], quantity(quantities.of[j], f[c * wi.size() + k], draw.wi.z, pdf));
        const auto expected_at = [&](const RoundedDirection& r, std::size_t n) {
          return quantity(quantities.of[j], r.f(c, n), r.wi(n).z, facts.gives_pdf ? pdf : r.density(n));
        };
        const bool rounding = difference > kSameValue && is_rounding(draw.values[j][c], expected_at);
        (rounding ? worst_rounded : worst) = std::max(rounding ? worst_rounded : worst, difference);
      }
      if (worst_rounded > worst && worst <= kSameValue)
        out.value.add_explained(worst_rounded);
      else
        out.value.add(worst, kSameValue, draw.wi, numbers);
      if (j > 0) continue;
      const double expected = quantity(quantities.of[0], f[k], draw.wi.z, pdf);
      out.without_cosine += relative(draw.values[0][0], expected / draw.wi.z) <= kSameValue;
      for (const SampleValue kind : {SampleValue::f, SampleValue::f_cos_i, SampleValue::weight})
        out.fits[kind] += relative(draw.values[0][0], quantity(kind, f[k], draw.wi.z, pdf)) <= kSameValue;
    }
  }
}

Edges edges_of(const Trio& trio) {
  const SamplerFacts& facts = trio.facts();
  constexpr double kPlaces[] = {0.5, 0, 1 - 0x1p-24, 1};
  const std::size_t moving = std::min<std::size_t>(std::max<std::size_t>(trio.randoms_used(), 1), 4);
  Edges out;
  std::size_t rows = 1;
  for (std::size_t k = 0; k < moving; ++k) rows *= 4;
  std::vector<double> u(rows * facts.randoms, 0.5);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t k = 0, digits = r; k < moving; ++k, digits /= 4)
      u[r * facts.randoms + k] = kPlaces[digits % 4];
  out.combinations = int(rows);
  for (const bool single : {false, true}) {
    if (single && !facts.in_float) break;
    const std::vector<Draw> draws = trio.draw(u, single);
    for (std::size_t r = 0; r < rows; ++r) {
      const std::string fault = fault_of(facts, draws[r]);
      if (fault.empty()) continue;
      const auto begin = u.begin() + long(r * facts.randoms);
      const bool at_one = std::find(begin, begin + long(moving), 1.0) != begin + long(moving);
      // A fault at other numbers counts more than one at exactly 1, which many generators never return.
      if (!out.fault.empty() && (at_one || !out.only_at_one)) continue;
      out.fault = fault + (single ? " in float" : "");
      out.only_at_one = at_one;
      out.u.assign(begin, begin + long(moving));
    }
  }
  return out;
}

SingleCompared single_of(const Trio& trio, std::size_t count, std::uint64_t seed) {
  constexpr double kTurned = 1e-3, kBeside = 1e-6;
  const SamplerFacts& facts = trio.facts();
  SingleCompared out;
  for_draws(trio, count, seed, [&](std::span<const double> numbers, std::span<const Draw>) {
    std::vector<double> u(numbers.begin(), numbers.end());
    for (double& x : u) x = std::floor(x * 0x1p24) * 0x1p-24;  // exact in float
    const std::vector<Draw> wide = trio.draw(u), narrow = trio.draw(u, true);
    for (std::size_t k = 0; k < wide.size(); ++k) {
      const Draw &a = wide[k], &b = narrow[k];
      if (!counts(facts, a) || !finite(a.wi)) continue;
      const std::span<const double> own = std::span(u).subspan(k * facts.randoms, facts.randoms);
      if (!fault_of(facts, b).empty()) {
        ++out.not_finite;
        out.difference.add(HUGE_VAL, kVisible, a.wi, own);
        continue;
      }
      const auto apart = [](const Vec3<double>& x, const Vec3<double>& y) {
        return std::hypot(std::hypot(x.x - y.x, x.y - y.y), x.z - y.z);
      };
      double difference = apart(a.wi, b.wi) / kTurned * kVisible;
      if (facts.gives_pdf) difference = std::max(difference, relative(a.pdf, b.pdf));
      for (std::size_t j = 0; j < facts.values.size(); ++j)
        difference = std::max(difference, relative(a.values[j][0], b.values[j][0]));
      bool branch = false;
      // A number next to a boundary between branches may fall on its other side in float.
      for (std::size_t j = 0; j < facts.randoms && difference > kVisible && !branch; ++j)
        for (const double sign : {-1.0, 1.0}) {
          std::vector<double> moved(own.begin(), own.end());
          moved[j] = std::clamp(moved[j] + sign * kBeside, 0.0, 1.0);
          const Draw beside = trio.draw_one(moved);
          branch = branch ||
                   (apart(beside.wi, b.wi) < kTurned && counts(facts, beside) == counts(facts, b)) ||
                   counts(facts, beside) != counts(facts, a);
        }
      if (branch)
        ++out.branches;
      else
        out.difference.add(difference, kVisible, a.wi, own);
    }
  });
  return out;
}

}  // namespace brdf::validate
