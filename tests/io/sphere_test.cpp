// Tests the block of a report with a turnable sphere: its table of measurements, its still picture, its
// text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "brdf/forms.h"
#include "io/files/base64.h"
#include "io/files/error.h"
#include "io/page/sphere/page.h"
#include "io/page/sphere/still.h"
#include "tests/thorough.h"

namespace brdf::io::sphere {
namespace {

using testing::HasSubstr;
using testing::Not;

Colour times(const Colour& f, double factor) {
  return {factor * f[0], factor * f[1], factor * f[2]};
}

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
  return count;
}

std::string page_of(const Shown& shown) {
  HtmlReport report("a page");
  add(report, shown);
  return report.document({});
}

TEST(Base64, PadsAsTheStandardsExamples) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(SphereTable, HoldsTheRatioWithinItsStatedAccuracy) {
  BRDF_LONG_UNDER_SANITIZERS();
  const FittedPairs fitted = fitted_pairs(make_material(cook_torrance{}));
  // The measured values are half of the fitted values, and four times the fitted values beyond 45 degrees.
  const MeasuredPairs measured = [&](const Vec3<double>& wi, const Vec3<double>& wo) {
    return std::optional(times(fitted(wi, wo), wi.z > 0.7 ? 0.5 : 4.0));
  };
  const Table table = table_of(fitted, measured);
  const TableSize& n = table.size;
  ASSERT_EQ(table.bytes.size(), std::size_t(4 * n.theta_h * n.theta_d * (n.phi_d + 1) * n.phi_h));
  EXPECT_EQ(table.bytes.size(), 69632u);
  EXPECT_NEAR(table.low, std::log(0.5), 0.02);
  EXPECT_NEAR(table.high, std::log(4), 0.02);
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(table.bytes[k]); };
  // theta_h and theta_d are 0 at the first node.
  EXPECT_EQ(byte(3), 255);
  EXPECT_NEAR(std::exp(table.low + (table.high - table.low) * byte(0) / 255), 0.5, 0.011 * 0.5);
  // At a half vector of 90 degrees the directions themselves are below the horizon, but neighbouring
  // directions are above it.
  EXPECT_LT(byte(4 * std::size_t(n.theta_h - 1) + 3), 128);
}

TEST(SphereTable, AtTheEdgeOfWhatWasMeasuredANodeHoldsAShare) {
  const FittedPairs fitted = fitted_pairs(make_material(lambert{}));
  // Half vectors are measured up to 40 degrees, between the nodes 42 (40 degrees) and 43 of theta_h.
  const MeasuredPairs measured = [&](const Vec3<double>& wi, const Vec3<double>& wo) {
    const Vec3<double> h = wi + wo;
    const bool within = h.z > std::cos(40.0 / 180 * kPi) * std::sqrt(dot(h, h));
    return within ? std::optional(fitted(wi, wo)) : std::nullopt;
  };
  const Table table = table_of(fitted, measured);
  const auto share = [&](int i) {
    return static_cast<unsigned char>(
        table.bytes[std::size_t(4 * (table.size.theta_h + i) + 3)]);  // theta_d 6 degrees
  };
  EXPECT_EQ(share(40), 255);
  EXPECT_EQ(share(42), 128);
  EXPECT_EQ(share(43), 0);
}

TEST(SphereTable, ANodeAtTheEdgeOfTheSamplesTurnsHoldsAShareToo) {
  const FittedPairs fitted = fitted_pairs(make_material(lambert{}));
  // Half vectors are measured for azimuths up to 47 degrees, just beyond the third node of phi_h, 45
  // degrees.
  const MeasuredPairs measured = [&](const Vec3<double>& wi, const Vec3<double>& wo) {
    const Vec3<double> h = wi + wo;
    const double turn = std::atan2(h.y, h.x) / kPi * 180;
    return turn > -1 && turn < 47 ? std::optional(fitted(wi, wo)) : std::nullopt;
  };
  const Table table = table_of(fitted, measured, kTurned);
  const TableSize& n = table.size;
  const auto share = [&](int l) {  // theta_h 30 degrees, theta_d 13 degrees
    return int(static_cast<unsigned char>(
        table.bytes[std::size_t(4 * (14 + n.theta_h * (1 + n.theta_d * (n.phi_d + 1) * l)) + 3)]));
  };
  EXPECT_EQ(share(1), 255);
  EXPECT_EQ(share(2), 128);
  EXPECT_EQ(share(3), 0);
}

TEST(SphereTable, KeepsWhatIsFarFromTheFitWithinItsRange) {
  const FittedPairs fitted = [](const Vec3<double>&, const Vec3<double>&) { return Colour{1e-30, 1, 1}; };
  const MeasuredPairs measured = [](const Vec3<double>&, const Vec3<double>&) {
    return std::optional(Colour{1, 0, -1});
  };
  const Table table = table_of(fitted, measured);
  EXPECT_DOUBLE_EQ(table.low, -std::log(16));
  EXPECT_NEAR(table.high, std::log(16), 1e-12);
  EXPECT_EQ(static_cast<unsigned char>(table.bytes[0]), 255);
  EXPECT_EQ(static_cast<unsigned char>(table.bytes[1]), 0);
  EXPECT_EQ(static_cast<unsigned char>(table.bytes[2]), 0);
}

