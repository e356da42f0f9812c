// Tests matrices of LBNL Window and Radiance as XML.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/samples/aperture.h"
#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

// A basis of three patches: the pole, and two patches from 30 to 90 degrees.
std::string klems(const std::string& blocks, const std::string& structure = "Columns") {
  return "<?xml version=\"1.0\"?>\n<WindowElement "
         "xmlns=\"http://windows.lbl.gov\"><Optical><Layer><Material><Name>own"
         "</Name></Material><DataDefinition><IncidentDataStructure>" +
         structure +
         "</IncidentDataStructure><AngleBasis><AngleBasisName>Own/3</AngleBasisName>"
         "<AngleBasisBlock><nPhis>1</nPhis><ThetaBounds><LowerTheta>0</LowerTheta><UpperTheta>30</UpperTheta>"
         "</ThetaBounds></AngleBasisBlock><AngleBasisBlock><nPhis>2</nPhis><ThetaBounds><LowerTheta>30</"
         "LowerTheta>"
         "<UpperTheta>90</UpperTheta></ThetaBounds></AngleBasisBlock></AngleBasis></DataDefinition>" +
         blocks + "</Layer></Optical></WindowElement>\n";
}

std::string matrix(const std::string& direction, const std::string& numbers,
                   const std::string& wavelength = "Visible", const std::string& basis = "Own/3") {
  return "<WavelengthData><Wavelength unit=\"Integral\">" + wavelength +
         "</Wavelength><WavelengthDataBlock><ScatteringData>" + numbers +
         "</ScatteringData><WavelengthDataDirection>" + direction +
         "</WavelengthDataDirection><ColumnAngleBasis>" + basis + "</ColumnAngleBasis><RowAngleBasis>" +
         basis +
         "</RowAngleBasis><ScatteringDataType>BTDF</ScatteringDataType></WavelengthDataBlock></"
         "WavelengthData>";
}

const std::string kNine = ".10, .11, .12,\n.20, .21, .22,\n.30, .31, .32,\n";

TEST(Klems, ColumnsAreIncidentAndTheDiagonalIsTheMirrorDirection) {
  const SampleTable t = read(klems(matrix("Reflection Front", kNine)));
  EXPECT_EQ(t.format, "klems");
  EXPECT_THAT(t.channels, ElementsAre("Visible"));
  ASSERT_EQ(t.rows(), 9u);
  EXPECT_EQ(value_at(t, 0, 0, 0, 0), .10);
  EXPECT_EQ(value_at(t, 60, 180, 60, 0), .21) << "patch 1 to patch 1: the mirror direction";
  EXPECT_EQ(value_at(t, 60, 180, 60, 180), .31) << "patch 1 to patch 2";
  EXPECT_EQ(value_at(t, 60, 0, 0, 0), .12) << "patch 2 to the pole";
  EXPECT_EQ(*t.find_metadata("name"), "own");
}

TEST(Klems, RowsAreTheTransposedMatrix) {
  const SampleTable t = read(klems(matrix("Reflection Front", "1\t2 3\r\n4 5 6\r\n7 8 9"), "Rows"));
  EXPECT_EQ(value_at(t, 60, 180, 0, 0), 4);
  EXPECT_EQ(value_at(t, 60, 180, 60, 180), 6);
}

TEST(Klems, TakesTheFrontInVisibleLightAndNamesTheRest) {
  const SampleTable t =
      read(klems(matrix("Transmission Front", kNine) + matrix("Reflection Front", "1", "Solar") +
                 matrix("Reflection Back", "x") + matrix("Reflection Front", kNine)));
  EXPECT_EQ(value_at(t, 0, 0, 0, 0), .10);
  EXPECT_THAT(t.assumptions,
              Contains(HasSubstr("the matrix 'Reflection Front', Visible, is read; not read: Reflection "
                                 "Front Solar, Reflection Back Visible (brdf convert")));
  EXPECT_THAT(t.warnings, Contains("1 block of transmission left out"));
  EXPECT_EQ(value_at(read(klems(matrix("Reflection Back", kNine))), 0, 0, 0, 0), .10);
}

