#include "validate/joint/judge_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "brdf/integrals.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "validate/joint/catalogue_noise.h"
#include "validate/joint/cells.h"
#include "validate/joint/density_cause.h"
#include "validate/joint/jacobian.h"
#include "validate/joint/pointwise.h"
#include "validate/joint/statistics.h"
#include "validate/joint/weights.h"

namespace brdf::validate {
namespace {

constexpr double kMassBound = 1e-4, kLostAlbedo = 1e-4;
constexpr double kTolerance = 1e-6, kEnough = kMassBound / 4;  // of the integral of a density
constexpr double kPower = 1.2816;  // standard deviations for a probability of 90 %
constexpr double kLeastExpected = 25;

std::string degrees_text(const SampledCase& c) {
  return "theta_o " + io::short_number(c.theta, 3);
}

class SamplerJudge {
 public:
  // Places in kSamplerChecks.
  enum Place : std::size_t {
    mass,
    match,
    value,
    jacobian,
    distribution,
    mean,
    support,
    range,
    single,
    places
  };
  static_assert(std::size(kSamplerChecks) == places);

  SamplerJudge(const Subject& subject, const DirectionSampler& sampler, const CheckOptions& options,
               std::size_t draws_of_a_case)
      : subject_(subject),
        sampler_(sampler),
        facts_(sampler.facts()),
        options_(options),
        cases_(cases_of(subject, facts_, options)),
        findings_(places) {
    const std::size_t channels = cases_.front().at.channels.size();
    tests_ = int(cases_.size() * (1 + 2 + channels));
    level_ = sidak(kFalseAlarm, tests_);
    full_ = options.effort == Effort::full;
    draws_ = draws_of_a_case > 0 ? draws_of_a_case : full_ ? 1u << 20 : 1u << 18;
    for (std::size_t k = 0; k < places; ++k) findings_[k].outcome = Outcome::undecided;
  }

  std::vector<Finding> run() {
    for (std::size_t k = 0; k < cases_.size(); ++k) {
      // A case costs as much as several points of other checks.
      constexpr int kPointsOfACase = 8;
      bool may = true;
      for (int point = 0; point < kPointsOfACase && options_.budget; ++point)
        may = options_.budget->take() && may;
      if (may) one_case(k);
    }
    conclude();
    return std::move(findings_);
  }

 private:
  bool has_pdf() const { return facts_.has_density || facts_.gives_pdf; }
  std::uint64_t seed(std::size_t k) const { return options_.seed * 1000003 + k; }
  std::size_t draws() const { return draws_; }

  // Keeps the worst place of a check. `severity`: larger is worse.
  struct Worst {
    double severity = -1;
    std::string text = {};
    Witness witness = {};
  };
  void worse(Place place, double severity, const std::string& text, const Trio& trio,
             const Vec3<double>* wi = nullptr, std::span<const double> u = {}) {
    Worst& worst = worst_[place];
    if (!(severity > worst.severity)) return;
    const std::size_t used = std::min(u.size(), trio.randoms_used());
    worst = {severity, text, witness_of(subject_, trio, kSamplerChecks[place], options_, wi, u.first(used))};
  }

  void one_case(std::size_t k) {
    const Trio trio(sampler_, cases_[k]);
    cause_ = cause_of_value_ = "";
    if (k == 0 && facts_.draws) quantities_ = quantities_of(trio, seed(k));
    std::vector<Vec3<double>> pilot;
    long tried = 0;
    if (facts_.draws)
      for_draws(trio, 8192, seed(k) + 77, [&](std::span<const double>, std::span<const Draw> draws) {
        for (const Draw& draw : draws) {
          ++tried;
          if (counts(facts_, draw) && std::isfinite(draw.wi.x + draw.wi.y)) pilot.push_back(draw.wi);
        }
      });
    const Cells cells(pilot);
    std::optional<Integrals> integrals;
    if (facts_.has_density) {
      integrals = integrals_of(trio, cells, pilot, kTolerance, most_evaluations());
      findings_[mass].evaluations += integrals->evaluations;
      judge_support(trio, *integrals);
    }
    std::vector<DensityRow> rows;
    if (facts_.draws && has_pdf()) rows = judge_jacobian(trio, k);
    if (facts_.draws)
      judge_draws(trio, k, cells, integrals, rows);
    else if (integrals)
      judge_mass(trio, *integrals, 0, 0, rows);
    if (facts_.draws) judge_edges(trio);
    if (facts_.draws) judge_single(trio, k);
  }

