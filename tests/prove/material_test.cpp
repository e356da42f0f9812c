// Albedos of materials: the certified interval contains the value of the library's integrals, and faulty
// albedos lie outside.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "brdf/integrals.h"
#include "brdf/quadrature.h"
#include "brdf/targets.h"
#include "prove/check/sum_of_albedos.h"
#include "prove/energy/energy.h"
#include "prove/proof.h"
#include "prove/scalar/lemmas.h"

namespace brdf::prove {
namespace {

// Returns the turn of a view (of the stretched normal, for facets) from its tangent.
double turn_of(double tangent, double stretch) {
  const double t = tangent * stretch;
  return t / (1 + t);
}

std::optional<Bounds> albedo_at(const Term& term, const Views& views, double accuracy = 4e-3) {
  const EnergyMethod* method = albedo_method(catalogue_index(term.form));
  if (method == nullptr) return std::nullopt;
  std::vector<Bounds> shape, weights;
  for (const double x : term.shape[0]) shape.push_back({x, x});
  for (const double x : term.weights[0]) weights.push_back({x, x});
  if (const auto found = method->albedo(shape, weights, views, accuracy)) return found->value;
  return std::nullopt;
}
std::optional<Bounds> albedo_at(const Term& term, double turn, double half = 0) {
  return albedo_at(term, Views{{std::max(0.0, turn - half), std::min(1.0, turn + half)}});
}

bool has_facets(const Reflectance& form) {
  const auto& shape = form.info().shape;
  return std::any_of(shape.begin(), shape.end(),
                     [](const ParameterInfo& p) { return p.role == Role::width; });
}
// Returns true for lobes with an albedo that is bounded by inequalities only, except along the normal.
bool is_cosine_lobe(const Reflectance& form) {
  return form.info().weights.size() > 1 && !has_facets(form);
}
// Returns a term with widths `alpha`, other parameters at their defaults, and weights that sum to 1.
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

// A fault that a prover could have is planted: pi instead of 4 in the scale. The faulty albedos lie outside
// the interval.
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

// Returns a term with the widths `along` and `across`.
Term rough(const Reflectance& form, double along, double across) {
  Term term = rough(form, across);
  for (std::size_t k = 0; k < term.shape[0].size(); ++k)
    if (form.info().shape[k].role == Role::width) term.shape[0][k] = along;
  return term;
}

TEST(Material, OfUnequalWidthsTheyHoldThemFromEveryAzimuth) {
  int held = 0;
  for (const Reflectance& form : catalogue())
    for (const auto& [along, across] : {std::pair{0.15, 0.4}, {0.9, 0.3}}) {
      const Term term = rough(form, along, across);
      if (!has_facets(form) || !albedo_at(term, 0)) continue;
      for (const double theta : {0.0, 40.0, 75.0, 88.0})
        for (const double phi : {0.0, 35.0, 90.0}) {
          const double tangent = std::tan(theta * kPi / 180), p = phi * kPi / 180,
                       turn = turn_of(tangent, std::hypot(along * std::cos(p), across * std::sin(p))),
                       azimuth = phi == 90 ? 1 : turn_of(std::tan(p), across / along);
          const AlbedoResult numeric = directional_albedo(term, 0, degrees(theta), degrees(phi));
          const double half = theta == 75 ? 0.004 : 0;
          const auto around = [half](double x) {
            return Bounds{std::max(0.0, x - half), std::min(1.0, x + half)};
          };
          const Bounds b = *albedo_at(term, {around(turn), around(azimuth)}, 0.01);
          EXPECT_LE(b.lo, numeric.value + numeric.error_bound)
              << form.info().name << ' ' << theta << ' ' << phi;
          EXPECT_GE(b.hi, numeric.value - numeric.error_bound)
              << form.info().name << ' ' << theta << ' ' << phi;
          EXPECT_LT(b.hi - b.lo, 0.35) << form.info().name << ' ' << along << ' ' << theta << ' ' << phi;
          ++held;
        }
    }
  EXPECT_GE(held, 7 * 2 * 12);  // six with bounds over all parameters, and Student's
}

TEST(Material, StudentsHoldThemForEveryTail) {
  EXPECT_GE(student_polynomial().lo, 0);  // the visible share of the facets is at least the cosine
  for (const double gamma : {1.6, 1.75, 3.0, 10.0}) {
    Term term = rough(*find_form("cook_torrance_student"), 0.3);
    term.shape[0].back() = gamma;
    for (const double theta : {0.0, 50.0, 85.0}) {
      const double turn = turn_of(std::tan(theta * kPi / 180), 0.3 * std::sqrt(gamma - 1));
      const AlbedoResult numeric = directional_albedo(term, 0, degrees(theta), degrees(0));
      const Bounds b = *albedo_at(term, turn);
      EXPECT_LE(b.lo, numeric.value + numeric.error_bound) << gamma << ' ' << theta;
      EXPECT_GE(b.hi, numeric.value - numeric.error_bound) << gamma << ' ' << theta;
      EXPECT_LT(b.hi - b.lo, 0.13) << gamma << ' ' << theta;
    }
  }
}

// Returns the largest albedo over a grid of views, by the integrals.
double largest_of(const Material& m, const std::vector<double>& azimuths = {0}) {
  double most = 0;
  for (const double phi : azimuths)
    for (double theta = 0; theta < 89.9999; theta += 0.05 * (90 - theta)) {
      double sum = 0;
      for (const Term& t : m.terms) sum += directional_albedo(t, 0, degrees(theta), degrees(phi)).value;
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
       {Material{{"fr"}, {term("cook_torrance", 1, 0.2), term("cook_torrance_beckmann", 1, 0.1)}},
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
}

// Two terms brushed across one another. Each term depends on the azimuth of the view through its own
// widths.
TEST(Material, OfUnequalWidthsTermsAreSeenFromOneAzimuth) {
  const Term first = rough(*find_form("cook_torrance"), 0.5, 0.2),
             second = rough(*find_form("cook_torrance_beckmann"), 0.3, 0.8);
  const SumOfAlbedos albedo({{first, 0}, {second, 0}});
  ASSERT_TRUE(albedo.known() && albedo.turns());
  for (const double theta : {30.0, 80.0})
    for (const double phi : {20.0, 60.0}) {
      const double p = phi * kPi / 180, tangent = std::tan(theta * kPi / 180),
                   turn = turn_of(tangent, std::hypot(0.5 * std::cos(p), 0.2 * std::sin(p))),
                   azimuth = turn_of(std::tan(p), 0.2 / 0.5);
      const Bounds b = albedo({{turn, turn}, {azimuth, azimuth}}, 2e-3).value;
      double sum = 0;
      for (const Term& t : {first, second})
        sum += directional_albedo(t, 0, degrees(theta), degrees(phi), {.tolerance = 1e-6}).value;
      EXPECT_LE(b.lo, sum) << theta << ' ' << phi;
      EXPECT_GE(b.hi, sum) << theta << ' ' << phi;
      EXPECT_LT(b.hi - b.lo, 0.1) << theta << ' ' << phi;
    }
}

TEST(Material, OfUnequalWidthsAreProvedAlsoWhereTheSearchStops) {
  Options options;
  options.properties = {Property::energy};
  options.search.leaves = 4;
  Term term = rough(*find_form("cook_torrance"), 0.5, 0.2);
  term.weights[0] = {0.1, 0.9, 0.6};
  const Material m{{"fr"}, {term}};
  const Proof p = prove(m, "m", options).front();
  const double largest = largest_of(m, {0, 45, 90});
  EXPECT_EQ(p.verdict, Verdict::proved) << p.statement;
  EXPECT_GT(p.cover.open, 0);
  EXPECT_LE(p.low, largest + 1e-3);
  EXPECT_GE(p.low, largest - 0.02);
  EXPECT_GE(p.high, largest);
}

// Phong's and Blinn's lobes reflect most along the normal, where the albedo equals their weights.
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

// The page for browsers proves the properties of values alone.
TEST(Material, PropertiesOfValuesAreTheSameAlone) {
  Options options;
  options.properties.assign(kPropertiesOfValues.begin(), kPropertiesOfValues.end());
  for (const char* name : {"ward", "cook_torrance", "phong_as_coded", "matt_8", "mitsuba_principled"}) {
    const Material m{{"r", "g"}, {make_term(*find_form(name), 2)}};
    const std::vector<Proof> all = prove(m, "m", options), alone = prove_values(m, "m", options.search);
    ASSERT_EQ(alone.size(), all.size()) << name;
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_EQ(alone[k].statement, all[k].statement) << name;
      EXPECT_EQ(alone[k].verdict, all[k].verdict) << name;
      EXPECT_EQ(alone[k].high, all[k].high) << name;
    }
  }
}

TEST(Material, NothingIsSaidOfOtherProgramsModels) {
  for (const Reflectance& form : targets())
    for (const Proof& p : prove(Material{{"fr"}, {make_term(form, 1)}}, "m", {})) {
      const bool measured = p.claim.property == Property::energy && p.verdict == Verdict::refuted;
      EXPECT_TRUE(measured || p.verdict == Verdict::no_method) << p.form << ' ' << name_of(p.claim.property);
    }
}

// Ward's original lobe reflects more than it receives at some angle, for any positive weight.
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
