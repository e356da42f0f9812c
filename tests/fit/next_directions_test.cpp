// Which directions to measure next: rows that determine parameters, that hold against an error of the form,
// and that distinguish two forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "brdf/random.h"
#include "fit/design/next_report.h"
#include "io/samples/degrees.h"
#include "samples.h"

namespace brdf::fit {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

// The directions of an instrument: five lights, a hemisphere of viewers.
io::SampleTable reach() {
  io::SampleTable out;
  for (double light = 0; light < 76; light += 15)
    for (double viewer = 0; viewer < 76; viewer += 5)
      for (double azimuth = 0; azimuth < 181; azimuth += 60) out.add_directions(light, 180, viewer, azimuth);
  return out;
}

// Twelve rows about the normal, which hardly determine a width.
io::SampleTable about_normal() {
  io::SampleTable out;
  for (const double light : {0, 15, 30})
    for (const double viewer : {0, 15, 30, 45}) out.add_directions(light, 180, viewer, 0);
  return out;
}

Material paint(double alpha = 0.25, double kd = 0.4) {
  Material m = make_material(*find_form("cook_torrance"), {"f"});
  m.terms[0].weights = {{kd, 1.0, 0.04}};
  for (double& width : m.terms[0].shape[0]) width = alpha;
  return m;
}

// Gives the rows the values of the material times an error of the form, with relative noise.
void measure(const Material& material, double error, double noise, Random& random, io::SampleTable& table) {
  table.channels = {"f"};
  table.values.assign(1, {});
  const DirectionArrays<double> arrays = io::unit_directions(table);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const Vec3<double> wi = arrays.view().wi(k), wo = arrays.view().wo(k);
    std::vector<double> f(1);
    eval(material, wi, wo, f);
    // A smooth, reciprocal factor that no form has.
    const double x = 1 - wi.z, z = 1 - wo.z,
                 s = (wi.x * wo.x + wi.y * wo.y) / std::sqrt((1 + wi.z) * (1 + wo.z));
    const double wave = std::sin(6 * (std::acos(wi.z) + std::acos(wo.z)));
    f[0] *= std::exp(error * (1.2 * s + 1.5 * (x + z) - 4 * x * z + 0.75 * wave) + noise * random.normal());
    table.values[0].push_back(f[0]);
  }
}

FitOptions dielectric() {
  FitOptions options = without_cross_validation();
  options.metric = Metric::automatic;
  options.fix = {{"f0", {0.04}}};
  options.profiles = false;
  return options;
}

NextDirections next_for(const io::SampleTable& start, const NextOptions& next,
                        const char* form = "cook_torrance", const FitOptions& options = dielectric()) {
  const Samples samples = arranged(start, options);
  const NextModels models = next_models(form, next);
  return next_directions(samples, reach(), models.models, options, models.next);
}

const NextWidth& width(const NextDirections& next, std::string_view name) {
  for (const NextWidth& w : next.widths)
    if (w.now.name == name) return w;
  throw std::runtime_error("no width of " + std::string(name));
}

io::SampleTable with_rows(io::SampleTable table, const std::vector<NextRow>& rows) {
  for (const NextRow& r : rows) table.add_directions(r.theta_i, r.phi_i, r.theta_o, r.phi_o);
  return table;
}

TEST(NextDirections, FourRowsDetermineTheWidthFourTimesAsWellAsRowsAtRandom) {
  Random random(11);
  io::SampleTable start = about_normal();
  measure(paint(), 0, 0.01, random, start);
  const NextDirections next = next_for(start, {.rows = 4, .noise = 0.01});
  const NextWidth& alpha = width(next, "alpha");
  EXPECT_NEAR(alpha.now.error / alpha.now.value, 0.037, 0.006);
  EXPECT_NEAR(alpha.after.error / alpha.after.value, 0.0083, 0.0007);
  EXPECT_GT(alpha.random, 2.5 * alpha.after.error);
  EXPECT_EQ(next.known.noise_from, NoiseFrom::option);
  EXPECT_EQ(next.rows.size(), 4u);
}

