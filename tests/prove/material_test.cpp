// Albedos of materials: the certified interval holds what the integrals of the library find, and faults do not.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "brdf/integrals.h"
#include "brdf/quadrature.h"
#include "brdf/targets.h"
#include "prove/proof.h"
#include "prove/scalar/energy.h"

namespace brdf::prove {
namespace {

// A view's turn (of the stretched normal, for facets) from its tangent.
double turn_of(double tangent, double stretch) {
  const double t = tangent * stretch;
  return t / (1 + t);
}

std::optional<Bounds> albedo_at(const Term& term, double turn, double half = 0, double accuracy = 4e-3) {
  const EnergyMethod* method = energy_method(catalogue_index(term.form));
  if (method == nullptr || method->albedo == nullptr) return std::nullopt;
  std::vector<Bounds> shape, weights;
  for (const double x : term.shape[0]) shape.push_back({x, x});
  for (const double x : term.weights[0]) weights.push_back({x, x});
  return method->albedo(shape, weights, {std::max(0.0, turn - half), std::min(1.0, turn + half)}, accuracy);
}

bool has_facets(const Reflectance& form) {
  const auto& shape = form.info().shape;
  return std::any_of(shape.begin(), shape.end(),
                     [](const ParameterInfo& p) { return p.role == Role::width; });
}
// Known by inequalities alone, but along the normal.
bool is_cosine_lobe(const Reflectance& form) {
  return form.info().weights.size() > 1 && !has_facets(form);
}
// Widths of `alpha`, what else is at its default; weights that sum to 1.
Term rough(const Reflectance& form, double alpha) {
  Term term = make_term(form, 1);
  for (std::size_t k = 0; k < term.shape[0].size(); ++k)
    if (const Role role = form.info().shape[k].role; role == Role::width || role == Role::width_across)
      term.shape[0][k] = alpha;
  return term;
}

TEST(Material, CertifiedAlbedosHoldWhatTheIntegralsFind) {
  int held = 0;
  for (const Reflectance& form : catalogue()) {
    for (const double alpha : {0.08, 0.3, 0.9}) {
      const Term term = rough(form, alpha);
      if (!albedo_at(term, 0)) continue;
      for (const double theta : {0.0, 25.0, 60.0, 80.0, 88.0}) {
        const double tangent = std::tan(theta * kPi / 180),
                     turn = turn_of(tangent, has_facets(form) ? alpha : 1);
        const AlbedoResult numeric = directional_albedo(term, 0, degrees(theta), degrees(0));
        for (const double half : {0.0, 0.004}) {
          const Bounds b = *albedo_at(term, turn, half);
          EXPECT_LE(b.lo, numeric.value + numeric.error_bound)
              << form.info().name << ' ' << alpha << ' ' << theta;
          EXPECT_GE(b.hi, numeric.value - numeric.error_bound)
              << form.info().name << ' ' << alpha << ' ' << theta;
          EXPECT_LT(b.hi - b.lo, is_cosine_lobe(form) ? 0.51 : 0.13)
              << form.info().name << ' ' << alpha << ' ' << theta;
          ++held;
        }
      }
    }
  }
  EXPECT_GE(held, 8 * 3 * 10);  // two diffuse forms, six of facets
}

// Faults that a prover could have: pi for 4 in the scale, the masking left out. Their albedos are outside the interval.
TEST(Material, FaultyAlbedosAreOutsideTheInterval) {
  int tried = 0;
  for (const Reflectance& form : catalogue()) {
    const Term term = rough(form, 0.3);
    if (!has_facets(form) || !albedo_at(term, 0)) continue;
    Term scaled = term;
    for (double& w : scaled.weights[0]) w *= kPi / 4;
    const AlbedoResult wrong = directional_albedo(scaled, 0, degrees(60), degrees(0));
    const Bounds b = *albedo_at(term, turn_of(std::tan(kPi / 3), 0.3));
    EXPECT_TRUE(wrong.value < b.lo || b.hi < wrong.value) << form.info().name;
    ++tried;
  }
  EXPECT_GE(tried, 3);
}

TEST(Material, NothingIsSaidOfUnequalWidths) {
  Options options;
  options.properties = {Property::energy};
  for (const Reflectance& form : catalogue()) {
    Term term = rough(form, 0.3);
    if (!has_facets(form) || !albedo_at(term, 0)) continue;
    for (std::size_t k = 0; k < term.shape[0].size(); ++k)
      if (form.info().shape[k].role == Role::width) term.shape[0][k] = 0.2;
    EXPECT_EQ(prove(Material{{"fr"}, {term}}, "m", options).front().verdict, Verdict::no_method);
  }
}

// The largest of a grid of views, by the integrals.
double largest_of(const Material& m) {
  double most = 0;
  for (double theta = 0; theta < 89.9999; theta += 0.05 * (90 - theta)) {
    double sum = 0;
    for (const Term& t : m.terms) sum += directional_albedo(t, 0, degrees(theta), degrees(0)).value;
    most = std::max(most, sum);
  }
  return most;
}

TEST(Material, SumsOfTermsAreKnownTogether) {
  Options options;
  options.properties = {Property::finite, Property::non_negative, Property::energy, Property::reciprocity};
  const auto term = [](const char* name, double alpha, double share) {
    Term t = rough(*find_form(name), alpha);
    for (double& w : t.weights[0]) w *= share;
    return t;
  };
  for (const Material& m :
       {Material{{"fr"}, {term("cook_torrance", 1, 0.6), term("cook_torrance_beckmann", 1, 0.3)}},
        Material{{"fr"}, {term("lambert", 1, 0.4), term("ward_bounded", 0.6, 0.5)}}}) {
    const double largest = largest_of(m);
    for (const Proof& p : prove(m, "m", options)) {
      EXPECT_EQ(p.verdict, Verdict::proved)
          << name_of(p.claim.property) << ' ' << p.form << ' ' << p.statement;
      if (p.claim.property == Property::reciprocity) {
        EXPECT_EQ(p.arithmetic, m.terms.front().form.info().name == "lambert"
                                    ? "every IEEE precision, bit for bit"
                                    : "exact");
      }
      if (p.claim.property != Property::energy) continue;
      EXPECT_LE(p.high - p.low, 2e-3 + 1e-12);
      EXPECT_LE(p.low, largest + 1e-3);
      EXPECT_GE(p.high, largest);
    }
  }
  const Proof unknown = prove(
      Material{{"fr"}, {term("lambert", 1, 0.1), term("cook_torrance_student", 1, 0.1)}}, "m", options)[4];
  EXPECT_EQ(unknown.claim.property, Property::energy);
  EXPECT_EQ(unknown.verdict, Verdict::no_method) << unknown.statement;
}

// Phong's and Blinn's reflect most along the normal, which is their weights.
TEST(Material, CosineLobesReflectTheirWeights) {
  Options options;
  options.properties = {Property::energy};
  for (const char* name : {"phong", "blinn_phong"})
    for (const double ks : {0.6, 0.9}) {
      Term term = make_term(*find_form(name), 1);
      term.weights[0] = {0.3, ks};
      const Proof p = prove(Material{{"fr"}, {term}}, "m", options).front();
      EXPECT_EQ(p.verdict, ks < 0.7 ? Verdict::proved : Verdict::refuted) << name;
      EXPECT_NEAR(p.low, 0.3 + ks, 1e-14);
      EXPECT_NEAR(p.high, 0.3 + ks, 1e-14);
    }
}

TEST(Material, NothingIsSaidOfOtherProgramsModels) {
  for (const Reflectance& form : targets())
    for (const Proof& p : prove(Material{{"fr"}, {make_term(form, 1)}}, "m", {})) {
      const bool measured = p.claim.property == Property::energy && p.verdict == Verdict::refuted;
      EXPECT_TRUE(measured || p.verdict == Verdict::no_method) << p.form << ' ' << name_of(p.claim.property);
    }
}

// Ward's own lobe reflects more than it receives at some angle, however small its weight.
TEST(Material, WardsLobesAreRefutedTowardsGrazing) {
  Options options;
  options.properties = {Property::energy};
  Term ward = rough(*find_form("ward"), 0.2);
  const Proof p = prove(Material{{"fr"}, {ward}}, "m", options).front();
  ASSERT_EQ(p.verdict, Verdict::refuted) << p.statement;
  EXPECT_GT(p.witness->value, 1);
}

TEST(Material, LargestAlbedoOfDiffuseFormsIsKnownToAThousandth) {
  Options options;
  options.properties = {Property::energy, Property::finite, Property::non_negative};
  int gained = 0;
  for (const Reflectance& form : catalogue()) {
    Term term = make_term(form, 1);
    if (form.info().weights.size() > 1 || !albedo_at(term, 0)) continue;
    for (double& w : term.weights[0]) w = 1;
    for (const Proof& p : prove(Material{{"fr"}, {term}}, "m", options)) {
      if (p.claim.property == Property::energy) {
        EXPECT_LE(p.high - p.low, 2e-3 + 1e-12);
        if (!form.info().violates(name_of(Property::energy))) {
          EXPECT_EQ(p.verdict, Verdict::proved) << form.info().name;
        } else {
          EXPECT_EQ(p.verdict, Verdict::refuted) << form.info().name;
          ++gained;
        }
      } else {
        EXPECT_EQ(p.verdict, Verdict::proved) << form.info().name;
      }
    }
  }
  EXPECT_EQ(gained, 1);
}

}  // namespace
}  // namespace brdf::prove
