// Albedos known in closed form, against the integrals of the forms as they are implemented.
#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "brdf/integrals.h"
#include "io/text.h"
#include "validate/checks.h"
#include "validate/search.h"

namespace brdf::validate {
namespace {

constexpr double kBound = 1e-8;

}  // namespace

Finding check_albedo(const Subject& subject, const CheckOptions& options) {
  Finding finding{subject.name(), "albedo"};
  finding.bound = kBound;
  const std::size_t cover = options.effort == Effort::full ? 60 : 12;
  std::string sources;
  double worst = -1;
  const std::span<const ClosedAlbedo> albedos =
      subject.of_form() ? info(*subject.of_form()).albedos : std::span<const ClosedAlbedo>{};
  for (const ClosedAlbedo& known : albedos) {
    sources += (sources.empty() ? "" : "; ") + std::string(known.source);
    const ReflectanceInfo& f = info(*subject.of_form());
    for (std::size_t k = 0; k < cover; ++k) {
      const std::vector<double> x = cover_point(k, f.shape.size() + 1, options.seed);
      Material m = subject.own();
      Term& term = m.terms[0];
      for (std::size_t j = 0; j < f.shape.size(); ++j)
        term.shape[0][j] = parameter_value(
            f.shape[j], x[int(j) == f.axes().across ? std::size_t(f.axes().along) : j], f.shape[j].max);
      for (std::size_t j = 0; j < f.weights.size(); ++j)
        term.weights[0][j] =
            f.weights[j].role == Role::diffuse && f.weight_index(Role::specular) >= 0 ? 0 : 1;
      const double theta = known.theta_low + (known.theta_high - known.theta_low) * x.back();
      AlbedoOptions integral;
      integral.tolerance = 1e-10;
      const AlbedoResult r = directional_albedo(term, 0, degrees(theta), {}, integral);
      const double expected = known.albedo(term.shape[0], theta * kPi / 180);
      const double error = std::max(std::abs(r.value - expected) - r.error_bound, 0.0) / expected;
      finding.evaluations += r.evaluations;
      if (error <= worst) continue;
      worst = error;
      Witness w;
      w.parameters = subject.parameters(m);
      w.angles = {{"theta", theta}, {"phi", 0}};
      w.command =
          "brdf albedo " + subject.selector(m) + " --theta " + io::to_text(theta) + " --tolerance 1e-10";
      finding.witness = w;
    }
  }
  if (sources.empty()) {
    finding.verdict = Verdict::not_applicable;
    finding.statement = "no closed form to compare with";
    return finding;
  }
  finding.value = worst;
  finding.verdict = worst > kBound ? Verdict::fail : Verdict::pass;
  finding.statement = (finding.verdict == Verdict::pass ? "agrees with " : "differs from ") + sources;
  return finding;
}

}  // namespace brdf::validate
