// The checks of single samples, and of the mean of the weights.
#include "validate/joint/sampler_judge.h"

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "validate/joint/statistics.h"

namespace brdf::validate {
namespace {

constexpr double kEnough = kMassBound / 4;  // of the integral of a density
constexpr double kPower = 1.2816;           // standard deviations for a probability of 90 %

// The samples that differ, as a share, or as a count if they are few.
std::string share_text(const ComparedDraws& draws) {
  constexpr long kFew = 100;
  if (draws.differing >= kFew) return io::percent(draws.share()) + " of the samples";
  return std::to_string(draws.differing) + " of " + std::to_string(draws.compared) + " samples";
}

}  // namespace

void SamplerJudge::judge_draws(const Trio& trio, std::size_t k, const Cells& cells,
                               std::optional<Integrals> integrals, const std::vector<DensityRow>& rows) {
  const std::size_t all = draws();
  std::vector<Vec3<double>> seen;
  std::vector<long> observed(cells.all().size());
  long lost = 0, too_many = 0;
  Weights weights(std::min<std::size_t>(trio.channels(), 3));
  Pointwise points;
  for_draws(trio, all, seed(k) + 1234567, [&](std::span<const double> u, std::span<const Draw> draws) {
    compare_draws(trio, quantities_, u, draws, points);
    weights.add(trio, quantities_, u, draws);
    for (const Draw& draw : draws) {
      too_many += draw.used > facts_.randoms;
      if (counts(facts_, draw) && std::isfinite(draw.wi.x + draw.wi.y))
        ++observed[cells.find(draw.wi)], seen.push_back(draw.wi);
      else
        ++lost;
    }
  });
  for (Finding& f : findings_) f.evaluations += long(all);
  if (too_many > 0) too_many_ = true;
  judge_points(trio, points);
  if (integrals && (integrals->mass_error > kMassBound || looks_different(*integrals, observed, lost, all))) {
    // The samples show at which places the integral has to be accurate.
    seen.resize(std::min<std::size_t>(seen.size(), 1 << 17));
    integrals = integrals_of(trio, cells, seen, kEnough, 10 * most_evaluations());
    findings_[mass].evaluations += integrals->evaluations;
  }
  if (integrals) {
    judge_mass(trio, *integrals, long(all), lost, rows);
    judge_distribution(trio, cells, *integrals, observed, lost, all);
  }
  judge_mean(trio, weights);
}

bool SamplerJudge::looks_different(const Integrals& in, const std::vector<long>& observed, long lost,
                                   std::size_t all) {
  constexpr double kFromExpected = 4;
  const auto differs = [](double seen, double expected) {
    return std::abs(seen - expected) > 1 + kFromExpected * std::sqrt(std::max(expected, 1.0));
  };
  for (std::size_t k = 0; k < observed.size(); ++k)
    if (differs(double(observed[k]), double(all) * in.density[k])) return true;
  return differs(double(lost), double(all) * std::max(1 - in.mass, 0.0));
}

void SamplerJudge::judge_points(const Trio& trio, const Pointwise& p) {
  compared_[match] += p.density.compared;
  compared_[value] += p.value.compared;
  keep_exceptions(match, p.density);
  keep_exceptions(value, p.value);
  judge_ranges(trio, p);
  judge_impossible(trio, p.impossible);
  if (p.density.differing > 0) {
    const std::string cause = cause_of(trio, p.returned);
    const bool all_differ = p.density.share() > 0.95;
    worse(
        match, p.density.share(),
        "the density that " + facts_.sampler_name + " returns and " + facts_.density_name + " differ at " +
            share_text(p.density) + ", by up to " + io::percent(p.density.worst) +
            (cause.empty() ? ""
                           : (all_differ ? "; " : "; at these samples ") + facts_.density_name + " " + cause),
        trio, &p.density.wi, p.density.u);
  }
  if (p.value.differing == 0) return;
  worse(value, p.value.share(), value_text(p), trio, &p.value.wi, p.value.u);
  if (cause_.empty() && lacks_cosine(p)) cause_of_value_ = value_name() + no_cosine_text();
}

void SamplerJudge::keep_exceptions(Place place, const ComparedDraws& draws) {
  exceptions_[place] += draws.explained;
  largest_exception_[place] = std::max(largest_exception_[place], draws.worst_explained);
}

void SamplerJudge::judge_ranges(const Trio& trio, const Pointwise& p) {
  compared_[range] += p.length.compared;
  lost_below_ += p.lost_below;
  keep_exceptions(range, p.below);
  if (p.not_finite.differing > 0)
    worse(range, 3 + p.not_finite.share(),
          "the direction, the density or the value is not finite at " + share_text(p.not_finite), trio,
          &p.not_finite.wi, p.not_finite.u);
  if (p.length.differing > 0)
    worse(range, 2 + p.length.share(),
          "the length of the direction differs from 1 by up to " + io::short_number(p.length.worst) +
              ", at " + share_text(p.length),
          trio, &p.length.wi, p.length.u);
  if (p.below.differing > 0)
    worse(range, 1 + p.below.share(),
          share_text(p.below) + " lie below the horizon and keep a density above 0 (" +
              degrees_text(trio.at()) + ")",
          trio, &p.below.wi, p.below.u);
}

bool SamplerJudge::lacks_cosine(const Pointwise& p) const {
  return quantities_.of[0] == SampleValue::weight &&
         double(p.without_cosine) > 0.99 * double(p.value.compared);
}

std::string SamplerJudge::no_cosine_text() const {
  return " is f/pdf: the factor cos_i is missing, or " + facts_.eval_name +
         " returns f*cos_i, which is not declared";
}

std::string SamplerJudge::value_name() const {
  return facts_.values[0].name.empty() ? "the value that " + facts_.sampler_name + " returns"
                                       : facts_.values[0].name;
}

std::string SamplerJudge::value_text(const Pointwise& p) const {
  const std::string name = value_name();
  std::string text = name + " is not " + std::string(name_of(quantities_.of[0])) + " at " +
                     share_text(p.value) + ", with differences up to " + io::percent(p.value.worst);
  if (lacks_cosine(p)) return text + "; " + name + no_cosine_text();
  for (const auto& [kind, count] : p.fits)
    if (kind != quantities_.of[0] && double(count) > 0.99 * double(p.value.compared))
      text += "; it is " + std::string(name_of(kind)) +
              ", so a factor is applied twice or not at all; if this is meant, declare it with " +
              facts_.before_quantity + std::string(name_of(kind)) + facts_.after_quantity;
  return text;
}

std::optional<double> SamplerJudge::limit_of(const Moments& m, double error) const {
  const double n = double(m.count()), z = two_sided_quantile(level_);
  // The skewness of rare large weights moves the quantiles of the mean (Cornish and Fisher 1938).
  const double skew = std::abs(m.skewness()) / std::sqrt(n);
  if (skew * z <= 1) return z + skew * (z * z - 1) / 6;
  // Weights of a small range, such as equal ones with a few lost samples: Bernstein's inequality with the
  // variance of the weights (Maurer and Pontil 2009).
  if (m.smallest() < 0 || m.largest() > 2 * m.mean()) return std::nullopt;
  const double logarithm = std::log(4 / level_);
  return std::sqrt(2 * logarithm) + 7 * (m.largest() - m.smallest()) * logarithm / (3 * (n - 1) * error);
}

void SamplerJudge::judge_mean(const Trio& trio, const Weights& weights) {
  if (weights.not_finite().differing > 0) {
    worse(mean, HUGE_VAL,
          "the mean of the weights is not finite, because the weight is not at " +
              io::percent(weights.not_finite().share()) + " of the samples: " + weights.reason(),
          trio, &weights.not_finite().wi, weights.not_finite().u);
    return;
  }
  if (!facts_.has_eval) {
    mean_why_ = facts_.no_eval;
    return;
  }
  const SampledCase& at = trio.at();
  AlbedoOptions integral;
  integral.fixed = Fixed::viewer;
  integral.tolerance = 1e-6;
  integral.max_evaluations = 400'000;
  for (std::size_t c = 0; c < weights.of().size(); ++c) {
    const Moments& m = weights.of()[c];
    if (m.count() == 0) {
      mean_why_ =
          facts_.no_density + ", and " + facts_.sampler_name + " returns neither a density nor a weight";
      return;
    }
    double truth = 0, bound = 0;
    for (const Term& term : at.at.terms) {
      const AlbedoResult result = directional_albedo(term, c, degrees(at.theta), degrees(at.phi), integral);
      truth += result.value, bound += result.error_bound;
    }
    if (!(truth > 0) || bound > 1e-3 * truth) {
      mean_why_ = "the albedo could not be integrated accurately enough";
      continue;
    }
    const double error = m.error() + 1e-9 * truth;
    const std::optional<double> limit = limit_of(m, error);
    if (!limit) {
      mean_why_ = "a few large weights dominate the mean: the largest is " + io::short_number(m.largest()) +
                  " for a mean of " + io::short_number(m.mean());
      continue;
    }
    ++done_[mean];
    // Constants such as 1 / pi may be rounded differently in two functions.
    const double z = std::max(std::abs(m.mean() - truth) - bound - kSameValue * truth, 0.0) / error;
    findings_[mean].value = std::max(findings_[mean].value, z);
    power_[mean] = std::max(power_[mean], ((*limit + kPower) * error + bound) / truth + kSameValue);
    const double relative = std::sqrt(m.variance()) / truth;
    if (relative > noise_) {
      noise_ = relative;
      largest_weight_ = m.largest() / truth;
      best_ = least_noise_of_catalogue(trio, c, truth, seed(1));
    }
    if (z > *limit)
      worse(mean, z,
            "the mean of the weights is " + io::short_number(m.mean(), 5) + " +- " +
                io::short_number(error, 2) + ", but the albedo is " + io::short_number(truth, 5) + " (" +
                degrees_text(at) + "): " + io::short_number(z, 3) + " standard errors" +
                (!cause_.empty()            ? "; " + cause_
                 : !cause_of_value_.empty() ? "; " + cause_of_value_
                                            : ""),
            trio);
  }
}

}  // namespace brdf::validate