// The scatter of the refitted width over draws of the noise, with the rows that were chosen once.
TEST(NextDirections, TheExpectedWidthIsTheScatterOfTheRefit) {
  Random random(5);
  io::SampleTable start = about_normal();
  measure(paint(), 0, 0.01, random, start);
  const NextDirections next = next_for(start, {.rows = 4, .noise = 0.01});
  const NextWidth& alpha = width(next, "alpha");
  double sum = 0, squares = 0;
  constexpr int kDraws = 300;
  for (int k = 0; k < kDraws; ++k) {
    io::SampleTable table = with_rows(about_normal(), next.rows);
    measure(paint(), 0, 0.01, random, table);
    const double value =
        estimate(fit(table, {{*find_form("cook_torrance")}}, dielectric()).ranking[0], "alpha_x").value;
    sum += value / kDraws;
    squares += value * value / kDraws;
  }
  // 300 draws know a standard deviation to 4 %.
  EXPECT_NEAR(std::sqrt(squares - sum * sum) / alpha.after.error, 1, 0.12);
}

TEST(NextDirections, ARefitReportsTheExpectedWidthForItsOwnNoise) {
  Random random(3);
  io::SampleTable start = about_normal();
  measure(paint(), 0, 0.01, random, start);
  const NextDirections next = next_for(start, {.rows = 16, .noise = 0.01});
  io::SampleTable table = with_rows(about_normal(), next.rows);
  double ratio = 0;
  constexpr int kDraws = 40;
  for (int k = 0; k < kDraws; ++k) {
    measure(paint(), 0, 0.01, random, table);
    const FormFit f = fit(table, {{*find_form("cook_torrance")}}, dielectric()).ranking[0];
    ratio += estimate(f, "alpha_x").standard_error / width(next, "alpha").after.error / kDraws;
  }
  EXPECT_NEAR(ratio, 1, 0.1);
}

TEST(NextDirections, AnErrorOfTheFormThatIsStatedSpreadsTheRows) {
  Random random(1);
  io::SampleTable start = about_normal();
  measure(paint(), 0.03, 0.01, random, start);
  const NextDirections trusting = next_for(start, {.rows = 16, .noise = 0.01, .model_error = 0}),
                       doubting = next_for(start, {.rows = 16, .noise = 0.01, .model_error = 0.05});
  // The mean distance in degrees from a row to the nearest other one.
  const auto apart = [](const NextDirections& n) {
    double sum = 0;
    for (const NextRow& a : n.rows) {
      double nearest = 1e9;
      for (const NextRow& b : n.rows)
        if (&a != &b)
          nearest = std::min(nearest, std::abs(a.theta_i - b.theta_i) + std::abs(a.theta_o - b.theta_o) +
                                          std::abs(a.phi_o - b.phi_o));
      sum += nearest / double(n.rows.size());
    }
    return sum;
  };
  EXPECT_GT(apart(doubting), 1.3 * apart(trusting));
  EXPECT_EQ(doubting.known.error_from, ErrorFrom::option);
  // Where the form is wrong, its error stays, however many rows are measured.
  EXPECT_GT(doubting.errors.back().chosen, 0.02);
  EXPECT_LT(doubting.errors.back().chosen, 0.05);
  EXPECT_LT(trusting.errors.back().chosen, 0.005);
}

// Returns the rms of ln(model/truth) over the hemisphere.
double error_over_hemisphere(const Material& fitted, const io::SampleTable& truth) {
  const DirectionArrays<double> arrays = io::unit_directions(truth);
  double sum = 0;
  for (std::size_t k = 0; k < truth.rows(); ++k) {
    std::vector<double> f(1);
    eval(fitted, arrays.view().wi(k), arrays.view().wo(k), f);
    sum += square(std::log(f[0] / truth.values[0][k])) / double(truth.rows());
  }
  return std::sqrt(sum);
}

// Pairs of directions with the density of the cosine.
io::SampleTable hemisphere(Random& random) {
  io::SampleTable out;
  const auto steep = [&] { return radians(std::asin(0.98 * std::sqrt(random.uniform()))).degrees(); };
  while (out.rows() < 400) out.add_directions(steep(), 180, steep(), random.uniform(0, 360));
  return out;
}

