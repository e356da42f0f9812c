// The sentences of `brdf next`: each names the source of its figures, and none promises more than was found.
#include "fit/design/next_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace brdf::fit {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

NextDirections two_rows() {
  NextDirections n;
  n.form = "ward";
  n.measured = 12;
  n.parameters = 3;
  n.reach = 40;
  n.known = {.noise = 0.02, .error = 0, .noise_from = NoiseFrom::option, .error_from = ErrorFrom::option};
  n.rows = {{3, 30, 180, 45, 0, true, 0.4, 0.05}, {7, 60, 180, 60, 0, false, 0.1, 0.031}};
  n.widths = {{{"alpha", "", 0.2, 0.01, true}, {"alpha", "", 0.2, 0.004, true}, 0.008, true},
              {{"ks", "R", 0, 0.5, false}, {"ks", "R", 0, 0.03, true}, 0.5, false}};
  n.error_now = 0.08;
  n.errors = {{4, 0.03, 0.05}};
  n.draws = 12;
  n.examined = 32;
  return n;
}

std::string printed(const NextDirections& n) {
  std::ostringstream out;
  print(out, n, {"start.csv", "reach.csv"});
  return out.str();
}

TEST(NextReport, NamesTheRowsTheirPurposeAndTheExpectedErrors) {
  const std::string text = printed(two_rows());
  EXPECT_THAT(text,
              HasSubstr("ward fitted to 12 rows of start.csv (3 parameters)\n40 directions of reach.csv\n"));
  EXPECT_THAT(text, HasSubstr("    1        30       180        45         0             5 %  parameters\n"
                              "    2        60       180        60         0           3.1 %  values\n"));
  // At 1 % noise the error is half of the error at 2 %; the last column is that of rows at random.
  EXPECT_THAT(
      text, HasSubstr("alpha                        0.2       5 %         2 %           1 %         4 %\n"));
  // An error of a parameter that no row determines is unknown, and beside the value 0 it is absolute.
  EXPECT_THAT(
      text, HasSubstr("ks[R]                          0   unknown        0.03         0.015     unknown\n"));
  EXPECT_THAT(text, HasSubstr("now 8 % (at random: mean of 12 draws, seed 1)"));
  EXPECT_THAT(text, HasSubstr("     4       3 %        5 %\n"));
  EXPECT_THAT(text, HasSubstr("up to the last of the 32 rows that were examined, further rows lower the "
                              "expected error by 1 % or more per row on average"));
}

TEST(NextReport, SaysWhenARowIsNotWorthwhileOnlyIfThatWasFound) {
  NextDirections n = two_rows();
  n.worthwhile = 9;
  EXPECT_THAT(
      printed(n),
      HasSubstr("after 9 rows, any number of further rows lowers the expected error by less than 1 % per "
                "row on average (32 rows examined)"));
  EXPECT_THAT(printed(n), Not(HasSubstr("up to the last")));
  // A single row may lower the error by more: the average from that row on is what was looked at.
  EXPECT_THAT(printed(n), Not(HasSubstr("% each")));
}

TEST(NextReport, SaysNothingOfRowsThatDoNotExist) {
  NextDirections n = two_rows();
  n.reach = n.examined + 3;
  n.already_measured = 1;
  n.dark = 2;
  EXPECT_THAT(
      printed(n),
      HasSubstr("no direction is left: up to the last of 32 rows, further rows lower the expected error "
                "by 1 % or more per row on average"));
  n.reach += 1;
  EXPECT_THAT(printed(n), Not(HasSubstr("no direction is left")));
}

TEST(NextReport, SaysWhenceTheNoiseIsKnown) {
  NextDirections n = two_rows();
  for (const auto& [from, words] :
       {std::pair{NoiseFrom::option, "2 % (--noise)"},
        std::pair{NoiseFrom::stated, "2 % (the median of the columns of sigma)"},
        std::pair{NoiseFrom::table, "2 % (from the samples themselves: rows that must agree)"},
        std::pair{NoiseFrom::residuals, "2 % (from the residuals of the fit, 9 degrees of freedom)"}}) {
    n.known.noise_from = from;
    n.known.freedom = 9;
    EXPECT_THAT(printed(n), HasSubstr(std::string("noise of a reading: ") + words));
  }
  n.known.freedom = 1;
  EXPECT_THAT(printed(n), HasSubstr("1 degree of freedom)"));
}

// An error that residuals would not show is not called 0 without a word.
TEST(NextReport, SaysWhenceTheErrorOfTheFormIsKnown) {
  NextDirections n = two_rows();
  n.known.error_from = ErrorFrom::undetected;
  EXPECT_THAT(printed(n), HasSubstr("not detected in the residuals, taken as 0; if the form is in doubt"));
  EXPECT_THAT(printed(n),
              HasSubstr("with an error of the form as large as the noise, which residuals would not "
                        "show"));
  n.known.error_from = ErrorFrom::option;
  EXPECT_THAT(printed(n), HasSubstr("error of the form: 0 % (--model-error)"));
  EXPECT_THAT(printed(n), Not(HasSubstr("as large as the noise")));
  n.known.error = 0.05;
  EXPECT_THAT(printed(n), HasSubstr("error of the form: 5 % (--model-error)"));
  EXPECT_THAT(printed(n), HasSubstr("chosen to lower the expected error of the values over the hemisphere"));
  n.known.error_from = ErrorFrom::residuals;
  EXPECT_THAT(printed(n), HasSubstr("5 % (neighbouring residuals agree more than noise does"));
  n.known.error_from = ErrorFrom::assumed;
  EXPECT_THAT(printed(n), HasSubstr("cannot be seen with fewer than"));
  EXPECT_THAT(printed(n), HasSubstr("times the noise, 5 %"));
}

TEST(NextReport, SaysWhichDirectionsAreLeftOut) {
  NextDirections n = two_rows();
  n.already_measured = 5;
  n.beyond_max_theta = 2;
  n.dark = 1;
  n.reach_has_values = true;
  n.findings = {"a finding"};
  const std::string text = printed(n);
  EXPECT_THAT(text, HasSubstr("40 directions of reach.csv (left out: 5 measured or "));
  EXPECT_THAT(text, HasSubstr("2 beyond --max-theta"));
  EXPECT_THAT(text, HasSubstr("1 without a value above 0 in the form"));
  EXPECT_THAT(text, HasSubstr("; its values are not used\n"));
  EXPECT_THAT(text, HasSubstr("\na finding\n"));
}

TEST(NextReport, TwoFormsAreToldApartOnlyAfterTheRowsThatSuffice) {
  NextDirections n = two_rows();
  n.aim = Aim::forms;
  n.rival = "phong";
  n.rows[0].gain = 2.5;
  n.rows[0].difference = -0.12;
  n.ratios = {{4, 6.5, 1.25}};
  EXPECT_THAT(printed(n), HasSubstr("chosen to tell ward from phong"));
  EXPECT_THAT(printed(n), HasSubstr("         0              2.5       -12 %\n"));
  EXPECT_THAT(printed(n), HasSubstr("     4       6.5       1.25\n"));
  EXPECT_THAT(printed(n), HasSubstr("a likelihood ratio of 1000 is not expected within 32 rows"));
  n.decisive = 5;
  EXPECT_THAT(printed(n), HasSubstr("a likelihood ratio of 1000 is expected after 5 rows"));
  EXPECT_EQ(to_json(n, {"start.csv", "reach.csv"})["decisive_after"], 5);
}

}  // namespace
}  // namespace brdf::fit
