// Compares albedos known in closed form with the integrals of the forms as implemented.
#include <algorithm>
#include <cmath>

#include "brdf/integrals.h"
#include "brdf/least_of_matt.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "validate/form/checks.h"
#include "validate/search/degrees.h"
#include "validate/search/extremes.h"
#include "validate/search/search.h"

namespace brdf::validate {
namespace {

// A material with only the form's lobe: equal widths, and the shape at a point of the unit cube.
Material lobe_at(const Subject& subject, std::span<const double> x) {
  const ReflectanceInfo& f = info(*subject.of_form());
  const auto [along, across] = f.axes();
  Material m = subject.own();
  Term& term = m.terms.front();
  for (std::size_t j = 0; j < f.shape.size(); ++j)
    term.shape.front()[j] =
        parameter_value(f.shape[j], x[int(j) == across ? std::size_t(along) : j], f.shape[j].max);
  std::ranges::fill(term.weights, lobe_alone(f));
  return m;
}

// Keeps the largest error of an albedo, with its place.
void note(Finding& finding, const Subject& subject, const Material& m, double theta, double error) {
  if (error == finding.value || !is_worst(error, finding.value)) return;
  finding.value = error;
  finding.witness =
      Witness{subject.parameters(m),
              {{"theta", theta}, {"phi", 0}},
              {},
              subject.command("albedo", m, "--theta " + io::to_text(theta) + " --tolerance 1e-10")};
}

// Compares the albedo of a matt basis, a polynomial of the cosine, with the integral at a cover of weights.
Finding albedo_of_basis(const Subject& subject, const CheckOptions& options, Finding finding) {
  constexpr double kTheta = 90;
  const MattBasis& basis = *info(*subject.of_form()).basis;
  const std::size_t cover = options.effort == Effort::full ? 60 : 12;
  std::vector<double> albedos(basis.indices.size());
  finding.value = -1;
  for (std::size_t k = 0; k < cover; ++k) {
    std::vector<double> x = cover_point(k, subject.dimensions() + 1, options.seed);
    const double theta = kTheta * x.back();
    x.pop_back();
    const Material m = subject.at(x);
    const AlbedoResult r = directional_albedo(m.terms.front(), 0, degrees(theta), {}, {.tolerance = 1e-10});
    matt_albedos(basis, std::cos(in_radians(theta)), albedos);
    double expected = 0, size = 0;
    for (std::size_t j = 0; j < albedos.size(); ++j) {
      expected += m.terms.front().weights[0][j] * albedos[j];
      size += std::abs(m.terms.front().weights[0][j] * albedos[j]);
    }
    const double error = std::max(std::abs(r.value - expected) - r.error_bound, 0.0) / size;
    finding.evaluations += r.evaluations;
    note(finding, subject, m, theta, error);
  }
  const std::string source = "the polynomial of the cosine";
  finding.conclude(!(finding.value > finding.bound), "agrees with " + source, "differs from " + source);
  return finding;
}

}  // namespace

Finding check_albedo(const Subject& subject, const CheckOptions& options) {
  const std::span<const ClosedAlbedo> albedos =
      subject.of_form() ? info(*subject.of_form()).albedos : std::span<const ClosedAlbedo>{};
  Finding finding = not_applicable(subject.name(), "albedo", "no closed form to compare with");
  finding.bound = 1e-8;
  if (subject.of_form() && info(*subject.of_form()).basis)
    return albedo_of_basis(subject, options, std::move(finding));
  if (albedos.empty()) return finding;
  finding.value = -1;
  const std::size_t cover = options.effort == Effort::full ? 60 : 12;
  std::vector<std::string> sources;
  for (const ClosedAlbedo& known : albedos) {
    sources.emplace_back(known.source);
    for (std::size_t k = 0; k < cover; ++k) {
      const std::vector<double> x = cover_point(k, subject.shape_dimensions() + 1, options.seed);
      const Material m = lobe_at(subject, x);
      const Term& term = m.terms.front();
      const double theta = known.theta_low + (known.theta_high - known.theta_low) * x.back();
      AlbedoOptions integral;
      integral.tolerance = 1e-10;
      const AlbedoResult r = directional_albedo(term, 0, degrees(theta), {}, integral);
      const double expected = known.albedo(term.shape_of(0), in_radians(theta));
      const double error = std::max(std::abs(r.value - expected) - r.error_bound, 0.0) / expected;
      finding.evaluations += r.evaluations;
      note(finding, subject, m, theta, error);
    }
  }
  const std::string all = io::joined(sources, "; ");
  finding.conclude(!(finding.value > finding.bound), "agrees with " + all, "differs from " + all);
  return finding;
}

}  // namespace brdf::validate