  void judge_support(const Trio& trio, const Integrals& integrals) {
    if (!facts_.has_eval) return;
    ++done_[support];
    for (std::size_t c = 0; c < trio.channels() && c < 3; ++c) {
      if (!(integrals.albedo[c] > 0)) continue;
      const double share = integrals.without_density[c] / integrals.albedo[c];
      findings_[support].value = std::max(findings_[support].value, share);
      if (share > kLostAlbedo)
        worse(support, share,
              "the density is 0 at directions that reflect " + io::percent(share) +
                  " of the albedo, so that no sample reaches this part; f cos_i is " +
                  io::short_number(integrals.unreached_value) + " /sr at the direction named",
              trio, &integrals.unreached);
    }
  }

  std::vector<DensityRow> judge_jacobian(const Trio& trio, std::size_t k) {
    const JacobianRows found = jacobian_rows(trio, full_ ? 256 : 48, seed(k) + 5);
    probes_ += found.probes;
    decided_ += long(found.rows.size());
    if (!found.why.empty()) jacobian_why_ = found.why;
    long wrong = 0;
    double worst = 0;
    const DensityRow* at = nullptr;
    for (const DensityRow& row : found.rows) {
      const double difference = std::abs(row.claimed / row.truth - 1);
      wrong += !(difference <= kJacobianBound);
      largest_ratio_error_ = std::max(largest_ratio_error_, difference);
      if (!(difference <= worst)) worst = difference, at = &row;
    }
    // A single row may be one at which a lobe was not found.
    if (wrong >= 3) {
      const std::string cause = cause_of(trio, found.rows);
      const std::string which = facts_.has_density ? facts_.density_name : facts_.pdf_name;
      worse(jacobian, double(wrong) / double(found.rows.size()) + 1e-3 * std::min(worst, 1.0),
            which + " differs from the density of the samples at " + std::to_string(wrong) + " of " +
                std::to_string(found.rows.size()) + " directions: " + io::short_number(at->claimed) +
                " against " + io::short_number(at->truth) + " /sr" +
                (cause.empty() ? "; no known cause explains the ratios" : "; " + which + " " + cause),
            trio, &at->wi, at->u);
      if (!cause.empty()) cause_ = which + " " + cause;
    }
    return found.rows;
  }

