// Tests shapes that follow a polynomial in 1/wavelength.
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fit/choice.h"
#include "fit/model/smooth.h"
#include "fit/report/html.h"
#include "fit/report/report.h"
#include "fit/solve/minima.h"
#include "io/files/error.h"
#include "samples.h"

namespace brdf::fit {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kTruth[] = {-4.4, 2.0, -0.4};  // of ln alpha

std::vector<std::string> bands() {
  std::vector<std::string> names;
  for (int nm = 420; nm <= 700; nm += 40) names.push_back(std::to_string(nm) + "nm");
  return names;
}

double width_at(std::size_t band) {
  const double x = 1000 / (420 + 40 * double(band));
  return std::exp(kTruth[0] + kTruth[1] * x + kTruth[2] * x * x);
}

// Returns a metal with a width that decreases with wavelength.
Material metal() {
  Material m = make_material(*find_form("cook_torrance"), bands());
  m.terms[0].shape.assign(m.channels.size(), {});
  for (std::size_t k = 0; k < m.channels.size(); ++k) {
    m.terms[0].shape[k] = {width_at(k), width_at(k)};
    m.terms[0].weights[k] = {0.05, 0.9, 0.5 + 0.04 * double(k)};
  }
  return m;
}

FitOptions smooth(int degree) {
  FitOptions options;
  options.smooth = degree;
  options.cross_validation = false;
  return options;
}

TEST(Smooth, TheTruthComesBackWithoutNoise) {
  for (const Metric metric : {Metric::log, Metric::cosine_l2}) {
    FitOptions options = smooth(2);
    options.metric = metric;
    const FormFit f = fit_one(measured(metal()), {"cook_torrance"}, options);
    EXPECT_EQ(f.verdict, Verdict::converged);
    ASSERT_EQ(f.smooth.size(), 1u);
    EXPECT_EQ(f.smooth[0].parameter, "alpha");
    EXPECT_EQ(f.smooth[0].scale, "ln");
    for (std::size_t power = 0; power < 3; ++power)
      EXPECT_NEAR(f.smooth[0].coefficients[power], kTruth[power], 1e-5) << power;
    for (std::size_t band = 0; band < bands().size(); ++band)
      EXPECT_NEAR(f.material.terms[0].shape[band][0], width_at(band), 1e-7) << band;
    EXPECT_EQ(f.parameters, 3 + 3 * bands().size());
  }
}

TEST(Smooth, AHigherDegreeHoldsALowerOne) {
  const FormFit f = fit_one(measured(metal()), {"cook_torrance"}, smooth(4));
  EXPECT_NEAR(f.smooth[0].coefficients[3], 0, 1e-3);
  EXPECT_NEAR(f.smooth[0].coefficients[4], 0, 1e-3);
  for (std::size_t band = 0; band < bands().size(); ++band)
    EXPECT_NEAR(f.material.terms[0].shape[band][0], width_at(band), 1e-7) << band;
}

// 95 % of 40 x 3 intervals: by the binomial distribution, 99 % of the runs lie between 90 and 99 %.
TEST(Smooth, IntervalsHoldTheTruth) {
  const int fits = std::getenv("BRDF_THOROUGH") ? 40 : 12;
  int held_bands = 0, held_coefficients = 0, all_bands = 0, all_coefficients = 0;
  for (std::uint64_t seed = 1; seed <= std::uint64_t(fits); ++seed) {
    const io::SampleTable table = measured(metal(), {"hemisphere"}, 0.05, seed, 20);
    FitOptions options = smooth(2);
    options.metric = Metric::log_relative;
    const FormFit f = fit_one(table, {"cook_torrance"}, options);
    std::size_t band = 0;
    for (const Estimate& e : f.estimates) {
      if (e.name != "alpha_x") continue;
      ASSERT_EQ(e.channel, bands()[band]);
      ASSERT_EQ(e.status, Status::free);
      held_bands += e.low <= width_at(band) && width_at(band) <= e.high;
      ++all_bands;
      ++band;
    }
    for (std::size_t power = 0; power < 3; ++power, ++all_coefficients)
      held_coefficients += std::abs(f.smooth[0].coefficients[power] - kTruth[power]) <=
                           1.96 * f.smooth[0].standard_errors[power];
  }
  EXPECT_EQ(all_bands, fits * int(bands().size()));
  EXPECT_GT(held_bands, 0.89 * all_bands);
  EXPECT_LT(held_bands, all_bands);
  EXPECT_GT(held_coefficients, 0.88 * all_coefficients);
  EXPECT_LT(held_coefficients, all_coefficients);
}

TEST(Smooth, BothWidthsAndTheTangentAreFitted) {
  Material truth = metal();
  for (std::size_t k = 0; k < truth.channels.size(); ++k) truth.terms[0].shape[k][1] *= 1.5;
  truth.terms[0].tangent_phi = degrees(20);
  synth::Instrument instrument;
  instrument.grid.parts = {"hemisphere"};
  instrument.grid.step = 15;
  instrument.grid.theta_i = {10, 45, 65};
  instrument.grid.azimuths = {0, 45, 90};
  FitOptions options = smooth(2);
  options.anisotropic = true;
  const FormFit f = fit_one(synth::measure(truth, instrument), {"cook_torrance"}, options);
  ASSERT_EQ(f.smooth.size(), 2u);
  EXPECT_NEAR(f.material.terms[0].tangent_phi.degrees(), 20, 1e-4);
  for (std::size_t band = 0; band < bands().size(); ++band) {
    EXPECT_NEAR(f.material.terms[0].shape[band][0], width_at(band), 1e-6);
    EXPECT_NEAR(f.material.terms[0].shape[band][1], 1.5 * width_at(band), 1e-6);
  }
}

// Compares the derivatives by every unknown, the nodes of the polynomial included, with central
// differences.
TEST(Smooth, DerivativesEqualDifferences) {
  const io::SampleTable table = measured(metal(), {"hemisphere"}, 0.1, 1, 20);
  for (const char* form : {"cook_torrance", "oren_nayar", "cook_torrance_student", "phong"}) {
    const FitOptions options = smooth(3);
    const FitData data = prepare(table, options);
    const Model model(forms({form}), data.channels, options);
    const SampleStream stream(data, model, chosen_residual(data, options), 0);
    std::vector<double> p = model.initial();
    for (std::size_t k = 0; k < p.size(); ++k)
      p[k] = k < model.shape_slots() ? p[k] + 0.02 * double(k % 3) : 0.1 + 0.01 * double(k % 5);
    const NormalEquations n = stream.normal_equations(p);
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double step = 1e-5;
      std::vector<double> up = p, down = p;
      up[k] += step;
      down[k] -= step;
      const double slope =
          (stream.normal_equations(up).cost - stream.normal_equations(down).cost) / (2 * step);
      EXPECT_NEAR(n.gradient[k], slope, 2e-6 * (std::abs(slope) + n.cost)) << form << ' ' << k;
    }
  }
}

