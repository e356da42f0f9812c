// Tests tables of refractive indices in their published formats.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "io/csv/dialect.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/temporary.h"
#include "io/files/text.h"
#include "io/formats/optical_constants.h"
#include "tests/io/data_folder.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

OpticalConstants constants(const std::string& text, const std::string& material = "") {
  return read_optical_constants(Content{"gold.yml", text}, material);
}

std::string refusal(const std::string& text, const std::string& material = "") {
  return message_of([&] { constants(text, material); });
}

// Three rows of Johnson and Christy 1972.
constexpr const char* kRecord =
    "REFERENCES: |\n  P. B. Johnson: 12 eV\nDATA:\n  - type: tabulated nk\n    data: |\n        0.4959 1.04 "
    "1.833\n"
    "        0.5209 0.62 2.081\n        0.5486 0.43 2.455\n";

TEST(OpticalConstants, AreReadInEveryWayTheyArePublished) {
  const OpticalConstants record = constants(kRecord);
  EXPECT_THAT(record.nm, ElementsAre(495.9, 520.9, 548.6));
  EXPECT_EQ(record.index[1], (Index{.62, 2.081}));
  for (const char* text :
       {"wl,n\n0.4959,1.04\n0.5209,0.62\n0.5486,0.43\n\nwl,k\n0.4959,1.833\n0.5209,2.081\n0.5486,2.455\n",
        "# a comment\nWavelength "
        "(nm)\tn\tk\tR\n548.6\t0.43\t2.455\t1\n495.9\t1.04\t1.833\tx\n520.9\t0.62\t2.081\ty\n",
        "lambda (um);n;k\n0,4959;1,04;1,833\n0,5209;0,62;2,081\n0,5486;0,43;2,455\n",
        "lambda n k\n495.9 1.04 1.833\n520.9 0.62 2.081\n548.6 0.43 2.455\n"}) {
    const OpticalConstants same = constants(text);
    EXPECT_EQ(same.nm, record.nm) << text;
    EXPECT_EQ(same.index, record.index) << text;
  }
  const OpticalConstants glass =
      constants("DATA:\n - type: tabulated n\n   data: |\n     0.5 1.52\n     0.6 1.51\n");
  EXPECT_EQ(glass.index[1], (Index{1.51, 0}));
  EXPECT_NEAR(glass.reflectances({"500nm"})[0], .52 * .52 / (2.52 * 2.52), 1e-15);
}

TEST(OpticalConstants, AreLinearBetweenTheirRows) {
  const OpticalConstants gold = constants(kRecord);
  const Index middle = gold.at(508.4);
  EXPECT_NEAR(middle.n, .83, 1e-12);
  EXPECT_NEAR(middle.k, 1.957, 1e-12);
  EXPECT_EQ(gold.at(548.6), (Index{.43, 2.455}));
  EXPECT_THAT(message_of([&] { gold.at(600); }),
              HasSubstr("gold.yml: 600 nm is outside the range of this file, 495.9 to 548.6 nm"));
}

TEST(OpticalConstants, OfSeveralMaterialsOneIsAskedFor) {
  const std::string two =
      "material,wavelength_um,n,k,source\nAg,0.5,.05,3,x\nAu,0.5,1,1.8,y\nAg,0.6,.06,4,z\n";
  EXPECT_THAT(constants(two, "Ag").nm, ElementsAre(500, 600));
  EXPECT_THAT(constants(two, "Au").nm, ElementsAre(500));
  EXPECT_THAT(refusal(two), HasSubstr("has several materials: give FILE:MATERIAL (known: Ag, Au)"));
  EXPECT_THAT(refusal(two, "Cu"), HasSubstr("has no material 'Cu' (known: Ag, Au)"));
  EXPECT_THAT(refusal(kRecord, "Au"), HasSubstr("has no column of materials"));
  const io::TemporaryFolder folder;
  const std::string path = (folder.path() / "metals.csv").string();
  std::ofstream(path) << two;
  EXPECT_THAT(read_optical_constants(path + ":Au").nm, ElementsAre(500));
}