  void judge_mass(const Trio& trio, const Integrals& in, long all, long lost,
                  const std::vector<DensityRow>& rows) {
    ++done_[mass];
    const double error = in.mass_error + kMassBound / 2;
    findings_[mass].value = std::max(findings_[mass].value, std::abs(in.mass - 1));
    largest_mass_error_ = std::max(largest_mass_error_, in.mass_error);
    const std::string integral = "the density integrates to " + io::short_number(in.mass, 5) + " (+-" +
                                 io::short_number(in.mass_error, 2) + ") over the hemisphere";
    const std::string cause = cause_.empty() || rows.empty() ? "" : "; " + cause_;
    if (!in.all_finite) {
      worse(mass, 1e6, facts_.density_name + " is below 0 or not finite", trio, &in.not_finite);
      return;
    }
    if (in.mass - error > 1) {
      worse(mass, in.mass, integral + ", more than 1" + cause, trio);
      return;
    }
    if (all == 0) {
      if (in.mass + error < 1)
        mass_unknown_ = integral + ", which is right only if " + io::percent(1 - in.mass) +
                        " of the samples are lost; there is no sampler to count them";
      return;
    }
    // The lost samples follow a binomial distribution; the error of the integral widens it.
    const double expected = double(all) * std::clamp(1 - in.mass, 0.0, 1.0),
                 slack = double(all) * in.mass_error;
    double probability = 1;
    if (double(lost) < expected - slack || double(lost) > expected + slack) {
      const double nearest = double(lost) < expected ? expected - slack : expected + slack;
      const double z = (double(lost) - nearest) / std::sqrt(nearest * (1 - nearest / double(all)) + 1e-300);
      probability = nearest < 400 ? poisson_two_sided(double(lost), nearest) : two_sided_tail(z);
    }
    if (in.mass_error > 1e-3) {
      mass_unknown_ = integral + ": the integral is not accurate enough";
      return;
    }
    if (probability < level_ && std::abs(double(lost) / double(all) - (1 - in.mass)) > kMassBound)
      worse(mass, std::abs(1 - in.mass - double(lost) / double(all)),
            integral + ", but " + io::percent(1 - double(lost) / double(all), 4) + " of " +
                std::to_string(all) + " samples are directions above the horizon" + cause,
            trio);
  }

