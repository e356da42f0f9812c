// The checks of the density: its integral, and how the samples are distributed.
#include "validate/joint/sampler_judge.h"

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "validate/joint/statistics.h"

namespace brdf::validate {
namespace {

constexpr double kLeastExpected = 25;
constexpr double kSurely = 300;  // minus the decimal logarithm of the least probability that is distinguished

}  // namespace

void SamplerJudge::judge_mass(const Trio& trio, const Integrals& in, long all, long lost,
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
  const double lost_share = std::clamp(1 - in.mass, 0.0, 1.0), z = two_sided_quantile(level_);
  power_[mass] = std::max(power_[mass], kMassBound + in.mass_error +
                                            z * std::sqrt(lost_share * (1 - lost_share) / double(all)) +
                                            z * z / double(all));
  // The lost samples follow a binomial distribution; the error of the integral widens it.
  const double expected = double(all) * std::clamp(1 - in.mass, 0.0, 1.0),
               slack = double(all) * in.mass_error;
  double probability = 1;
  if (double(lost) < expected - slack || double(lost) > expected + slack) {
    const double nearest = double(lost) < expected ? expected - slack : expected + slack;
    const double errors =
        (double(lost) - nearest) / std::sqrt(nearest * (1 - nearest / double(all)) + 1e-300);
    probability = nearest < 400 ? poisson_two_sided(double(lost), nearest) : two_sided_tail(errors);
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

void SamplerJudge::judge_impossible(const Trio& trio, const ComparedDraws& draws) {
  if (draws.differing == 0) return;
  const std::string text = "the density is 0 at the directions of " + std::to_string(draws.differing) +
                           " of " + std::to_string(draws.compared) + " samples";
  findings_[distribution].value = std::max(findings_[distribution].value, kSurely);
  worse(distribution, kSurely, "the samples do not follow the density: " + text, trio, &draws.wi, draws.u);
  if (draws.share() > kMassBound) worse(mass, draws.share(), text, trio, &draws.wi, draws.u);
}

double SamplerJudge::threshold(int degrees) const {
  double low = 0, high = 1000 + 10 * degrees;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (chi_square_tail(middle, degrees) > level_ ? low : high) = middle;
  }
  return low;
}

void SamplerJudge::judge_distribution(const Trio& trio, const Cells& cells, const Integrals& in,
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

}  // namespace brdf::validate
