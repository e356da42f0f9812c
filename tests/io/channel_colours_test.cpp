// Tests that names and wavelengths decide which channel is red, not the order of the columns.
#include <algorithm>

#include "io/colour/channel_colours.h"

#include <gtest/gtest.h>

#include "brdf/forms.h"
#include "io/files/error.h"
#include "io/files/temporary.h"
#include "io/formats/merl.h"
#include "io/formats/read.h"
#include "io/page/html_report.h"
#include "io/samples/samples.h"

namespace brdf::io {
namespace {

using By = ChannelColours::By;
using Three = std::array<std::size_t, 3>;

TEST(ChannelColours, NamesDecideInAnyOrderAndCase) {
  const std::vector<std::vector<std::string>> orders{
      {"b", "g", "r"}, {"Blue", "GREEN", "red"}, {"B", "green", "R"}};
  for (const auto& names : orders) {
    const auto colours = channel_colours(names);
    ASSERT_TRUE(colours);
    EXPECT_EQ(colours->of, (Three{2, 1, 0})) << names[0];
    EXPECT_EQ(colours->by, By::name);
    EXPECT_EQ(colours->note, "");
  }
}

TEST(ChannelColours, TheLongestOfThreeWavelengthsIsRed) {
  const auto colours = channel_colours({"465nm", "f_525.5 nm", "630NM"});
  ASSERT_TRUE(colours);
  EXPECT_EQ(colours->of, (Three{2, 1, 0}));
  EXPECT_EQ(colours->by, By::wavelength);
  EXPECT_NE(colours->note.find("by their wavelengths"), std::string::npos);
  // This holds for infrared channels, too.
  EXPECT_EQ(channel_colours({"1550nm", "905nm", "1064nm"})->of, (Three{0, 2, 1}));
}

TEST(ChannelColours, OfASpectrumTheNearestToThePrimariesAreTaken) {
  std::vector<std::string> names;
  for (int nm = 400; nm <= 700; nm += 10) names.push_back(std::to_string(nm) + "nm");
  const auto colours = channel_colours(names);
  ASSERT_TRUE(colours);
  EXPECT_EQ(names[colours->of[0]], "610nm");
  EXPECT_EQ(names[colours->of[1]], "550nm");
  EXPECT_EQ(names[colours->of[2]], "460nm");
  EXPECT_NE(colours->note.find("31 bands are converted to a colour"), std::string::npos) << colours->note;
  // A spectrum that lies entirely on one side of the primaries has no three colours.
  EXPECT_FALSE(channel_colours({"900nm", "1000nm", "1100nm", "1200nm"}));
}

TEST(ChannelColours, ThePositionDecidesOnlyWhereNamesDoNotAndSaysSo) {
  for (const auto& names :
       std::vector<std::vector<std::string>>{{"X", "Y", "Z"}, {"r", "g", "x"}, {"r", "red", "b"}}) {
    const auto colours = channel_colours(names);
    ASSERT_TRUE(colours);
    EXPECT_EQ(colours->of, (Three{0, 1, 2})) << names[0];
    EXPECT_EQ(colours->by, By::position);
    EXPECT_NE(colours->note.find("by their position"), std::string::npos);
  }
  EXPECT_EQ(channel_colours({"550nm"})->by, By::grey);
  EXPECT_FALSE(channel_colours({"a", "b"}));
  EXPECT_FALSE(channel_colours({"a", "b", "c", "d"}));
  EXPECT_EQ(channel_colours({"nir", "b", "g", "r"})->of, (Three{3, 2, 1}));
}

TEST(ChannelColours, AWavelengthEndsANameInNanometres) {
  EXPECT_EQ(wavelength_of("fr_650nm"), 650);
  EXPECT_EQ(wavelength_of("465.5 nm"), 465.5);
  for (const char* name : {"650", "nm", "f650nm", "0nm", "1.2.3nm", "650um"})
    EXPECT_FALSE(wavelength_of(name)) << name;
}

TEST(ChannelColours, AMerlFileHasRedInItsRedPlane) {
  SampleTable t;
  t.channels = {"465nm", "525nm", "630nm"};
  t.values = {{0.1}, {0.2}, {0.3}};
  t.sigma.resize(3);
  t.add_directions(30, 180, 30, 0);
  const io::TemporaryFolder folder;
  const auto path = folder.path() / "a.binary";
  const std::vector<std::string> lost = merl::write(path, t);
  const SampleTable back = read_samples(path);
  EXPECT_EQ(back.channels, (std::vector<std::string>{"r", "g", "b"}));
  EXPECT_NEAR(back.values[0][0], 0.3, 1e-12);
  EXPECT_NEAR(back.values[2][0], 0.1, 1e-12);
  EXPECT_TRUE(std::any_of(lost.begin(), lost.end(), [](const std::string& what) {
    return what.find("630nm, 525nm, 465nm are used as red, green, blue") != what.npos;
  }));
  t.channels.pop_back();
  t.values.pop_back();
  EXPECT_THROW(merl::write(path, t), InputError);
}

TEST(ChannelColours, CurvesOfAReportAreDrawnInTheirColours) {
  EXPECT_EQ(channel_palette({"r", "g", "b"}), (std::vector<int>{1, 2, 0}));
  EXPECT_EQ(channel_palette({"465nm", "525nm", "630nm"}), (std::vector<int>{0, 2, 1}));
  EXPECT_EQ(channel_palette({"fr"}), (std::vector<int>{0}));
}

TEST(ChannelColours, AFormThatMixesChannelsMustBeginWithRed) {
  const auto all = catalogue();
  const auto mixing =
      std::find_if(all.begin(), all.end(), [](const Reflectance& f) { return f.info().mixes_channels; });
  ASSERT_NE(mixing, all.end());
  EXPECT_NO_THROW(require_red_first(make_term(*mixing, 3), *channel_colours({"r", "g", "b"})));
  EXPECT_THROW(require_red_first(make_term(*mixing, 3), *channel_colours({"b", "g", "r"})), InputError);
}

}  // namespace
}  // namespace brdf::io