TEST(OpticalConstants, ThatCannotBeReadAreRefusedWithTheirPlace) {
  EXPECT_THAT(refusal("theta_i,phi_i,theta_o,phi_o,fr\n1,2,3,4,5\n"),
              HasSubstr("gold.yml, line 1: is not a table of refractive indices"));
  EXPECT_THAT(refusal("wl,n\n0.5,1,2\n"), HasSubstr("line 2: 3 columns, but 2 are expected"));
  EXPECT_THAT(refusal("wl,n\n0.5,-1\n"), HasSubstr("line 2: n '-1' must be a number from 0 to 1e6"));
  EXPECT_THAT(refusal("wl,n\n0.5,1e92\n"), HasSubstr("line 2: n '1e92' must be a number from 0 to 1e6"));
  EXPECT_THAT(refusal("wl,n\n0.5,1\n1e-9,2\n"),
              HasSubstr("line 3: '1e-9' is not a wavelength (0.001 to 1e9)"));
  EXPECT_THAT(refusal("wl,n\n0.5,1\n0.5,2\n"), HasSubstr("the wavelength 500 nm is listed twice"));
  EXPECT_THAT(refusal("wl,n\n"), HasSubstr("holds no row of wavelength and n"));
  EXPECT_THAT(refusal("wl,n\n.5,1\nwl,k\n.6,1\n"), HasSubstr("n and k are given at different wavelengths"));
  EXPECT_THAT(refusal("DATA:\n  - type: formula 2\n    coefficients: 0 1 2\n"),
              HasSubstr("type 'formula 2' is not read"));
}

TEST(OpticalConstants, OfGoldGiveItsColour) {
  std::string text = "wl,n,k\n";
  for (const auto& [nm, n, k] : std::initializer_list<std::array<double, 3>>{{367.9, 1.48, 1.895},
                                                                             {413.3, 1.46, 1.958},
                                                                             {450.9, 1.38, 1.914},
                                                                             {471.4, 1.31, 1.849},
                                                                             {495.9, 1.04, 1.833},
                                                                             {520.9, .62, 2.081},
                                                                             {548.6, .43, 2.455},
                                                                             {582.1, .29, 2.863},
                                                                             {616.8, .21, 3.272},
                                                                             {659.5, .14, 3.697},
                                                                             {704.5, .13, 4.103},
                                                                             {756.0, .14, 4.542},
                                                                             {821.1, .16, 5.083}})
    text += to_text(nm) + "," + to_text(n) + "," + to_text(k) + "\n";
  // data/materials/gold.json, computed every 10 nm from the whole table, has 1 (outside of sRGB), 0.7286
  // and 0.3646.
  const std::vector<double> f0 = constants(text).reflectances({"B", "green", "r"});
  EXPECT_EQ(f0[2], 1);
  EXPECT_NEAR(f0[1], .7286, .003);
  EXPECT_NEAR(f0[0], .3646, .003);
  EXPECT_THAT(message_of([&] {
                constants(kRecord).reflectances({"r", "g", "b"});
              }),
              HasSubstr("does not cover 480 to 620 nm, which colours require"));
  EXPECT_THAT(message_of([&] { constants(kRecord).reflectances({"fr"}); }),
              HasSubstr("channel 'fr' is not named by a wavelength"));
}

// Compares with the column of reflectances that the published table of 130 rows itself contains.
TEST(OpticalConstants, OfPublishedMetalsGiveTheirReflectance) {
  const auto folder = measured_data();
  if (!folder) GTEST_SKIP() << "BRDF_DATA_DIR is unset";
  const std::filesystem::path path = folder->parent_path() / "tables" / "metal_nk_F0.csv";
  std::ifstream lines(path);
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#') || line.starts_with("material")) continue;
    std::vector<std::string_view> fields;
    Dialect dialect;
    dialect.is_separator_line("sep=,");
    ASSERT_TRUE(dialect.split_row(line, fields));
    double um, expected;
    ASSERT_TRUE(parse_number(fields[1], um) && parse_number(fields[4], expected));
    const OpticalConstants metal = read_optical_constants(path.string() + ":" + std::string(fields[0]));
    EXPECT_NEAR(metal.reflectances({to_text(1000 * um) + "nm"})[0], expected, 6e-6) << line;
    ++rows;
  }
  EXPECT_GT(rows, 100u);
}

}  // namespace
}  // namespace brdf::io
