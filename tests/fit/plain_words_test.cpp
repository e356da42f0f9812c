// Tests the verdict in plain words and the page of a fit.
#include "fit/report/plain_words.h"

#include <gtest/gtest.h>

#include "fit/report/html.h"
#include "samples.h"

namespace brdf::fit {
namespace {

// Returns a fit with one value for both widths. The tests set its intervals.
FormFit fitted() {
  FormFit f;
  f.form = "cook_torrance";
  f.verdict = Verdict::converged;
  f.material = make_material(*find_form(f.form), {"r", "g"});
  f.median_relative_error = 0.02;
  f.minima.resize(1);
  f.intervals = IntervalsBy::profile;
  f.lack_of_fit.residual_over_scatter = 1.1;
  const auto add = [&](const char* name, const char* channel, double value, double low, double high) {
    Estimate e;
    e.name = name;
    e.channel = channel;
    e.value = value;
    e.low = low;
    e.high = high;
    e.low_open = e.high_open = false;
    f.estimates.push_back(e);
  };
  add("alpha_x", "", 0.1, 0.08, 0.13);
  add("alpha_y", "", 0.1, 0.08, 0.13);
  for (std::size_t c = 0; c < 2; ++c) {
    f.material.terms[0].weights[c] = {0.01, 0.8, 0.1};
    const std::string& channel = f.material.channels[c];
    add("kd", channel.c_str(), 0.01, 0, 0.05);  // wide relative to the value, small relative to the lobe
    add("ks", channel.c_str(), 0.8, 0.7, 0.9);
    add("f0", channel.c_str(), 0.1, 0.08, 0.12);
  }
  return f;
}

TEST(PlainWords, AWellDeterminedFitIsGood) {
  const FormFit f = fitted();
  EXPECT_TRUE(weakly_determined(f).empty());
  EXPECT_EQ(mark_of(f), io::Mark::good);
  EXPECT_EQ(verdict_sentence(f),
            "cook_torrance fits the measurements: median error (fitted) 2 %, consistent with the measurement "
            "noise.");
}

TEST(PlainWords, WeakParametersAreNamedWithTheirChannelsAndTurnTheMark) {
  FormFit f = fitted();
  f.estimates[3].low = 0.2;  // ks[r]
  f.estimates[3].high = 1.4;
  f.estimates[0].high = f.estimates[1].high = 0.5;
  EXPECT_EQ(weakly_determined(f), (std::vector<std::string>{"alpha", "ks (r)"}));
  EXPECT_EQ(mark_of(f), io::Mark::warn);
}

TEST(PlainWords, LackOfFitWidensTheIntervalThatCounts) {
  FormFit f = fitted();
  f.estimates[3].with_lack_of_fit = {0, 3};
  EXPECT_TRUE(weakly_determined(f).empty());
  f.lack_of_fit.beyond_scatter = true;
  EXPECT_EQ(weakly_determined(f), std::vector<std::string>{"ks (r)"});
  EXPECT_EQ(
      verdict_sentence(f),
      "cook_torrance fits the measurements only roughly: median error (fitted) 2 %; the residuals are larger "
      "than the measurement noise in some directions.");
}

TEST(PlainWords, EnergyTurnsTheMarkAndAnUnusableFitIsBad) {
  FormFit f = fitted();
  f.findings = {"violates energy conservation: directional albedo 147 % at 85 degrees (g)"};
  EXPECT_EQ(mark_of(f), io::Mark::warn);
  ASSERT_EQ(remarks_on(f).size(), 2u);
  EXPECT_EQ(remarks_on(f)[0].mark, io::Mark::warn);
  EXPECT_EQ(remarks_on(f)[0].text,
            "Violates energy conservation: directional albedo 147 % at 85 degrees (g).");
  f.findings = {"f0 is at its upper bound 1 in r", "kd, ks and alpha are not identifiable: too few"};
  EXPECT_EQ(remarks_on(f)[0].text, "f0 is at its upper bound 1 in r.");
  EXPECT_EQ(remarks_on(f)[1].text, "kd, ks and alpha are not identifiable: too few.");
  f.verdict = Verdict::misfit;
  EXPECT_EQ(mark_of(f), io::Mark::bad);
}

TEST(PlainWords, BothWidthsOfOneValueAreOneParameter) {
  FormFit f = fitted();
  EXPECT_EQ(named(f, f.estimates[0]).plain, "surface roughness");
  EXPECT_EQ(named(f, f.estimates[0]).symbol, "alpha");
  EXPECT_FALSE(named(f, f.estimates[0]).repeats);
  EXPECT_TRUE(named(f, f.estimates[1]).repeats);
  f.estimates[1].value = 0.2;
  EXPECT_EQ(named(f, f.estimates[0]).plain, "surface roughness along");
  EXPECT_EQ(named(f, f.estimates[1]).plain, "surface roughness across");
  EXPECT_EQ(named(f, f.estimates[1]).symbol, "alpha_y");
  EXPECT_FALSE(named(f, f.estimates[1]).repeats);
}

TEST(FitPage, CurvesAreSmoothAndNothingIsSaidTwice) {
  const Material truth = make_material(*find_form("ward"), {"f"});
  const io::SampleTable table = synth::measure(truth, {});
  const FitResult result = fit(table, {{*find_form("ward")}}, {});
  const std::string html = html_report(result, table, {});
  // The steps of the grid are several degrees; the steps of the curve are half a degree, which gives more
  // than 100 points.
  const std::size_t line = html.find("\"incidence at ");
  ASSERT_NE(line, std::string::npos);
  const std::size_t x = html.find("\"x\":[", line), end = html.find(']', x);
  EXPECT_GT(std::count(html.begin() + std::ptrdiff_t(x), html.begin() + std::ptrdiff_t(end), ','), 100);
  EXPECT_NE(html.find("<code>alpha</code>"), std::string::npos);
  EXPECT_EQ(html.find("<code>alpha_y</code>"), std::string::npos);
}

}  // namespace
}  // namespace brdf::fit
