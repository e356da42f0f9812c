// Tests spectral text of the Cornell laboratory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string kCornell = "2\n500 600\n.523599 0 .785398 3.141593 .25 .125\n";

TEST(Cornell, LineBreaksHaveNoMeaning) {
  const SampleTable lines = read(kCornell);
  EXPECT_EQ(lines.format, "cornell");
  EXPECT_THAT(lines.channels, ElementsAre("500nm", "600nm"));
  EXPECT_EQ(value_at(lines, 30, 0, 45, 180, 1), .125);
  const SampleTable words =
      read("# own sample\r\n2 500\t600 # nm\r\n\r\n.523599\r\n0 .785398\r\n3.141593 .25\r\n.125 # end\r\n");
  EXPECT_EQ(words.values, lines.values);
  EXPECT_EQ(words.phi_o, lines.phi_o);
  EXPECT_THAT(words.metadata, Contains(Comment("", "own sample")));
}

TEST(Cornell, MinusPiAndPiAreOneDirection) {
  const SampleTable t = read(kCornell + ".523599 0 .785398 -3.141593 .26 .13\n");
  EXPECT_THAT(t.phi_o, ElementsAre(180, 180));
}

TEST(Cornell, CountsZerosAndGrazingRows) {
  const SampleTable t = read(kCornell + ".523599 0 .6 1 0 .1\n.523599 0 1.570796 1 .1 .1\n");
  EXPECT_EQ(t.rows(), 2u);
  EXPECT_THAT(t.warnings, Contains(HasSubstr("1 of 4 values is exactly 0")));
  EXPECT_THAT(t.warnings, Contains("1 row left out: a polar angle is 90 degrees"));
}

TEST(Cornell, OneWavelengthInLinesOfDifferentLengths) {
  const SampleTable t = read("1\n650\n.1 0 .2 3.1 .3\n.1 0 .3 3.1 .4\n");
  EXPECT_THAT(t.channels, ElementsAre("650nm"));
  EXPECT_EQ(t.rows(), 2u);
  // A table of numbers without a header row is not such a text, although it begins with 1 and 180.
  EXPECT_THAT(message("1 180 .2 .1 .5\n1 180 .3 .1 .5\n1 180 .4 .1 .5\n"),
              HasSubstr("write one above the numbers"));
}

TEST(Cornell, RefusesDamagedText) {
  const std::pair<std::string, const char*> cases[] = {
      {kCornell + ".5 0 .7\n", "ends within a record, after 3 numbers of 6 (four angles and 2 values)"},
      {kCornell + ".5 0 .7 3 .1 x\n", "line 4: 'x' is not a finite number"},
      {kCornell + ".5 0 .7 3 .1 inf\n", "line 4: 'inf' is not a finite number"},
      {kCornell + ".5 0 .7 3 .1 .1\n30 0 45 180 .1 .1\n",
       "line 5: the angles 30, 0, 45, 180 of a record are not"},
      {"2\n500 600\n.5 0 2 3 .1 .1\n",
       "holds no rows of reflected light (1 row left out: a polar angle is above"}};
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
  EXPECT_THAT(message("2\n600 600\n.5 0 .7 3 .1 .1\n"), Not(HasSubstr("record")));
}

TEST(Cornell, AgreesWithTheExample) {
  BRDF_SKIP_WITHOUT(expect_example("cornell_tiny.brdf", "cornell_tiny.expect.csv", {.angle = 1e-4}));
}

}  // namespace
}  // namespace brdf::io
