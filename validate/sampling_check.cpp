// Monte Carlo with the form's own sampler against its
// integral: mean of f cos_i / pdf, and its standard error.
#include <algorithm>
#include <cmath>

#include "brdf/integrals.h"
#include "brdf/random.h"
#include "io/text.h"
#include "validate/checks.h"
#include "validate/search.h"

namespace brdf::validate {
namespace {

constexpr double kBound = 4.5;  // standard errors: once in 150 000 by chance

struct Mean {
  double value, error;
};

Mean estimate(const Term& term, const Vec3<double>& wo, int count, std::uint64_t seed) {
  const std::span<const double> shape = term.shape_of(0);
  Random random(seed);
  double sum = 0, sum2 = 0;
  for (int k = 0; k < count; ++k) {
    const double u1 = random.uniform(), u2 = random.uniform(), u3 = random.uniform();
    const Vec3<double> wi = term.form->sample(shape, u1, u2, u3, wo);
    const double density = term.form->pdf(shape, wi, wo);
    double f = 0;
    if (wi.z > 0 && density > 0) term.form->eval_cos(term.values(0), one_pair(wi, wo), &f);
    const double x = f == 0 ? 0 : f / density;
    sum += x;
    sum2 += x * x;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(sum2 / count - mean * mean, 0.0) / (count - 1))};
}

}  // namespace

Finding check_sampling(const Subject& subject, const CheckOptions& options) {
  Finding finding{subject.name(), "sampling"};
  if (!subject.of_form()) {
    finding.verdict = Verdict::not_applicable;
    finding.statement = "sampling is a property of forms";
    return finding;
  }
  finding.bound = kBound;
  const bool full = options.effort == Effort::full;
  const int cases = full ? 12 : 4, count = full ? 40000 : 8000;
  for (int k = 0; k < cases; ++k) {
    // Wide lobes only: cosine sampling, which a form without a sampler of its own gets, misses narrow ones.
    const std::vector<double> x = cover_point(std::size_t(k), subject.dimensions() + 2, options.seed);
    Material m = subject.at(x);
    const ReflectanceInfo& f = info(*subject.of_form());
    for (std::size_t d = 0; d < f.shape.size(); ++d) {
      if (f.shape[d].name == "exponent") m.terms[0].shape[0][d] = 40 * x[d];
      if (f.shape[d].name.starts_with("alpha")) m.terms[0].shape[0][d] = 0.15 + 0.85 * x[d];
    }
    const Term& term = m.terms[0];
    const double theta = x[x.size() - 2] * 80 * kPi / 180, phi = x.back() * 2 * kPi;
    AlbedoOptions integral;
    integral.fixed = Fixed::viewer;
    integral.tolerance = 1e-6;
    const AlbedoResult truth = directional_albedo(term, 0, radians(theta), radians(phi), integral);
    const Mean mean =
        estimate(term, direction(radians(theta), radians(phi)), count, options.seed + std::uint64_t(k));
    const double z = std::abs(mean.value - truth.value) / (mean.error + 1e-12 + truth.error_bound);
    finding.evaluations += truth.evaluations + count;
    if (z < finding.value) continue;
    finding.value = z;
    Witness w;
    w.parameters = subject.parameters(m);
    w.angles = {{"theta_o", theta * 180 / kPi}, {"phi_o", phi * 180 / kPi}};
    w.command = "brdf albedo " + subject.selector(m) + " --fixed o --theta " +
                io::to_text(theta * 180 / kPi) + " --phi " + io::to_text(phi * 180 / kPi);
    finding.witness = w;
  }
  finding.verdict = finding.value <= kBound ? Verdict::pass : Verdict::fail;
  finding.statement = std::string(finding.verdict == Verdict::pass ? "the sampler's mean is the albedo"
                                                                   : "the sampler's mean is not the albedo") +
                      ": worst of " + std::to_string(cases) + " cases " +
                      io::to_text(std::round(100 * finding.value) / 100) + " standard errors away";
  return finding;
}

}  // namespace brdf::validate