// The ratios of the error after chosen rows to the mean error after as many rows at random, on 50 surfaces.
std::vector<double> compared_with_random(std::size_t count, double error, int draws = 6) {
  const io::SampleTable all = reach();
  std::vector<double> ratios;
  constexpr int kSeeds = 50;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Random random{std::uint64_t(seed)};
    const Material truth = paint(random.uniform(0.15, 0.4), random.uniform(0.2, 0.6));
    const auto refitted = [&](io::SampleTable table, Random noise) {
      measure(truth, error, 0.01, noise, table);
      return fit(table, {{*find_form("cook_torrance")}}, dielectric()).ranking[0].material;
    };
    io::SampleTable start = about_normal(), judge = hemisphere(random);
    measure(truth, error, 0, random, judge);
    const Random noise = random;  // the measured rows are the same in every table
    Random first = noise;
    measure(truth, error, 0.01, first, start);
    const NextDirections next = next_for(start, {.rows = count});
    const double chosen = error_over_hemisphere(refitted(with_rows(about_normal(), next.rows), noise), judge);
    double at_random = 0;
    for (int draw = 0; draw < draws; ++draw) {
      std::vector<NextRow> rows(count);
      for (NextRow& r : rows) {
        const auto k = std::size_t(random.uniform() * double(all.rows()));
        r.theta_i = all.theta_i[k], r.phi_i = 180, r.theta_o = all.theta_o[k], r.phi_o = all.phi_o[k];
      }
      at_random += error_over_hemisphere(refitted(with_rows(about_normal(), rows), noise), judge) / draws;
    }
    ratios.push_back(chosen / at_random);
  }
  return ratios;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

TEST(NextDirections, TheChoiceIsNeverATenthWorseThanRandomRowsWithAnErrorOfTheForm) {
  // The mean of 6 draws is too uncertain: the largest ratio is 1.098 with it, and 1.076 with 48 draws.
  const std::vector<double> sixteen = compared_with_random(16, 0.03, 24),
                            four = compared_with_random(4, 0.03);
  EXPECT_LT(std::ranges::max(sixteen), 1.1);
  EXPECT_GT(std::ranges::max(sixteen), 1);
  EXPECT_NEAR(mean(sixteen), 0.93, 0.04);
  // Twelve rows about the normal do not show the error; four rows for the parameters take the form for true.
  const auto worse = std::ranges::count_if(four, [](double ratio) { return ratio > 1.1; });
  EXPECT_GE(worse, 1);
  EXPECT_LE(worse, 6);
  EXPECT_LT(mean(four), 1);
}

TEST(NextDirections, TheChoiceHalvesTheErrorIfTheFormIsTrue) {
  EXPECT_NEAR(mean(compared_with_random(4, 0)), 0.6, 0.15);
}

TEST(NextDirections, AnErrorOfTheFormIsDetectedAndNotInNoise) {
  Random random(2);
  io::SampleTable wrong = reach();
  measure(paint(), 0.05, 0.005, random, wrong);
  io::SampleTable right = reach();
  measure(paint(), 0, 0.005, random, right);
  std::vector<io::SampleTable> starts(2);
  for (std::size_t k = 0; k < wrong.rows(); k += 3) {
    starts[0].add_directions(wrong.theta_i[k], 180, wrong.theta_o[k], wrong.phi_o[k]);
    starts[1].add_directions(right.theta_i[k], 180, right.theta_o[k], right.phi_o[k]);
  }
  measure(paint(), 0.05, 0.005, random, starts[0]);
  measure(paint(), 0, 0.005, random, starts[1]);
  const NextDirections of_wrong = next_for(starts[0], {}), of_right = next_for(starts[1], {});
  EXPECT_EQ(of_wrong.known.error_from, ErrorFrom::residuals);
  EXPECT_GT(of_wrong.known.error, 0.01);
  EXPECT_EQ(of_right.known.error_from, ErrorFrom::undetected);
  EXPECT_EQ(of_right.known.error, 0);
  EXPECT_NEAR(of_right.known.noise, 0.005, 0.001);
}

TEST(NextDirections, FewValuesAreNoGroundToTrustAForm) {
  Random random(4);
  io::SampleTable start;
  for (const double viewer : {0, 15, 30, 45, 60, 75}) start.add_directions(30, 180, viewer, 0);
  measure(paint(), 0, 0.01, random, start);
  const NextDirections next = next_for(start, {.rows = 4});
  EXPECT_EQ(next.known.error_from, ErrorFrom::assumed);
  EXPECT_DOUBLE_EQ(next.known.error, kAssumedError * next.known.noise);
}

