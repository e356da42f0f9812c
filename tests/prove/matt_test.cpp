// Proofs about materials with weights of either sign.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "brdf/least_of_matt.h"
#include "prove/check/judge.h"
#include "prove/proof.h"
#include "prove/report.h"

namespace brdf::prove {
namespace {

Material basis(const char* form, std::vector<double> weights) {
  Material m = make_material(*find_form(form), {"f"});
  m.terms[0].weights = {std::move(weights)};
  return m;
}

Proof proof_of(const Material& m, Property property) {
  Options options;
  options.properties = {property};
  return prove(m, "tile.json", options).back();
}

const std::vector<double> kTile{0.93, 0.08, 0.15, -0.2, 0.16};

TEST(MattProof, AWhiteTileIsNotNegativeReciprocalAndConservesEnergy) {
  const Material m = basis("matt_5", kTile);
  for (const Property property : {Property::non_negative, Property::reciprocity, Property::energy}) {
    const Proof p = proof_of(m, property);
    EXPECT_EQ(p.verdict, Verdict::proved) << name_of(property) << ": " << p.statement;
  }
  // The bound of the least value holds at random pairs of directions.
  const double low = proof_of(m, Property::non_negative).low;
  EXPECT_GT(low, 0.1);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto any = [&] {
    return direction(radians(std::acos(unit(random))), radians(2 * kPi * unit(random)));
  };
  for (int k = 0; k < 20000; ++k) {
    double f = 0;
    eval(m, any(), any(), {&f, 1});
    ASSERT_GE(f, low);
  }
}

TEST(MattProof, WeightsThatGiveANegativeValueAreRefutedAtAPlaceThatShowsIt) {
  const Material m = basis("matt_5", {0.3, -0.45, 0.28, -0.15, 0.25});
  const Proof p = proof_of(m, Property::non_negative);
  ASSERT_EQ(p.verdict, Verdict::refuted);
  ASSERT_TRUE(p.witness);
  EXPECT_LT(p.witness->value, -0.01);
  double f = 0;
  const auto angle = [&](std::size_t k) { return degrees(p.witness->angles[k].second); };
  eval(m, direction(angle(0), angle(1)), direction(angle(2), angle(3)), {&f, 1});
  EXPECT_NEAR(f, p.witness->value, 1e-9);
}

TEST(MattProof, AnAlbedoAbove1IsRefuted) {
  EXPECT_EQ(proof_of(basis("matt_5", {1.02, 0.05, 0.1, -0.2, 0.1}), Property::energy).verdict,
            Verdict::refuted);
}

// Returns the albedo at the vertex of the parabola through the albedos at the cosines 0, 1/2 and 1.
double albedo_at_vertex(const Material& m) {
  const MattBasis& its = *m.terms[0].form.info().basis;
  const auto albedo = [&](double cosine) {
    std::vector<double> each(its.indices.size());
    matt_albedos(its, cosine, each);
    return std::inner_product(each.begin(), each.end(), m.terms[0].weights[0].begin(), 0.0);
  };
  const double bend = 2 * (albedo(0) - 2 * albedo(0.5) + albedo(1)), slope = albedo(1) - albedo(0) - bend;
  EXPECT_LT(bend, 0);
  EXPECT_TRUE(-slope / (2 * bend) > 0.1 && -slope / (2 * bend) < 0.9);
  return albedo(-slope / (2 * bend));
}

// The bounds of a single box exceed 1 here: they are wider than the distance of the vertex from 1.
TEST(MattProof, AnAlbedoJustBelow1IsProvedAndOneJustAboveIsNot) {
  const Material m =
      basis("matt_14", {0.95, 0.03, -0.15, 0.02, 0.01, 0.01, -0.1, 0.05, 0.02, 0.03, 0.05, 0.01, 0.01, 0.02});
  for (const double distance : {-1e-9, 1e-9}) {
    Material scaled = m;
    for (double& w : scaled.terms[0].weights[0]) w *= (1 + distance) / albedo_at_vertex(m);
    const Proof p = proof_of(scaled, Property::energy);
    EXPECT_EQ(p.verdict == Verdict::proved, distance < 0) << p.statement;
    EXPECT_NEAR(p.low, 1, 1e-3);
    EXPECT_GT(p.cover.boxes, 3);
  }
}

TEST(MattProof, ATermBelowZeroInASumThatIsNotIsNeitherProvedNorRefuted) {
  Material m = basis("matt_5", {0.3, -0.45, 0.28, -0.15, 0.25});
  m.terms.push_back(basis("lambert", {0.5}).terms[0]);
  const Proof p = proof_of(m, Property::non_negative);
  EXPECT_EQ(p.verdict, Verdict::bounded) << p.statement;
}

TEST(MattProof, TheCertificateIsCheckedAndAForgedOneIsRejected) {
  const Material m = basis("matt_8", {0.9, 0.07, 0.13, -0.18, 0.1, 0.06, 0.14, -0.09});
  Options options;
  options.properties = {Property::non_negative, Property::energy, Property::reciprocity};
  const std::vector<Proof> proofs = prove(m, "tile.json", options);
  const std::vector<NamedMaterial> materials{{"tile.json", m}};
  const std::string text = to_certificate(proofs, materials);
  EXPECT_TRUE(check({"certificate", text}).faults.empty());
  Material other = m;
  other.terms[0].weights[0][3] = -0.9;
  const std::string forged = to_certificate(proofs, std::vector<NamedMaterial>{{"tile.json", other}});
  EXPECT_FALSE(check({"certificate", forged}).faults.empty());
}

TEST(RetroProof, ARetroreflectiveLobeIsReciprocalBitForBitAndConservesEnergy) {
  Material m = make_material(*find_form("retro"), {"f"});
  m.terms[0].shape = {{0.08, 0.08}};
  m.terms[0].weights = {{0.6}};
  EXPECT_EQ(proof_of(m, Property::reciprocity).verdict, Verdict::proved);
  EXPECT_EQ(proof_of(m, Property::non_negative).verdict, Verdict::proved);
  const Proof energy = proof_of(m, Property::energy);
  EXPECT_EQ(energy.verdict, Verdict::proved);
  EXPECT_LT(energy.high, 0.601);
  EXPECT_GT(energy.low, 0.59);
}

}  // namespace
}  // namespace brdf::prove
