// Tests the materials of data/materials through the executable.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/options/parameter_row.h"
#include "io/files/error.h"
#include "io/material/material_json.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;

TEST(ShippedMaterials, AreNamedSourcedAndValidAndTenHaveAColour) {
  int coloured = 0;
  std::string files;
  for (const auto& entry : std::filesystem::directory_iterator(BRDF_SOURCE_DIR "/data/materials")) {
    SCOPED_TRACE(entry.path().string());
    const io::MaterialFile file = io::read_material_file(entry.path());
    EXPECT_FALSE(file.name.empty());
    EXPECT_GT(file.source.size(), 15u);
    const std::vector<std::vector<double>>& weights = file.material.terms.at(0).weights;
    const bool grey = weights.at(0) == weights.at(1) && weights.at(1) == weights.at(2);
    // The name of a material without a measured colour must state this fact.
    EXPECT_EQ(grey, file.name.find("(no colour measured)") != file.name.npos);
    coloured += !grey;
    files += " '" + entry.path().string() + "'";
  }
  EXPECT_GE(coloured, 10);
  const io::TemporaryFolder folder;
  const Outcome outcome = run_brdf("validate" + files, folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
}

TEST(ParameterRow, IsEvenOnTheParametersScaleAndLabelled) {
  const Material ward_material = make_material(*find_form("ward"));
  const auto alpha = cli::parameter_row(ward_material, "alpha=0.05:0.8", 5);
  ASSERT_EQ(alpha.size(), 5u);
  const std::vector<double> expected{0.05, 0.1, 0.2, 0.4, 0.8};  // logarithmic
  for (std::size_t k = 0; k < expected.size(); ++k)
    for (const double width : alpha[k].second.terms[0].shape[0]) EXPECT_NEAR(width, expected[k], 1e-15);
  EXPECT_EQ(alpha[0].first, "alpha 0.05");
  EXPECT_EQ(alpha[4].first, "alpha 0.8");
  const auto kd = cli::parameter_row(ward_material, "kd=0:0.9", 4);  // linear
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(kd[k].second.terms[0].weights[c][0], 0.3 * double(k), 1e-15);
  const auto turned = cli::parameter_row(ward_material, "tangent_phi=0:90", 3);
  EXPECT_NEAR(turned[1].second.terms[0].tangent_phi.degrees(), 45, 1e-12);
}

TEST(ParameterRow, RefusesWhatIsNoRangeOfAParameter) {
  const Material material = make_material(*find_form("ward"));
  const auto message = [&](const std::string& range) -> std::string {
    try {
      cli::parameter_row(material, range, 3);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message("alpha=0.05"), "--over 'alpha=0.05': must be NAME=FIRST:LAST");
  EXPECT_THAT(message("alpha=a:1"), HasSubstr("'a' is not a finite number"));
  EXPECT_THAT(message("alpha=0.1:3"), HasSubstr("3 must be between"));
  EXPECT_THAT(message("rho=0:1"),
              HasSubstr("unknown parameter (known: kd, ks, alpha_x, alpha_y, alpha, tangent_phi)"));
}

}  // namespace
}  // namespace brdf