TEST(NextDirections, TheRowThatTellsTwoMaskingsApartIsFoundAtOnce) {
  Random random(6);
  io::SampleTable start;
  for (const double light : {0, 15})
    for (const double viewer : {0, 10, 20, 30, 40}) start.add_directions(light, 180, viewer, 0);
  measure(paint(), 0, 0.01, random, start);
  const NextDirections next =
      next_for(start, {.rows = 4, .noise = 0.01}, "cook_torrance,cook_torrance_beckmann");
  EXPECT_EQ(next.aim, Aim::forms);
  EXPECT_EQ(next.rival.empty(), false);
  ASSERT_TRUE(next.decisive);
  EXPECT_LE(*next.decisive, 3u);
  EXPECT_GT(next.ratios.front().chosen, 3 * next.ratios.front().random);
  EXPECT_GT(std::abs(next.rows[0].difference), 0.03);
}

TEST(NextDirections, FormsThatCannotBeToldApartAreNotToldApart) {
  Random random(6);
  io::SampleTable start = about_normal();
  measure(paint(), 0, 0.01, random, start);
  const Samples samples = arranged(start, dielectric());
  const std::vector<std::vector<Reflectance>> twice{{*find_form("cook_torrance")},
                                                    {*find_form("cook_torrance")}};
  FitOptions options = dielectric();
  options.cross_validation = true;
  const NextDirections next = next_directions(samples, reach(), twice, options, {.rows = 4, .noise = 0.01});
  EXPECT_EQ(next.aim, Aim::prediction);
  EXPECT_THAT(next.findings, Contains(HasSubstr("cannot distinguish them")));
}

TEST(NextDirections, ADirectionIsChosenOnceAndNotIfItWasMeasured) {
  Random random(7);
  io::SampleTable start = about_normal();
  measure(paint(), 0, 0.01, random, start);
  const NextDirections next = next_for(start, {.rows = 100});
  std::vector<std::size_t> rows;
  const io::SampleTable all = reach();
  for (const NextRow& r : next.rows) {
    rows.push_back(r.row);
    EXPECT_FALSE(all.theta_i[r.row] <= 30 && all.theta_o[r.row] <= 45 && all.phi_o[r.row] == 0 &&
                 std::fmod(all.theta_o[r.row], 15) == 0);
  }
  std::ranges::sort(rows);
  EXPECT_EQ(std::ranges::adjacent_find(rows), rows.end());
  EXPECT_EQ(rows.size(), 100u);
  EXPECT_GE(next.already_measured, 12u);
}

TEST(NextDirections, TheSameRowsAreChosenEveryTimeWhateverTheValuesOfTheReach) {
  Random random(8);
  io::SampleTable start = about_normal();
  measure(paint(), 0, 0.01, random, start);
  const Samples samples = arranged(start, dielectric());
  const auto models = next_models("cook_torrance", {.rows = 8});
  io::SampleTable with_values = reach();
  measure(paint(0.1, 0.9), 0.2, 0.3, random, with_values);
  const NextDirections a = next_directions(samples, reach(), models.models, dielectric(), models.next),
                       b = next_directions(samples, with_values, models.models, dielectric(), models.next);
  EXPECT_TRUE(b.reach_has_values);
  ASSERT_EQ(a.rows.size(), b.rows.size());
  for (std::size_t k = 0; k < a.rows.size(); ++k) EXPECT_EQ(a.rows[k].row, b.rows[k].row);
}

TEST(NextDirections, AWidthThatNoRowDeterminesIsUnknown) {
  Random random(9);
  io::SampleTable start;
  for (const double viewer : {30, 45, 60, 75}) start.add_directions(0, 180, viewer, 90);
  measure(paint(0.05), 0, 0.01, random, start);
  const NextDirections next = next_for(start, {.rows = 2, .noise = 0.01});
  EXPECT_FALSE(width(next, "alpha").now.determined && width(next, "ks").now.determined);
  EXPECT_THAT(next.findings, Contains(HasSubstr("do not determine")));
}

