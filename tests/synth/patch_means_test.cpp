// Tests means over the patches of a Klems basis.
#include <gtest/gtest.h>

#include "brdf/integrals.h"
#include "brdf/quadrature.h"
#include "io/formats/klems_bases.h"
#include "io/samples/degrees.h"
#include "synth/patch_means.h"

namespace brdf::synth {
namespace {

std::vector<io::klems::Patch> patches() {
  return io::klems::patches_of(io::klems::known_bases().front().rings);
}

Material one(const char* form, const std::vector<std::pair<const char*, double>>& shape) {
  Material material = make_material(*find_form(form), {"fr"});
  const ReflectanceInfo& parameters = info(material.terms[0].form);
  for (const auto& [name, value] : shape)
    for (std::size_t k = 0; k < parameters.shape.size(); ++k)
      if (parameters.shape[k].name == name) material.terms[0].shape[0][k] = value;
  return material;
}

// The reflectance of an incident patch: the sum over the outgoing patches.
double reflectance(const io::SampleTable& table, std::size_t light) {
  double sum = 0;
  for (std::size_t viewer = 0; viewer < 145; ++viewer)
    sum += patches()[viewer].projected * table.values[0][light * 145 + viewer];
  return sum;
}

// The mean of the directional albedo over an incident patch of an isotropic material.
double mean_albedo(const Material& material, const io::klems::Patch& patch) {
  const double low = std::pow(io::sin_degrees(patch.lower), 2),
               high = std::pow(io::sin_degrees(patch.upper), 2);
  const quadrature::GaussRule& rule = quadrature::gauss_legendre(8);
  double sum = 0;
  for (std::size_t k = 0; k < rule.node.size(); ++k) {
    const Angle theta = radians(std::asin(std::sqrt(low + (high - low) * rule.node[k])));
    sum += rule.weight[k] * directional_albedo(material, theta, degrees(0))[0].value;
  }
  return sum;
}

TEST(PatchMeans, OfAConstantAreTheConstant) {
  const Material white = one("lambert", {});
  std::vector<double> f(1);
  eval(white, io::unit_vector(10, 0), io::unit_vector(20, 0), f);
  const PatchMeans means = patch_means(white);
  ASSERT_EQ(means.table.rows(), 145u * 145u);
  for (const double value : means.table.values[0]) EXPECT_NEAR(value, f[0], 1e-12);
  EXPECT_LT(means.error, 1e-9);
  EXPECT_EQ(means.unresolved, 0u);
}

TEST(PatchMeans, ReflectTheLightOfTheAlbedo) {
  for (const double alpha : {0.5, 0.1, 0.01}) {
    const Material material = one("ward", {{"alpha", alpha}});
    const PatchMeans means = patch_means(material);
    EXPECT_EQ(means.unresolved, 0u) << alpha;
    EXPECT_LE(means.error, kPatchTolerance) << alpha;
    for (const std::size_t light : {0u, 3u, 30u, 80u, 120u}) {
      const double albedo = mean_albedo(material, patches()[light]);
      EXPECT_NEAR(reflectance(means.table, light), albedo, 3e-3 * albedo) << alpha << ' ' << light;
    }
  }
}

TEST(PatchMeans, TheMirrorDirectionIsOnTheDiagonal) {
  const PatchMeans means = patch_means(one("ward", {{"alpha", 0.05}}));
  const std::vector<io::klems::Patch> all = patches();
  for (std::size_t light = 0; light < 145; ++light)
    for (std::size_t viewer = 0; viewer < 145; ++viewer) {
      if (viewer == light || all[viewer].lower != all[light].lower) continue;
      EXPECT_LT(means.table.values[0][light * 145 + viewer], means.table.values[0][light * 146]);
    }
}

// The means over two patches by a plain sum over many directions.
TEST(PatchMeans, AgreeWithAPlainSumForAnisotropicMaterials) {
  const Material material = one("ward", {{"alpha_x", 0.6}, {"alpha_y", 0.35}});
  ASSERT_TRUE(is_anisotropic(material));
  const PatchMeans means = patch_means(material);
  const std::vector<io::klems::Patch> all = patches();
  constexpr int kSteps = 12;
  for (const auto& [light, viewer] : {std::pair{30, 30}, {30, 37}, {60, 90}, {0, 5}}) {
    double sum = 0;
    std::vector<double> f(1);
    const auto place = [&](const io::klems::Patch& patch, double u, double v) {
      const double low = std::pow(io::sin_degrees(patch.lower), 2),
                   high = std::pow(io::sin_degrees(patch.upper), 2);
      return io::unit_vector(radians(std::asin(std::sqrt(low + (high - low) * u))).degrees(),
                             patch.phi + patch.width * (v - 0.5));
    };
    for (int a = 0; a < kSteps; ++a)
      for (int b = 0; b < kSteps; ++b)
        for (int c = 0; c < kSteps; ++c)
          for (int d = 0; d < kSteps; ++d) {
            const auto at = [](int k) { return (k + 0.5) / kSteps; };
            const Vec3<double> from = place(all[std::size_t(light)], at(a), at(b));
            eval(material, {-from.x, -from.y, from.z}, place(all[std::size_t(viewer)], at(c), at(d)), f);
            sum += f[0];
          }
    const double expected = sum / std::pow(kSteps, 4);
    EXPECT_NEAR(means.table.values[0][std::size_t(light) * 145 + std::size_t(viewer)], expected,
                5e-3 * expected)
        << light << ' ' << viewer;
  }
}

// Means from 2^22 directions of scrambled Sobol points (four scramblings of 2^20, standard errors below
// 2e-7), which are independent of all rules of the integration. Pairs that a symmetry connects are equal.
TEST(PatchMeans, OfALongNarrowLobeAgreeWithManyDirections) {
  Material material = one("ward", {{"alpha_x", 0.05}, {"alpha_y", 0.25}});
  material.terms[0].weights[0] = {0.1, 0.5};
  const PatchMeans means = patch_means(material);
  const auto at = [&](double theta_i, double phi_i, double theta_o, double phi_o) {
    const io::SampleTable& t = means.table;
    for (std::size_t k = 0; k < t.rows(); ++k)
      if (t.theta_i[k] == theta_i && t.phi_i[k] == phi_i && t.theta_o[k] == theta_o && t.phi_o[k] == phi_o)
        return t.values[0][k];
    ADD_FAILURE() << "no such pair";
    return 0.0;
  };
  const double expected[][5] = {{50, 300, 70, 135, 0.0474487520507},
                                {10, 225, 30, 54, 0.374060285452},
                                {40, 180, 50, 330, 0.949203529495},
                                {60, 15, 70, 202.5, 1.68269654619}};
  for (const auto& [theta_i, phi_i, theta_o, phi_o, mean] : expected) {
    EXPECT_NEAR(at(theta_i, phi_i, theta_o, phi_o), mean, kPatchTolerance * mean) << theta_i << ' ' << phi_i;
    EXPECT_EQ(at(theta_i, phi_i, theta_o, phi_o), at(theta_o, phi_o, theta_i, phi_i));
    EXPECT_EQ(at(theta_i, phi_i, theta_o, phi_o), at(theta_i, 360 - phi_i, theta_o, 360 - phi_o));
  }
  // At grazing angles the lobe is too narrow for the number of cells, which is reported.
  EXPECT_GT(means.unresolved, 100u);
  EXPECT_LT(means.unresolved, 400u);
}

}  // namespace
}  // namespace brdf::synth
