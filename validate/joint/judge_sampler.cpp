#include "validate/joint/sampler_judge.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "validate/joint/statistics.h"

namespace brdf::validate {
namespace {

constexpr double kTolerance = 1e-6;  // of the integral of a density

}  // namespace

std::string degrees_text(const SampledCase& c) {
  return "theta_o " + io::short_number(c.theta, 3);
}

SamplerJudge::SamplerJudge(const Subject& subject, const DirectionSampler& sampler,
                           const CheckOptions& options, std::size_t draws_of_a_case)
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

std::vector<Finding> SamplerJudge::run() {
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

void SamplerJudge::worse(Place place, double severity, const std::string& text, const Trio& trio,
                         const Vec3<double>* wi, std::span<const double> u) {
  Worst& worst = worst_[place];
  if (!(severity > worst.severity)) return;
  const std::size_t used = std::min(u.size(), trio.randoms_used());
  worst = {severity, text, witness_of(subject_, trio, kSamplerChecks[place], options_, wi, u.first(used))};
}

void SamplerJudge::one_case(std::size_t k) {
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
    judge_support(trio, *integrals, k);
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

void SamplerJudge::judge_support(const Trio& trio, const Integrals& integrals, std::size_t k) {
  if (!facts_.has_eval) return;
  ++done_[support];
  judge_holes(trio, holes_of(trio, seed(k) + 63));
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

void SamplerJudge::judge_holes(const Trio& trio, const Holes& holes) {
  constexpr long kEnoughDark = 10;  // fewer do not show the share of the albedo
  findings_[support].evaluations += kHoleDirections;
  findings_[support].value = std::max(findings_[support].value, holes.share);
  supported_ += holes.directions;
  dark_ += holes.dark;
  if (!(holes.share > kLostAlbedo)) return;
  const std::string text =
      "the density is 0 at " + std::to_string(holes.dark) + " of " + std::to_string(holes.directions) +
      " directions with f cos_i above 0, which reflect about " + io::percent(holes.share, 2) +
      " of the albedo; f cos_i is up to " + io::short_number(holes.brightest_value) + " /sr";
  if (holes.dark < kEnoughDark)
    support_unknown_ = text + ": they are too few to show their part of the albedo";
  else
    worse(support, holes.share, text + " at the direction named", trio, &holes.brightest);
}

std::vector<DensityRow> SamplerJudge::judge_jacobian(const Trio& trio, std::size_t k) {
  const JacobianRows found = jacobian_rows(trio, full_ ? 256 : 48, seed(k) + 5);
  probes_ += found.probes;
  decided_ += long(found.rows.size());
  if (!found.why.empty()) jacobian_why_ = found.why;
  long wrong = 0;
  double worst = 0;
  const DensityRow* at = nullptr;
  for (const DensityRow& row : found.rows) {
    const double difference = std::abs(row.claimed / row.truth - 1);
    const bool is_wrong = !(difference <= kJacobianBound);
    wrong += is_wrong;
    if (!is_wrong) largest_ratio_error_ = std::max(largest_ratio_error_, difference);
    if (!(difference <= worst)) worst = difference, at = &row;
  }
  exceptions_[jacobian] += wrong;
  largest_exception_[jacobian] = std::max(largest_exception_[jacobian], worst);
  findings_[jacobian].value = std::max(findings_[jacobian].value, worst);
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

void SamplerJudge::judge_edges(const Trio& trio) {
  const Edges edges = edges_of(trio);
  combinations_ = std::max(combinations_, edges.combinations);
  if (edges.fault.empty()) return;
  worse(range, edges.only_at_one ? 0.5 : 2.5,
        edges.fault + " at random numbers at the end of their range" +
            (edges.only_at_one ? " (exactly 1, which a generator that rounds to float can return)" : ""),
        trio, nullptr, edges.u);
}

void SamplerJudge::judge_single(const Trio& trio, std::size_t k) {
  if (!facts_.in_float) return;
  const SingleCompared s = single_of(trio, full_ ? 16384 : 4096, seed(k) + 31);
  compared_[single] += s.difference.compared + s.branches;
  branches_ += s.branches;
  const double share = s.difference.share();
  findings_[single].value = std::max(findings_[single].value, share);
  exceptions_[single] += s.difference.differing;
  largest_exception_[single] = std::max(largest_exception_[single], s.difference.worst);
  if (share > kFewDraws || s.not_finite > 0)
    worse(single, share,
          (s.not_finite > 0 ? "in float the result is not finite, or" : std::string("float and double")) +
              std::string(s.not_finite > 0 ? " differs from double" : " differ") + " by more than 1 % at " +
              io::percent(share) + " of the samples",
          trio, &s.difference.wi, s.difference.u);
}

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