  void judge_draws(const Trio& trio, std::size_t k, const Cells& cells, std::optional<Integrals> integrals,
                   const std::vector<DensityRow>& rows) {
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
    if (integrals &&
        (integrals->mass_error > kMassBound || looks_different(*integrals, observed, lost, all))) {
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

  long most_evaluations() const { return full_ ? 1'000'000 : 200'000; }

  // Returns whether a cell, or the rest that is lost, has a number of samples that its integral does not
  // explain by chance alone.
  static bool looks_different(const Integrals& in, const std::vector<long>& observed, long lost,
                              std::size_t all) {
    constexpr double kFromExpected = 4;
    const auto differs = [](double seen, double expected) {
      return std::abs(seen - expected) > 1 + kFromExpected * std::sqrt(std::max(expected, 1.0));
    };
    for (std::size_t k = 0; k < observed.size(); ++k)
      if (differs(double(observed[k]), double(all) * in.density[k])) return true;
    return differs(double(lost), double(all) * std::max(1 - in.mass, 0.0));
  }

  void judge_points(const Trio& trio, const Pointwise& p) {
    compared_[match] += p.density.compared;
    compared_[value] += p.value.compared;
    compared_[range] += p.length.compared;
    if (p.density.share() > kFewDraws) {
      const std::string cause = cause_of(trio, p.returned);
      const bool all_differ = p.density.share() > 0.95;
      worse(match, p.density.share(),
            "the density that " + facts_.sampler_name + " returns and " + facts_.density_name +
                " differ at " + io::percent(p.density.share()) + " of the samples, by up to " +
                io::percent(p.density.worst) +
                (cause.empty()
                     ? ""
                     : (all_differ ? "; " : "; at these samples ") + facts_.density_name + " " + cause),
            trio, &p.density.wi, p.density.u);
    }
    if (p.value.share() > kFewDraws)
      worse(value, p.value.share(), value_text(p), trio, &p.value.wi, p.value.u);
    if (p.value.share() > kFewDraws && cause_.empty() && lacks_cosine(p))
      cause_of_value_ = value_name() + no_cosine_text();
    if (p.not_finite.share() > 0)
      worse(range, 3 + p.not_finite.share(),
            "the direction, the density or the value is not finite at " + io::percent(p.not_finite.share()) +
                " of the samples",
            trio, &p.not_finite.wi, p.not_finite.u);
    if (p.length.share() > kFewDraws)
      worse(range, 2 + p.length.share(),
            "the length of the direction differs from 1 by up to " + io::short_number(p.length.worst), trio,
            &p.length.wi, p.length.u);
    if (p.below.share() > kFewDraws)
      worse(range, 1 + p.below.share(),
            io::percent(p.below.share()) +
                " of the samples lie below the horizon and keep a density above 0 (" +
                degrees_text(trio.at()) + ")",
            trio, &p.below.wi, p.below.u);
  }

  // Returns whether the first value is the quotient f / pdf in the place of the weight.
  bool lacks_cosine(const Pointwise& p) const {
    return quantities_.of[0] == SampleValue::weight &&
           double(p.without_cosine) > 0.99 * double(p.value.compared);
  }

  std::string no_cosine_text() const {
    return " is f/pdf: the factor cos_i is missing, or " + facts_.eval_name +
           " returns f*cos_i, which is not declared";
  }

  std::string value_name() const {
    return facts_.values[0].name.empty() ? "the value that " + facts_.sampler_name + " returns"
                                         : facts_.values[0].name;
  }

  std::string value_text(const Pointwise& p) const {
    const std::string name = value_name();
    std::string text = name + " is not " + std::string(name_of(quantities_.of[0])) + " at " +
                       io::percent(p.value.share()) + " of the samples, with differences up to " +
                       io::percent(p.value.worst);
    if (lacks_cosine(p)) return text + "; " + name + no_cosine_text();
    for (const auto& [kind, count] : p.fits)
      if (kind != quantities_.of[0] && double(count) > 0.99 * double(p.value.compared))
        text += "; it is " + std::string(name_of(kind)) +
                ", so a factor is applied twice or not at all; if this is meant, declare it with " +
                facts_.before_quantity + std::string(name_of(kind)) + facts_.after_quantity;
    return text;
  }

  void judge_distribution(const Trio& trio, const Cells& cells, const Integrals& in,
                          const std::vector<long>& observed, long lost, std::size_t all) {
    // If all of the error of the integrals is in one cell, the statistic may still change by little.
    constexpr double kLittle = 2;
    if (double(all * cells.all().size()) * in.mass_error * in.mass_error > kLittle || !in.all_finite) {
      distribution_why_ = "the integrals of the density are not accurate enough";
      return;
    }
    ++done_[distribution];
    const double n = double(all);
    double tail = 1, statistic = 0;
    double of_rest = 1;     // probability of the samples that are lost or in cells with few expected samples
    std::string rest_text;  // how many they are
    int degrees = 0;
    double visible = 0;
    std::size_t worst_cell = 0;
    double worst_deviation = 0;
    for (const bool coarse : {true, false}) {
      const std::size_t count = coarse ? 16 : cells.all().size();
      std::vector<double> expected(count), seen(count);
      for (std::size_t k = 0; k < cells.all().size(); ++k) {
        const std::size_t to = coarse ? std::size_t(cells.group(k)) : k;
        expected[to] += n * in.density[k];
        seen[to] += double(observed[k]);
      }
      // Cells with few expected samples, and samples that are lost, share one cell.
      double rest_expected = n * std::max(1 - in.mass, 0.0), rest_seen = double(lost), chi2 = 0;
      int used = 0;
      for (std::size_t k = 0; k < count; ++k) {
        if (expected[k] < kLeastExpected) {
          rest_expected += expected[k], rest_seen += seen[k];
          continue;
        }
        const double deviation = (seen[k] - expected[k]) / std::sqrt(expected[k]);
        chi2 += deviation * deviation;
        ++used;
        if (!coarse && std::abs(deviation) > std::abs(worst_deviation))
          worst_deviation = deviation, worst_cell = k;
      }
      if (rest_expected >= kLeastExpected) {
        chi2 += (rest_seen - rest_expected) * (rest_seen - rest_expected) / rest_expected;
        ++used;
      } else if (const double most = rest_expected + n * kMassBound; rest_seen > most) {
        const double probability = poisson_two_sided(rest_seen, most);
        if (probability < of_rest)
          rest_text = io::short_number(rest_seen, 12) + " samples for " +
                      io::short_number(std::round(10 * rest_expected) / 10, 3) + " expected";
        of_rest = std::min(of_rest, probability);
      }
      const double part = used > 1 ? chi_square_tail(chi2, used - 1) : 1;
      if (part < tail || degrees == 0) tail = part, statistic = chi2, degrees = used - 1;
      // A density that is wrong by x in a quarter of the samples shifts the statistic by n x^2 / 4.
      if (coarse && used > 1) visible = std::sqrt(4 * (threshold(used - 1) - (used - 1) + 12) / n);
    }
    power_[distribution] = std::max(power_[distribution], visible);
    const double severity = -std::log10(std::max(std::min(tail, of_rest), 1e-300));
    findings_[distribution].value = std::max(findings_[distribution].value, severity);
    if (of_rest < level_ && of_rest < tail)
      worse(distribution, severity,
            "the samples do not follow the density: " + rest_text + " of " + std::to_string(all) +
                " are lost, or have directions at which the density is nearly 0",
            trio);
    if (!(tail < level_)) return;
    const Cell& c = cells.all()[worst_cell];
    const double s = (c.s0 + c.s1) / 2, phi = (c.phi0 + c.phi1) / 2, rho = std::sqrt(s * (2 - s));
    const Vec3<double> wi{rho * std::cos(phi), rho * std::sin(phi), 1 - s};
    worse(distribution, severity,
          "the samples do not follow the density: chi-square " + io::short_number(statistic) + " with " +
              std::to_string(degrees) + " degrees of freedom, probability " + io::short_number(tail, 2) +
              "; in the worst cell " + std::to_string(observed[worst_cell]) + " samples for " +
              io::short_number(n * in.density[worst_cell]) + " expected" +
              (cause_.empty() ? "" : "; " + cause_),
          trio, &wi);
  }

  // The chi-square value at the level of the test.
  double threshold(int degrees) const {
    double low = 0, high = 1000 + 10 * degrees;
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2;
      (chi_square_tail(middle, degrees) > level_ ? low : high) = middle;
    }
    return low;
  }

  // The deviation of the mean, in standard errors, that a test at the level allows; std::nullopt if a few
  // large weights dominate.
  std::optional<double> limit_of(const Moments& m, double error) const {
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

  void judge_mean(const Trio& trio, const Weights& weights) {
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

  void judge_edges(const Trio& trio) {
    const Edges edges = edges_of(trio);
    combinations_ = std::max(combinations_, edges.combinations);
    if (edges.fault.empty()) return;
    worse(range, edges.only_at_one ? 0.5 : 2.5,
          edges.fault + " at random numbers at the end of their range" +
              (edges.only_at_one ? " (exactly 1, which a generator that rounds to float can return)" : ""),
          trio, nullptr, edges.u);
  }

  void judge_single(const Trio& trio, std::size_t k) {
    if (!facts_.in_float) return;
    const SingleCompared s = single_of(trio, full_ ? 16384 : 4096, seed(k) + 31);
    compared_[single] += s.difference.compared + s.branches;
    branches_ += s.branches;
    const double share = s.difference.share();
    findings_[single].value = std::max(findings_[single].value, share);
    if (share > kFewDraws)
      worse(single, share,
            (s.not_finite > 0 ? "in float the result is not finite, or" : std::string("float and double")) +
                std::string(s.not_finite > 0 ? " differs from double" : " differ") + " by more than 1 % at " +
                io::percent(share) + " of the samples",
            trio, &s.difference.wi, s.difference.u);
  }

  // Sets the outcome of a check that looked at something.
  void conclude_one(Place place, bool looked, const std::string& why_not, const std::string& if_good) {
    Finding& f = findings_[place];
    if (worst_[place].severity >= 0) {
      f.outcome = Outcome::fail;
      f.statement = worst_[place].text;
      f.witness = worst_[place].witness;
      return;
    }
    f.outcome = looked ? Outcome::pass : Outcome::undecided;
    f.statement = looked ? if_good : why_not;
  }

  std::string with_reasons(std::string text) const {
    for (const std::string& why : facts_.missing) text += "; " + why;
    return text;
  }

  void conclude() {
    const std::string cases = std::to_string(cases_.size()) + " cases";
    const std::string no_density = with_reasons(facts_.no_density),
                      no_sampler = with_reasons(facts_.no_sampler);
    const std::string at_level = ", level " + io::short_number(level_, 2) + " each";
    findings_[mass].bound = kMassBound;
    conclude_one(mass, facts_.has_density && mass_unknown_.empty() && done_[mass] > 0,
                 mass_unknown_.empty() ? no_density : mass_unknown_,
                 (facts_.draws ? "the integral of the density is 1 minus the share of lost samples, in "
                               : "the density integrates to 1 in ") +
                     cases + "; quadrature to " + io::short_number(largest_mass_error_, 2));
    findings_[match].bound = kSameValue;
    conclude_one(match, compared_[match] > 0,
                 !facts_.draws         ? no_sampler
                 : !facts_.has_density ? no_density
                 : !facts_.gives_pdf   ? facts_.sampler_name + " returns no density to compare"
                                       : "no sample could be compared",
                 "the density that " + facts_.sampler_name + " returns equals " + facts_.density_name +
                     " at " + std::to_string(compared_[match]) + " samples");
    findings_[value].bound = kSameValue;
    conclude_one(value, compared_[value] > 0,
                 !facts_.draws           ? no_sampler
                 : facts_.values.empty() ? facts_.sampler_name + " returns no value to compare"
                 : !facts_.has_eval      ? facts_.no_eval
                                         : "no value could be compared: its quantity needs a density",
                 values_text());
    const bool jacobian_looked = decided_ >= 16 && decided_ * 3 >= probes_;
    findings_[jacobian].bound = kJacobianBound;
    findings_[jacobian].value = largest_ratio_error_;
    conclude_one(jacobian, jacobian_looked,
                 !facts_.draws ? no_sampler
                 : !has_pdf()  ? no_density
                               : "only " + std::to_string(decided_) + " of " + std::to_string(probes_) +
                                    " directions could be judged" +
                                    (jacobian_why_.empty() ? "" : ": " + jacobian_why_),
                 "the density equals the density of the samples at " + std::to_string(decided_) + " of " +
                     std::to_string(probes_) + " directions, to " +
                     io::short_number(std::max(largest_ratio_error_, 1e-8), 2) + "; an error above " +
                     io::percent(kJacobianBound) + " at a twentieth of these directions would be found");
    findings_[distribution].bound = -std::log10(level_);
    conclude_one(distribution, done_[distribution] == long(cases_.size()),
                 !facts_.draws         ? no_sampler
                 : !facts_.has_density ? no_density
                 : distribution_why_.empty()
                     ? "only " + std::to_string(done_[distribution]) + " of " + cases + " were examined"
                     : distribution_why_,
                 "the samples follow the density in " + cases + " of " + std::to_string(draws()) +
                     " samples" + at_level + "; an error of " + io::percent(power_[distribution], 2) +
                     " in a quarter of the samples would be found");
    findings_[mean].bound = two_sided_quantile(level_);
    conclude_one(mean, done_[mean] > 0 && mean_why_.empty(), facts_.draws ? mean_why_ : no_sampler,
                 "the mean of the weights is the albedo in " + cases + at_level + "; a constant error of " +
                     io::percent(power_[mean], 2) + " would be found" + noise_text());
    findings_[support].bound = kLostAlbedo;
    conclude_one(support, done_[support] > 0, facts_.has_density ? facts_.no_eval : no_density,
                 "the density is above 0 wherever f cos_i is, except for " +
                     io::percent(findings_[support].value, 2) + " of the albedo at most");
    conclude_one(range, compared_[range] > 0,
                 facts_.draws ? std::string("no sample above the horizon was drawn") : no_sampler,
                 "directions have unit length and lie above the horizon, at " +
                     std::to_string(compared_[range]) + " samples and " + std::to_string(combinations_) +
                     " combinations of the random numbers 0, 1/2, 1 - 2^-24 and 1");
    findings_[single].bound = kFewDraws;
    conclude_one(single, compared_[single] > 0,
                 !facts_.draws      ? no_sampler
                 : !facts_.in_float ? facts_.sampler_name + " is available in double precision only"
                                    : "no sample above the horizon was drawn",
                 "float and double agree within 1 % at " + std::to_string(compared_[single]) + " samples; " +
                     std::to_string(branches_) + " next to a boundary took another branch");
    if (!facts_.half_unknown.empty() && findings_[single].outcome == Outcome::pass) {
      findings_[single].outcome = Outcome::undecided;
      findings_[single].statement += "; " + facts_.half_unknown;
    }
    if (worst_[mean].severity >= 0 && std::isfinite(worst_[mean].severity) && noise_ > 0)
      findings_[mean].statement += noise_text();
    if (too_many_)
      for (const Place place : {mass, jacobian, distribution, mean})
        if (findings_[place].outcome != Outcome::fail) {
          findings_[place].outcome = Outcome::undecided;
          findings_[place].statement = facts_.sampler_name + " uses more random numbers than are provided (" +
                                       std::to_string(facts_.randoms) + ")";
        }
  }

  std::string values_text() const {
    std::string text;
    for (std::size_t k = 0; k < quantities_.of.size(); ++k)  // empty without a sampler
      text += (k ? " and " : "") +
              (facts_.values[k].name.empty() ? "the returned value" : facts_.values[k].name) + " is " +
              std::string(name_of(quantities_.of[k]));
    return text + " at " + std::to_string(compared_[value]) + " comparisons" +
           (quantities_.announced.empty() ? "" : "; " + quantities_.announced);
  }

  // Samples per pixel for a noise of 1 %.
  std::string noise_text() const {
    if (!(noise_ > 0)) return "";
    const auto samples = [](double noise) { return io::short_number(std::ceil(noise * noise * 1e4), 3); };
    const std::string beside =
        best_.form.empty()
            ? "; no sampler of the catalogue is comparable, because no parameter has the role of a "
              "width or an exponent"
            : " (" + samples(best_.noise) + " with the sampler of " + best_.form + ")";
    return "; the noise of one sample is up to " + io::percent(noise_, 2) +
           ", so that a noise of 1 % needs " + samples(noise_) + " samples per pixel" + beside +
           "; largest weight " + io::short_number(largest_weight_, 3) + " times the mean";
  }

  const Subject& subject_;
  const DirectionSampler& sampler_;
  const SamplerFacts& facts_;
  CheckOptions options_;
  std::vector<SampledCase> cases_;
  std::vector<Finding> findings_;
  Quantities quantities_;
  int tests_ = 1;
  double level_ = 0;
  std::size_t draws_ = 0;
  bool full_ = false, too_many_ = false;
  std::array<Worst, places> worst_;
  std::array<long, places> done_{}, compared_{};
  std::array<double, places> power_{};
  long probes_ = 0, decided_ = 0, branches_ = 0;
  int combinations_ = 0;
  CatalogueNoise best_;
  double largest_mass_error_ = 0, largest_ratio_error_ = 0, noise_ = 0, largest_weight_ = 0;
  std::string cause_, cause_of_value_;  // of the running case: a constant differs from case to case
  std::string jacobian_why_, mass_unknown_, distribution_why_, mean_why_;
};

}  // namespace

std::vector<Finding> judge_sampler(const Subject& subject, const DirectionSampler& sampler,
                                   const CheckOptions& options, std::size_t draws) {
  try {
    return SamplerJudge(subject, sampler, options, draws).run();
  } catch (const InputError& e) {
    std::vector<Finding> out(std::size(kSamplerChecks));
    for (Finding& f : out) f.outcome = Outcome::undecided, f.statement = e.what();
    return out;
  }
}

}  // namespace brdf::validate
