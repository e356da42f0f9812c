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

// Albedo of the lobe at full weight for light at theta, of the shape's parameters; equal widths.
struct ClosedForm {
  const char* form;
  double theta_low, theta_high;  // degrees: where it holds
  double (*albedo)(std::span<const double> shape, double theta);
  const char* source;
};

double one(std::span<const double>, double) {
  return 1;
}

// With t the polar angle; tan t (1 - sin^3 t) rewritten for t to 90 degrees.
double oren_nayar_albedo(std::span<const double> shape, double t) {
  const double s2 = square(shape[0]), a = 1 - 0.5 * s2 / (s2 + 0.33), b = 0.45 * s2 / (s2 + 0.09);
  const double s = std::sin(t), c = std::cos(t);
  return a + b / kPi * (s * (t - s * c) + 2.0 / 3 * s * c * (1 + s + s * s) / (1 + s));
}

double phong_grazing(std::span<const double> shape, double) {
  const double n = shape[0];
  return (n + 2) * std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2 + 2)) / (4 * std::sqrt(kPi));
}

double ward_bounded_normal(std::span<const double> shape, double) {
  const double a2 = square(shape[0]);
  return 1 + a2 * std::expm1(-1 / a2);
}

constexpr ClosedForm kClosedForms[] = {
    {"lambert", 0, 90, one, "its definition"},
    {"oren_nayar", 0, 90, oren_nayar_albedo, "the integral of eq. 30"},
    {"oren_nayar_energy", 0, 90, one, "white surfaces lose nothing"},
    {"phong", 0, 0, one, "its normalisation"},
    {"phong", 90, 90, phong_grazing, "a ratio of gamma functions at grazing"},
    {"blinn_phong", 0, 0, one, "its normalisation"},
    {"ward_bounded", 0, 0, ward_bounded_normal, "1 - alpha^2 (1 - exp(-1/alpha^2)) at the normal"},
};

}  // namespace

Finding check_albedo(const Subject& subject, const CheckOptions& options) {
  Finding finding{subject.name(), "albedo"};
  finding.bound = kBound;
  const std::size_t cover = options.effort == Effort::full ? 60 : 12;
  std::string sources;
  double worst = -1;
  for (const ClosedForm& known : kClosedForms) {
    if (!subject.of_form() || subject.name() != known.form) continue;
    sources += (sources.empty() ? "" : "; ") + std::string(known.source);
    const FormInfo& f = info(*subject.of_form());
    for (std::size_t k = 0; k < cover; ++k) {
      const std::vector<double> x = cover_point(k, f.shape.size() + 1, options.seed);
      Material m = subject.own();
      Term& term = m.terms[0];
      for (std::size_t j = 0; j < f.shape.size(); ++j)
        term.shape[0][j] =
            parameter_value(f.shape[j], x[f.shape[j].name == "alpha_y" ? 0 : j], f.shape[j].max);
      for (std::size_t j = 0; j < f.weights.size(); ++j)
        term.weights[0][j] = f.weights[j].name == "kd" ? 0 : 1;
      const double theta = known.theta_low + (known.theta_high - known.theta_low) * x.back();
      AlbedoOptions integral;
      integral.tolerance = 1e-10;
      const AlbedoResult r = directional_albedo(term, 0, theta * kPi / 180, 0, integral);
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