TEST(Klems, WavelengthsBecomeChannels) {
  const SampleTable t =
      read(klems(matrix("Reflection Front", kNine, "550") + matrix("Reflection Front", kNine, "0.65")));
  EXPECT_THAT(t.channels, ElementsAre("550nm", "650nm"));
}

TEST(Klems, KnowsTheBasesByName) {
  const std::pair<const char*, std::size_t> bases[] = {
      {"LBNL/Klems Full", 145}, {"LBNL/Klems Half", 73}, {"LBNL/Klems Quarter", 41}};
  for (const auto& [name, patches] : bases) {
    const SampleTable t =
        read(klems(matrix("Reflection Front", repeated(".1,", patches * patches), "Visible", name)));
    EXPECT_EQ(t.rows(), patches * patches);
    EXPECT_TRUE(stated_aperture(t));
  }
}

TEST(Klems, AnnouncesMoreReflectedThanIncidentLight) {
  const SampleTable t = read(klems(matrix("Reflection Front", "0 0 0 0 .8 0 0 .8 0")));
  EXPECT_THAT(t.assumptions, Contains(HasSubstr("its transposed matrix at most 1")));
}

TEST(Klems, RefusesDamagedFiles) {
  const std::string good = klems(matrix("Reflection Front", kNine));
  const std::pair<std::string, const char*> cases[] = {
      {klems(matrix("Reflection Front", "1 2 3")), "Reflection Front: 3 values, but 3 x 3 patches need 9"},
      {klems(matrix("Reflection Front", replaced(kNine, ".21", "nan"))), "'nan' is not a finite number"},
      {klems(matrix("Reflection Front", kNine, "Visible", "Own/4")), "the basis 'Own/4' is not defined"},
      {klems(matrix("Transmission Front", kNine)), "holds no reflection (1 block of transmission"},
      {klems(matrix("Reflection Front", kNine), "Diagonal"), "IncidentDataStructure 'Diagonal' is not read"},
      {replaced(good, "<nPhis>2", "<nPhis>2000"), "nPhis '2000' must be a whole number from 1 to 1000"},
      {replaced(good, "<LowerTheta>30", "<LowerTheta>40"), "LowerTheta 40 must be 30"},
      {good.substr(0, 500), "is not readable XML: unclosed token"},
      {replaced(good, "</nPhis>", "</nPhi>"), "is not readable XML: mismatched tag"},
      {replaced(good, "<WindowElement", "<!DOCTYPE x [<!ENTITY a \"b\">]><WindowElement"),
       "declares the entity 'a'"},
      {"<WindowElement>" + repeated("<a>", 200), "is nested more than 100 levels deep"}};
  for (const auto& [text, expected] : cases)
    EXPECT_THAT(message(text), HasSubstr(expected)) << text.substr(0, 300);
}

TEST(Klems, IsRecognisedBehindCommentsWithPrefixes) {
  std::string text = klems(matrix("Reflection Front", kNine));
  text = replaced(replaced(text, "<WindowElement xmlns=", "<!-- a > b --> <w:WindowElement xmlns:w="),
                  "</WindowElement", "</w:WindowElement");
  EXPECT_EQ(read(text).rows(), 9u);
  EXPECT_EQ(read("\xEF\xBB\xBF\n" + text).rows(), 9u);
}

TEST(Klems, AgreesWithTheExample) {
  BRDF_SKIP_WITHOUT(expect_example("klems_tiny.xml", "klems_tiny.expect.csv"));
}

TEST(Klems, ReadsAPublishedFile) {
  const auto file = example("formats", "klems_shade_2011-SA1.xml");
  BRDF_SKIP_WITHOUT(file);
  const SampleTable t = read_samples(*file);
  EXPECT_EQ(t.rows(), 21025u);
  EXPECT_NEAR(mean_of(t), .17121701, 1e-8);
  EXPECT_NEAR(value_at(t, 0, 180, 0, 0), .153571, 1e-6);
  EXPECT_NEAR(value_at(t, 60, 180, 10, 0), .177975, 1e-6);
  EXPECT_NEAR(value_at(t, 10, 180, 60, 0), .154227, 1e-6);
}

}  // namespace
}  // namespace brdf::io