TEST(SphereTable, OfNothingMeasuredIsUnknownEverywhere) {
  const MeasuredPairs nothing = [](const Vec3<double>&, const Vec3<double>&) {
    return std::optional<Colour>();
  };
  const Table table = table_of(fitted_pairs(make_material(lambert{})), nothing);
  EXPECT_EQ(table.bytes.find_first_not_of('\0'), table.bytes.npos);
}

TEST(SphereView, SeesTheMiddleAlongTheNormalAndTheRimAlongTheSurface) {
  const Pair middle = pair_at(first_view(), 0, 0), rim = pair_at(first_view(), 0.6, 0.8);
  EXPECT_NEAR(middle.wo.z, 1, 1e-15);
  EXPECT_NEAR(std::acos(middle.wi.z) / kPi * 180, 44.813, 1e-3);
  EXPECT_NEAR(rim.wo.z, 0, 1e-15);
  for (const Pair& pair : {middle, rim}) {
    EXPECT_NEAR(dot(pair.wi, pair.wi), 1, 1e-14);
    // Light and viewer are far away, so that the angle between them is the same everywhere.
    EXPECT_NEAR(dot(pair.wi, pair.wo), dot(middle.wi, middle.wo), 1e-14);
  }
}

TEST(SphereExposure, IsThatOfAWhiteDiffuserAtZeroAndFollowsTheMaterial) {
  Material grey = make_material(lambert{});
  grey.terms.front().weights = {{0.8}, {0.8}, {0.8}};
  EXPECT_EQ(exposure_of(fitted_pairs(grey)), 0);
  grey.terms.front().weights = {{0.1}, {0.05}, {0.0125}};
  EXPECT_EQ(exposure_of(fitted_pairs(grey)), 3);
}

TEST(SpherePage, IsSelfContainedAndBringsItsScriptOnce) {
  HtmlReport report("a page");
  add(report, {.title = "first <&>", .fitted = make_material(ward{}), .still = "a picture"});
  add(report, {.title = "second", .fitted = make_material(phong{}), .still = "a picture"});
  const std::string page = report.document({});
  EXPECT_EQ(count_of(page, "<figure class=\"sphere one\">"), 2u);
  EXPECT_EQ(count_of(page, "class Sphere {"), 1u);
  EXPECT_EQ(count_of(page, "touch-action: none"), 1u);
  EXPECT_THAT(page, Not(HasSubstr("http://")));
  EXPECT_THAT(page, Not(HasSubstr("https://")));
  EXPECT_THAT(page, HasSubstr("first &lt;&amp;&gt; in the studio"));
  EXPECT_THAT(page, HasSubstr("vec3 brdf_eval_ward("));
  EXPECT_THAT(page, Not(HasSubstr("class=\"titles\"")));
}

TEST(SpherePage, ShowsTheStillPictureThatItIsGiven) {
  EXPECT_THAT(page_of({.title = "m", .fitted = make_material(ward{}), .still = "a picture"}),
              HasSubstr("<img class=\"still\" alt=\"m in the studio: computed from the formula\" "
                        "src=\"data:image/png;base64,YSBwaWN0dXJl\">"));
}

TEST(SpherePage, SaysWhichLightAndThatMeasurementsAreSmoothed) {
  const FittedPairs pairs = fitted_pairs(make_material(ward{}));
  const std::string page =
      page_of({.title = "m",
               .fitted = make_material(ward{}),
               .measured = [&](const Vec3<double>& wi,
                               const Vec3<double>& wo) { return std::optional(pairs(wi, wo)); },
               .caption = "Smoothed & said.",
               .still = "a picture"});
  EXPECT_EQ(count_of(page, "<figure class=\"sphere one\">"), 1u);
  EXPECT_EQ(count_of(page, "<figure class=\"sphere measured\">"), 1u);
  EXPECT_EQ(count_of(page, "vec3 brdf_eval_ward("), 1u);  // the shader is stored once
  EXPECT_THAT(page, HasSubstr("The fitted material in the studio"));
  EXPECT_THAT(page, HasSubstr("lit by one distant light only"));
  EXPECT_THAT(page, HasSubstr("Smoothed &amp; said."));
  EXPECT_THAT(page_of({.title = "m", .fitted = make_material(ward{}), .still = "a picture"}),
              Not(HasSubstr("one distant light")));
}

TEST(SpherePage, RefusesWhatShadersCannotHave) {
  const Material spectral = make_material(ward{}, {"a", "b", "c", "d"});
  EXPECT_EQ(obstacle(spectral), "its channels are not colours");
  EXPECT_EQ(obstacle(make_material(ward{})), "");
  HtmlReport report("a page");
  EXPECT_THROW(add(report, {.title = "m", .fitted = spectral}), InputError);
}

}  // namespace
}  // namespace brdf::io::sphere