std::string error_of(const io::SampleTable& start, const NextOptions& next,
                     const char* form = "cook_torrance") {
  try {
    next_for(start, next, form);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(NextDirections, SaysIfTheFormDoesNotFit) {
  Random random(12);
  io::SampleTable start;
  for (const double light : {0, 20, 40, 60})
    for (double viewer = -70; viewer < 71; viewer += 5)
      start.add_directions(light, 180, std::abs(viewer), viewer < 0 ? 180 : 0);
  measure(paint(), 0, 0.01, random, start);
  EXPECT_THAT(next_for(start, {.rows = 2}, "lambert", {}).findings,
              Contains(HasSubstr("the form does not fit the samples")));
  EXPECT_THAT(next_for(start, {.rows = 2}).findings, Each(Not(HasSubstr("does not fit"))));
}

// More than 400 measured rows are thinned, and of more than three channels three are used.
TEST(NextDirections, SaysWhichPartOfTheSamplesTheChoiceUses) {
  Random random(13);
  io::SampleTable start = hemisphere(random);
  for (std::size_t k = 0; k < 200; ++k) start.add_directions(30, 180, 0.3 * double(k), 90);
  measure(paint(), 0, 0.01, random, start);
  EXPECT_THAT(next_for(start, {.rows = 2, .noise = 0.01}).findings,
              Contains(HasSubstr("of the 600 measured rows, spread over all")));
  io::SampleTable spectrum = about_normal();
  measure(paint(), 0, 0.01, random, spectrum);
  spectrum.channels = {"b1", "b2", "b3", "b4"};
  spectrum.values.resize(4, spectrum.values[0]);
  FitOptions options = dielectric();
  options.fix = {};
  EXPECT_THAT(next_for(spectrum, {.rows = 2, .noise = 0.01}, "lambert", options).findings,
              Contains(HasSubstr("the choice uses 3 channels of 4: the first, the middle and the last one")));
}

TEST(NextDirections, SaysIfFewerDirectionsCanBeChosenThanWereAskedFor) {
  Random random(13);
  io::SampleTable start = about_normal(), few;
  measure(paint(), 0, 0.01, random, start);
  few.source = "few.csv";
  for (const double viewer : {20, 40, 60}) few.add_directions(30, 180, viewer, 0);
  const Samples samples = arranged(start, dielectric());
  const NextModels models = next_models("cook_torrance", {.rows = 5, .noise = 0.01});
  const NextDirections next = next_directions(samples, few, models.models, dielectric(), models.next);
  EXPECT_EQ(next.rows.size(), 3u);
  EXPECT_TRUE(next.is_exhausted());
  EXPECT_THAT(next.findings,
              Contains("5 rows were asked for, but few.csv has only 3 directions that can be chosen"));
  EXPECT_FALSE(next.worthwhile &&
               *next.worthwhile >= next.examined);  // no row was examined after the last one
  EXPECT_FALSE(next_for(start, {.rows = 2, .noise = 0.01}).is_exhausted());
}

TEST(NextDirections, ComparesDifferentForms) {
  EXPECT_EQ(next_models("ward,lambert", {.rows = 2}).models.size(), 2u);
}

TEST(NextDirections, IsRefusedIfNoDirectionIsLeft) {
  Random random(14);
  io::SampleTable start = reach();
  measure(paint(), 0, 0.01, random, start);
  EXPECT_THAT(error_of(start, {.noise = 0.01}), HasSubstr("no direction can be chosen: each is beyond"));
}

TEST(NextDirections, WhatCannotBeDecidedIsRefused) {
  Random random(10);
  io::SampleTable two;
  two.add_directions(0, 180, 10, 0);
  two.add_directions(0, 180, 20, 0);
  measure(paint(), 0, 0.01, random, two);
  EXPECT_THAT(error_of(two, {}), HasSubstr("2 values cannot determine the 3 parameters of cook_torrance"));
  io::SampleTable three = two;
  three.add_directions(30, 180, 30, 0);
  measure(paint(), 0, 0.01, random, three);
  EXPECT_THAT(error_of(three, {}),
              HasSubstr("leave nothing to estimate the noise from: state it with --noise"));
  EXPECT_EQ(error_of(three, {.noise = 0.01}), "");
  EXPECT_THAT(error_of(three, {.rows = 0, .noise = 0.01}), HasSubstr("--rows 0: must be between 1 and 1000"));
  EXPECT_THAT(error_of(three, {.noise = 2}), HasSubstr("--noise 2: must be between"));
  EXPECT_THAT(error_of(three, {.noise = 0.01}, "cook_torrance,auto"), HasSubstr("leave the other forms out"));
  EXPECT_THAT(error_of(three, {.aim = Aim::forms, .noise = 0.01}), HasSubstr("needs two forms"));
}

}  // namespace
}  // namespace brdf::fit
