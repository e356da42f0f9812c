// Tests that matrices of LBNL Window are written in the order in which they are read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/content.h"
#include "io/files/temporary.h"
#include "io/formats/any_table.h"
#include "io/formats/klems_bases.h"
#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A value of its own for each pair of patches; the matrix is not symmetrical.
double own_value(std::size_t light, std::size_t viewer) {
  return 0.001 * static_cast<double>(light) + 0.25 * static_cast<double>(viewer) + 0.5;
}

// The patches of the quarter basis (41 x 41), which `order` walks through.
SampleTable quarter(const std::vector<std::string>& channels, bool backwards = false) {
  const std::vector<klems::Patch> patches = klems::patches_of(klems::known_bases().back().rings);
  SampleTable table;
  table.set_channels(channels);
  for (std::size_t k = 0; k < patches.size() * patches.size(); ++k) {
    const std::size_t at = backwards ? patches.size() * patches.size() - 1 - k : k;
    const std::size_t light = at / patches.size(), viewer = at % patches.size();
    table.add_directions(patches[light].theta, patches[light].phi - 180, patches[viewer].theta,
                         patches[viewer].phi);
    for (std::size_t c = 0; c < channels.size(); ++c)
      table.values[c].push_back(own_value(light, viewer) * static_cast<double>(c + 1));
  }
  return table;
}

class WrittenKlems : public testing::Test {
 protected:
  std::vector<std::string> write(const SampleTable& table) { return write_table(path_, table); }
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "own.xml";
};

TEST(KlemsBases, PatchesCoverTheHemisphere) {
  for (const klems::Basis& basis : klems::known_bases()) {
    double sum = 0;
    for (const klems::Patch& patch : klems::patches_of(basis.rings)) sum += patch.projected;
    EXPECT_NEAR(sum, kPi, 1e-12) << basis.name;
  }
  const std::vector<klems::Patch> full = klems::patches_of(klems::known_bases().front().rings);
  ASSERT_EQ(full.size(), 145u);
  EXPECT_NEAR(full[0].projected, .0238639, 1e-7);
  EXPECT_NEAR(full[144].projected, .0175372, 1e-7);
  EXPECT_EQ(full[2].phi, 45);
}

TEST_F(WrittenKlems, ReadsBackUnmirroredFromBothSurfaces) {
  const std::vector<klems::Patch> patches = klems::patches_of(klems::known_bases().back().rings);
  EXPECT_THAT(write(quarter({"fr"}, true)), IsEmpty());
  for (const char* const matrix : {"", "back"}) {
    const SampleTable back = read_samples(path_, {.matrix = matrix});
    EXPECT_THAT(back.channels, ElementsAre("Visible"));
    ASSERT_EQ(back.rows(), 41u * 41u);
    // Light of patch 3 comes from the azimuth of the patch plus 180 degrees.
    EXPECT_EQ(value_at(back, 18, patches[3].phi + 180, patches[20].theta, patches[20].phi), own_value(3, 20));
    EXPECT_EQ(value_at(back, patches[20].theta, patches[20].phi + 180, 18, patches[3].phi), own_value(20, 3));
    EXPECT_EQ(value_at(back, 0, 0, 78, 45), own_value(0, 34));
    for (std::size_t k = 0; k < back.rows(); ++k)
      EXPECT_EQ(back.values[0][k], own_value(k / 41, k % 41)) << k;
  }
}

TEST_F(WrittenKlems, BandsKeepTheirWavelengthsAndASpectrumHasItsLuminance) {
  EXPECT_THAT(write(quarter({"550nm", "50nm"})),
              ElementsAre("a matrix for visible light, the only one that Radiance reads"));
  const SampleTable bands = read_samples(path_);
  EXPECT_THAT(bands.channels, ElementsAre("550nm", "50nm"));
  EXPECT_EQ(bands.values[1][41 * 3 + 20], 2 * own_value(3, 20));

  SampleTable grey = quarter({"450nm", "500nm", "550nm", "600nm", "650nm"});
  for (std::vector<double>& channel : grey.values) channel = grey.values[0];
  EXPECT_THAT(write(grey), IsEmpty());
  const SampleTable visible = read_samples(path_);
  EXPECT_THAT(visible.channels, ElementsAre("Visible"));
  EXPECT_NEAR(visible.values[0][41 * 3 + 20], own_value(3, 20), 1e-12) << "Y of a grey spectrum is its value";
  EXPECT_EQ(read_samples(path_, {.matrix = "front nm"}).channels.size(), 5u);
}

TEST_F(WrittenKlems, ColoursBecomeTheirLuminance) {
  EXPECT_THAT(write(quarter({"X", "Y", "Z"})), ElementsAre("the channels X and Z"));
  EXPECT_EQ(read_samples(path_).values[0][41 * 3 + 20], 2 * own_value(3, 20));
  EXPECT_THAT(write(quarter({"b", "g", "r"})), ElementsAre(HasSubstr("luminance of r, g and b")));
  EXPECT_NEAR(read_samples(path_).values[0][0], own_value(0, 0) * (.0721923 + 2 * .7151687 + 3 * .2126390),
              1e-6);
}

TEST_F(WrittenKlems, RefusesTablesThatAreNoMatrix) {
  const auto refusal = [&](const SampleTable& table) { return message_of([&] { write(table); }); };
  SampleTable table = quarter({"fr"});
  table.theta_o[5] += .01;
  EXPECT_THAT(refusal(table),
              HasSubstr("are not the centres of the patches of a known basis; fit a material"));
  table = quarter({"fr"});
  for (auto* column : {&table.theta_i, &table.phi_i, &table.theta_o, &table.phi_o, &table.values[0]})
    column->pop_back();
  EXPECT_THAT(refusal(table),
              HasSubstr("values for 1 of the 1681 pairs of patches of LBNL/Klems Quarter are"));
  table.add_directions(0, 0, 0, 0);
  table.values[0].push_back(1);
  EXPECT_THAT(refusal(table), HasSubstr("belong to the same pair of patches"));
  EXPECT_THAT(refusal(quarter({"a", "b"})), HasSubstr("the channels a, b have no place in Klems matrices"));
}

TEST_F(WrittenKlems, MatrixIsChosenByWords) {
  write(quarter({"550nm", "650nm"}));
  EXPECT_THAT(read_samples(path_, {.matrix = "Back 650"}).channels, ElementsAre("650nm"));
  EXPECT_THAT(
      message_of([&] { read_samples(path_, {.matrix = "solar"}); }),
      HasSubstr("--matrix 'solar': no matrix has this name (known: Reflection Front 550nm, Reflection "
                "Back 550nm, Reflection Front 650nm, Reflection Back 650nm)"));
  EXPECT_THAT(
      read_samples(path_).assumptions,
      Contains(HasSubstr("not read: Reflection Back 550nm, Reflection Back 650nm (brdf convert FILE")));
  EXPECT_THAT(message_of([] {
                read_samples(Content{"t.csv", std::string(kHeader) + kRow}, {.matrix = "back"});
              }),
              HasSubstr("--matrix applies to Klems matrices (XML), but the file is csv"));
}

TEST_F(WrittenKlems, NamesAreEscaped) {
  SampleTable table = quarter({"fr"});
  table.metadata = {{"sample", "a < b & c"}, {"date", "x"}};
  EXPECT_THAT(write(table), ElementsAre("comments other than the name and the manufacturer of the sample"));
  EXPECT_EQ(read_samples(path_).find_metadata("name"), "a < b & c");
}

}  // namespace
}  // namespace brdf::io