TEST(Smooth, IsSaidInJsonPrintAndReport) {
  const io::SampleTable table = measured(metal(), {"hemisphere"}, 0.02);
  FitOptions options = smooth(1);
  const FitResult result = fit(table, {forms({"cook_torrance"})}, options);
  const io::Json j = to_json(result, table, options).at("ranking").at(0);
  EXPECT_EQ(j.at("smooth").at("alpha").at("coefficients").size(), 2u);
  EXPECT_EQ(j.at("intervals").at("alpha_x").size(), bands().size());
  std::ostringstream text;
  print(text, result, table, options);
  EXPECT_THAT(text.str(), HasSubstr("alpha over wavelength: ln(alpha) = ("));
  const std::string page = html_report(result, table, options);
  EXPECT_THAT(page, HasSubstr("alpha over wavelength"));
  EXPECT_THAT(page, HasSubstr("x = 1000 nm/wavelength"));
}

template <class Do>
std::string refusal(Do&& what) {
  try {
    what();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Smooth, IsRefusedWhereThereIsNoWavelength) {
  const io::SampleTable rgb = measured(make_material(*find_form("ward")));
  EXPECT_THAT(refusal([&] { fit_one(rgb, {"ward"}, smooth(2)); }),
              HasSubstr("--shape smooth: channel 'r' has no wavelength in its name (such as 465nm)"));
  EXPECT_THAT(refusal([&] { fit_one(measured(metal()), {"ward"}, smooth(5)); }), HasSubstr("accepted"));
  Material two = make_material(*find_form("ward"), {"450nm", "650nm"});
  EXPECT_THAT(refusal([&] { fit_one(measured(two), {"ward"}, smooth(2)); }),
              HasSubstr("needs at least 3 wavelengths; the table has 2"));
}

TEST(Smooth, WordsSayWhichShapes) {
  const auto options = [](const std::string& shape, bool per_channel = false) {
    FitChoice choice;
    choice.shape = shape;
    choice.options.per_channel = per_channel;
    return options_of(choice);
  };
  EXPECT_EQ(options("").smooth, 0);
  EXPECT_FALSE(options("shared").shapes_differ());
  EXPECT_TRUE(options("free").per_channel);
  EXPECT_EQ(options("smooth").smooth, 2);
  EXPECT_EQ(options("smooth:1").smooth, 1);
  for (const char* wrong : {"smooth:0", "smooth:6", "smooth:1.5", "smooth:", "smooth:x"})
    EXPECT_THAT(refusal([&] { options(wrong); }), HasSubstr("whole number from 1 to 5")) << wrong;
  EXPECT_THAT(refusal([&] { options("wavy"); }), HasSubstr("must be shared, free, smooth or smooth:DEGREE"));
  EXPECT_THAT(refusal([&] { options("smooth", true); }), HasSubstr("give one of the two"));
  FitChoice choice;
  choice.shape = "smooth:1";
  EXPECT_THAT(arguments_of(choice), ElementsAre("--form", "all", "--shape", "smooth:1"));
}

}  // namespace
}  // namespace brdf::fit
