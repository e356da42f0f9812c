// Samplers that are right, and samplers with one fault each: every fault is found by the checks that can see
// it, and nothing else is reported.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "brdf/targets.h"
#include "tests/thorough.h"
#include "validate/joint/catalogue_sampler.h"
#include "validate/joint/cells.h"
#include "validate/joint/judge_sampler.h"
#include "validate/joint/statistics.h"

namespace brdf::validate {
namespace {

using testing::HasSubstr;

// A sampler for a Lambertian surface: with probability `share` by the cosine, otherwise uniform. The number
// that chooses is stretched and used again.
class HalfCosine final : public DirectionSampler {
 public:
  HalfCosine() {
    facts_.draws = facts_.gives_pdf = facts_.has_density = true;
    facts_.values = {{"value"}};
    facts_.randoms = 2;
  }
  const SamplerFacts& facts() const override { return facts_; }
  SamplerFacts& change() { return facts_; }

  // The parts that tests replace.
  double share = 0.6;
  std::function<double(const Vec3<double>&)> density_of = [this](const Vec3<double>& w) {
    return w.z > 0 ? share * w.z / kPi + (1 - share) / (2 * kPi) : 0;
  };
  std::function<double(const Vec3<double>&)> returned = {};  // empty: density_of
  std::function<void(Draw&, std::span<const double>)> at_last = {};
  double stretch = 1;
  bool swapped = false;

  void draw(const Material& at, const Vec3<double>& wo, std::span<const double> u, bool single,
            std::span<Draw> out) const override {
    for (std::size_t k = 0; k < out.size(); ++k) {
      const std::span<const double> own = u.subspan(k * facts_.randoms, facts_.randoms);
      const bool cosine = own[0] < share;
      const double v = cosine ? own[0] / share * stretch : (own[0] - share) / (1 - share);
      const double z = cosine ? std::sqrt(std::max(1 - v, 0.0)) : 1 - v,
                   rho = std::sqrt(std::max(1 - z * z, 0.0));
      const double phi = 2 * kPi * own[1];
      Draw& d = out[k];
      d.wi = {rho * std::cos(phi), rho * std::sin(phi), z};
      d.pdf = returned ? returned(d.wi) : density_of(d.wi);
      d.valid = true;
      d.used = facts_.randoms;
      std::vector<double> f(at.channels.size());
      eval(at, d.wi, wo, f);
      d.values[0] = {f[0], f[0], f[0]};
      if (at_last) at_last(d, own);
      if (single) d.pdf = double(float(d.pdf));
    }
  }
  void density(const Material&, const Vec3<double>&, std::span<const Vec3<double>> wi, bool,
               std::span<double> out) const override {
    for (std::size_t k = 0; k < wi.size(); ++k) out[k] = density_of(wi[k]);
  }

 private:
  SamplerFacts facts_;
};

std::map<std::string, Finding> judged(const DirectionSampler& sampler, std::uint64_t seed = 1,
                                      const Subject& subject = Subject::form(*find_form("lambert"))) {
  CheckOptions options;
  options.seed = seed;
  std::map<std::string, Finding> out;
  std::vector<Finding> findings = judge_sampler(subject, sampler, options, 1 << 14);
  for (std::size_t k = 0; k < findings.size(); ++k) out[std::string(kSamplerChecks[k])] = findings[k];
  return out;
}

std::vector<std::string> failed(const std::map<std::string, Finding>& findings) {
  std::vector<std::string> out;
  for (const auto& [name, finding] : findings)
    if (finding.outcome == Outcome::fail) out.push_back(name);
  return out;
}

TEST(Sampler, ARightOnePassesEveryCheck) {
  for (const auto& [name, finding] : judged(HalfCosine()))
    EXPECT_EQ(finding.outcome, Outcome::pass) << name << ": " << finding.statement;
}

TEST(Sampler, AOnePercentErrorInAQuarterIsFound) {
  for (const std::uint64_t seed : {1, 2}) {
    HalfCosine sampler;
    const auto right = sampler.density_of;
    sampler.density_of = [right](const Vec3<double>& w) {
      return right(w) * (w.x > 0 && w.y > 0 ? 1.01 : 1);
    };
    const auto found = judged(sampler, seed);
    EXPECT_THAT(failed(found), testing::IsSupersetOf({"density_mass", "jacobian"}));
    EXPECT_THAT(found.at("density_mass").statement, HasSubstr("integrates to 1.0025"));
    // The same with the mass restored: only the exact density sees it.
    sampler.density_of = [right](const Vec3<double>& w) {
      return right(w) * (w.x > 0 && w.y > 0 ? 1.01 : w.x < 0 && w.y < 0 ? 0.99 : 1);
    };
    EXPECT_THAT(failed(judged(sampler, seed)), testing::Contains("jacobian"));
  }
}

TEST(Sampler, ADensityThatIsNotTheReturnedOne) {
  HalfCosine sampler;
  sampler.returned = sampler.density_of;
  sampler.density_of = [](const Vec3<double>& w) { return w.z > 0 ? 1 / (2 * kPi) : 0; };
  const auto found = judged(sampler);
  EXPECT_THAT(failed(found), testing::IsSupersetOf({"density_match", "jacobian", "sample_distribution"}));
  EXPECT_THAT(found.at("jacobian").statement, HasSubstr("is the uniform density 1 / (2 pi)"));
  EXPECT_EQ(found.at("density_mass").outcome, Outcome::pass);
}

TEST(Sampler, CausesAreNamed) {
  const auto statement = [](std::function<double(const Vec3<double>&, double)> wrong) {
    HalfCosine sampler;
    const auto right = sampler.density_of;
    sampler.density_of = [=](const Vec3<double>& w) { return w.z > 0 ? wrong(w, right(w)) : 0; };
    return judged(sampler).at("jacobian").statement;
  };
  EXPECT_THAT(statement([](const Vec3<double>&, double p) { return p * 0.9; }),
              HasSubstr("has a wrong constant factor: the true density is 1.1111"));
  EXPECT_THAT(statement([](const Vec3<double>& w, double p) { return p * w.z; }),
              HasSubstr("has the factor cos_i once too often"));
  EXPECT_THAT(statement([](const Vec3<double>& w, double p) { return p / w.z; }),
              HasSubstr("is per projected solid angle"));
}

TEST(Sampler, AValueWithAFactorTooMany) {
  HalfCosine sampler;
  sampler.at_last = [](Draw& d, std::span<const double>) { d.values[0][0] *= d.wi.z; };
  const auto found = judged(sampler);
  EXPECT_THAT(failed(found), testing::ElementsAre("sample_mean", "sample_value"));
  EXPECT_THAT(found.at("sample_value").statement, HasSubstr("it is f*cos_i"));
  // The same value is right if the file says so.
  sampler.change().values = {{"value", SampleValue::f_cos_i}};
  EXPECT_THAT(failed(judged(sampler)), testing::IsEmpty());
}

// A density that is infinite at sampled directions alone is found there, and costs no endless division.
TEST(Sampler, ADensityThatIsInfiniteAtItsSamplesIsNamed) {
  HalfCosine sampler;
  const auto right = sampler.density_of;
  std::set<double> heights;
  sampler.at_last = [&heights](Draw& d, std::span<const double>) { heights.insert(d.wi.z); };
  sampler.density_of = [&](const Vec3<double>& w) { return heights.contains(w.z) ? HUGE_VAL : right(w); };
  sampler.returned = right;
  const auto found = judged(sampler);
  EXPECT_EQ(found.at("density_mass").outcome, Outcome::fail);
  EXPECT_THAT(found.at("density_mass").statement, HasSubstr("not finite"));
  EXPECT_LT(found.at("density_mass").evaluations, 4'000'000);
}

TEST(Sampler, AWeightIsRecognised) {
  HalfCosine sampler;
  sampler.at_last = [](Draw& d, std::span<const double>) {
    d.values[0][0] *= d.pdf > 0 ? d.wi.z / d.pdf : 0;
  };
  const auto found = judged(sampler);
  EXPECT_THAT(failed(found), testing::IsEmpty());
  EXPECT_THAT(found.at("sample_value").statement, HasSubstr("f*cos_i/pdf"));
}

TEST(Sampler, AWeightWithoutTheCosine) {
  HalfCosine sampler;
  sampler.at_last = [](Draw& d, std::span<const double>) { d.values[0][0] *= d.pdf > 0 ? 1 / d.pdf : 0; };
  const std::string cause = "is f/pdf: the factor cos_i is missing, or eval returns f*cos_i";
  const auto found = judged(sampler);
  EXPECT_THAT(failed(found), testing::ElementsAre("sample_mean", "sample_value"));
  EXPECT_THAT(found.at("sample_value").statement, HasSubstr(cause));
  EXPECT_THAT(found.at("sample_mean").statement, HasSubstr(cause));
  // Another wrong weight does not get this sentence.
  sampler.at_last = [](Draw& d, std::span<const double>) { d.values[0][0] /= d.pdf * d.wi.z; };
  EXPECT_THAT(judged(sampler).at("sample_value").statement, testing::Not(HasSubstr("f/pdf:")));
}

TEST(Sampler, AChoiceByTwoNumbersTogetherIsNotJudgedExactly) {
  HalfCosine sampler;
  sampler.change().randoms = 4;
  sampler.at_last = [](Draw& d, std::span<const double> u) { d.valid = u[2] + u[3] < 1.5; };
  const auto whole = sampler.density_of;
  sampler.density_of = [whole](const Vec3<double>& w) { return 0.875 * whole(w); };
  const auto found = judged(sampler);
  EXPECT_THAT(failed(found), testing::IsEmpty());
  EXPECT_EQ(found.at("jacobian").outcome, Outcome::undecided);
  EXPECT_THAT(found.at("jacobian").statement, HasSubstr("several random numbers together"));
  // Two choices that are independent have the product of their probabilities.
  sampler.at_last = [](Draw& d, std::span<const double> u) { d.valid = u[2] < 0.5 && u[3] < 0.25; };
  sampler.density_of = [whole](const Vec3<double>& w) { return 0.125 * whole(w); };
  EXPECT_EQ(judged(sampler).at("jacobian").outcome, Outcome::pass);
}

TEST(Sampler, ANumberThatIsNotStretched) {
  HalfCosine sampler;
  sampler.stretch = 0.6;
  EXPECT_THAT(failed(judged(sampler)),
              testing::IsSupersetOf({"jacobian", "sample_distribution", "sample_mean"}));
}

TEST(Sampler, SamplesThatAreLostMustBeMissingInTheDensity) {
  HalfCosine sampler;
  sampler.at_last = [](Draw& d, std::span<const double>) {
    if (d.wi.z < 0.2) d.pdf = 0;
  };
  EXPECT_THAT(failed(judged(sampler)),
              testing::IsSupersetOf({"density_mass", "sample_distribution", "sample_mean"}));
  // A density of 0 there has the right mass, but leaves light out.
  const auto right = sampler.density_of;
  sampler.density_of = [right](const Vec3<double>& w) { return w.z < 0.2 ? 0 : right(w); };
  const auto found = judged(sampler);
  EXPECT_EQ(found.at("density_mass").outcome, Outcome::pass) << found.at("density_mass").statement;
  EXPECT_THAT(failed(found), testing::IsSupersetOf({"density_support", "sample_mean"}));
}

TEST(Sampler, DirectionsOutOfRange) {
  HalfCosine below;
  below.at_last = [](Draw& d, std::span<const double> u) {
    if (u[1] < 0.1) d.wi.z = -d.wi.z;
  };
  EXPECT_THAT(judged(below).at("sample_range").statement,
              HasSubstr("lie below the horizon and keep a density"));
  HalfCosine longer;
  longer.at_last = [](Draw& d, std::span<const double>) { d.wi.x *= 1.01; };
  EXPECT_THAT(judged(longer).at("sample_range").statement, HasSubstr("length"));
  HalfCosine infinite;
  infinite.at_last = [](Draw& d, std::span<const double> u) {
    if (u[0] == 0) d.wi.x = std::nan("");
  };
  EXPECT_THAT(judged(infinite).at("sample_range").statement, HasSubstr("the end of their range"));
}

// Fewer than one sample in a thousand.
constexpr double kSeldom = 5e-4;

TEST(Sampler, AFewSamplesOutOfRangeAreAFinding) {
  HalfCosine sampler;
  double cosine = 0.3;
  sampler.at_last = [&cosine](Draw& d, std::span<const double> u) {
    if (u[1] > kSeldom) return;
    const double rho = std::sqrt(1 - cosine * cosine);
    d.wi = {rho, 0, -cosine};
  };
  const auto below = judged(sampler).at("sample_range");
  EXPECT_EQ(below.outcome, Outcome::fail);
  EXPECT_THAT(below.statement, testing::ContainsRegex("^[0-9]+ of [0-9]+ samples lie below the horizon"));
  // Directions at the horizon may be rounded; the sentence states how many are.
  cosine = 5e-7;
  const auto rounded = judged(sampler).at("sample_range");
  EXPECT_EQ(rounded.outcome, Outcome::pass) << rounded.statement;
  EXPECT_THAT(
      rounded.statement,
      testing::ContainsRegex(", but for [1-9][0-9]* with a cosine down to -5e-07, which is rounding"));
  cosine = 2e-6;
  EXPECT_EQ(judged(sampler).at("sample_range").outcome, Outcome::fail);
  EXPECT_THAT(judged(HalfCosine()).at("sample_range").statement, testing::Not(HasSubstr("but for")));
  HalfCosine longer;
  longer.at_last = [](Draw& d, std::span<const double> u) { d.wi.x *= u[1] < kSeldom ? 1.01 : 1; };
  EXPECT_THAT(judged(longer).at("sample_range").statement, HasSubstr("length"));
}

TEST(Sampler, AFewWrongDensitiesAndValuesAreAFinding) {
  HalfCosine sampler;
  sampler.at_last = [](Draw& d, std::span<const double> u) {
    if (u[1] < kSeldom) d.pdf *= 1.5, d.values[0][0] *= 2;
  };
  const auto found = judged(sampler);
  EXPECT_EQ(found.at("density_match").outcome, Outcome::fail);
  EXPECT_THAT(found.at("density_match").statement,
              testing::ContainsRegex("differ at [0-9]+ of [0-9]+ samples, by up to 33.3 %"));
  EXPECT_EQ(found.at("sample_value").outcome, Outcome::fail);
  EXPECT_THAT(found.at("sample_value").statement, HasSubstr("with differences up to 50 %"));
  EXPECT_THAT(judged(HalfCosine()).at("density_match").statement, testing::Not(HasSubstr("but for")));
}

// The density differs at the very directions of some samples, but not a rounding further: as a function does
// at an edge.
TEST(Sampler, DifferencesByRoundingOfTheDirectionAreCounted) {
  HalfCosine sampler;
  const auto right = sampler.density_of;
  std::set<double> heights;
  sampler.at_last = [&](Draw& d, std::span<const double> u) {
    if (u[1] < kSeldom) heights.insert(d.wi.z);
  };
  sampler.returned = right;
  sampler.density_of = [&](const Vec3<double>& w) { return right(w) * (heights.contains(w.z) ? 1.5 : 1); };
  const Finding match = judged(sampler).at("density_match");
  EXPECT_EQ(match.outcome, Outcome::pass) << match.statement;
  EXPECT_THAT(match.statement, testing::ContainsRegex(", but for [1-9][0-9]* that differ by up to 33.3 %, as "
                                                      "much as rounding of the direction"));
}

TEST(Sampler, AThinHoleOfTheDensityIsFound) {
  // Only the density has the hole: samples lie in it.
  HalfCosine sampler;
  sampler.change().gives_pdf = false;
  const auto right = sampler.density_of;
  double half_width = 1e-3;
  const auto in_hole = [&half_width](const Vec3<double>& w) { return std::abs(w.z - 0.5) < half_width; };
  sampler.returned = right;
  sampler.density_of = [&](const Vec3<double>& w) { return in_hole(w) ? 0 : right(w); };
  const auto hole = judged(sampler);
  for (const char* check : {"density_mass", "sample_distribution", "density_support"}) {
    EXPECT_EQ(hole.at(check).outcome, Outcome::fail) << check << ": " << hole.at(check).statement;
    EXPECT_THAT(hole.at(check).statement, HasSubstr("the density is 0 at")) << check;
  }
  // The sampler leaves the hole out, too: light is lost there.
  sampler.at_last = [&](Draw& d, std::span<const double>) { d.valid = !in_hole(d.wi); };
  const auto both = judged(sampler);
  EXPECT_EQ(both.at("density_support").outcome, Outcome::fail);
  // 2 z dz = 0.2 % of a Lambertian surface; the largest of six estimates of 130 directions each.
  EXPECT_GT(both.at("density_support").value, 0.002);
  EXPECT_LT(both.at("density_support").value, 0.0026);
  // A hole that may be missed is in the bound of the sentence, which is not "at most".
  half_width = 1e-6;
  const auto thin = judged(sampler).at("density_support");
  EXPECT_EQ(thin.outcome, Outcome::pass);
  EXPECT_THAT(thin.statement, HasSubstr("a hole of 0.021 % of the projected hemisphere would be found"));
  EXPECT_THAT(thin.statement, testing::Not(HasSubstr("at most")));
}

TEST(Sampler, WithoutAFunctionACheckIsUndecided) {
  HalfCosine only_density;
  only_density.change().draws = only_density.change().gives_pdf = false;
  const auto found = judged(only_density);
  EXPECT_EQ(found.at("density_mass").outcome, Outcome::pass);
  for (const char* check : {"density_match", "sample_value", "jacobian", "sample_distribution", "sample_mean",
                            "sample_range", "sample_float"})
    EXPECT_EQ(found.at(check).outcome, Outcome::undecided) << check;
  HalfCosine only_sampler;
  only_sampler.change().has_density = false;
  const auto other = judged(only_sampler);
  for (const char* check : {"density_mass", "density_match", "sample_distribution", "density_support"})
    EXPECT_EQ(other.at(check).outcome, Outcome::undecided) << check;
  for (const char* check : {"jacobian", "sample_mean", "sample_value"})
    EXPECT_EQ(other.at(check).outcome, Outcome::pass) << check << ": " << other.at(check).statement;
}

TEST(Sampler, MoreThanTwoMovingNumbersAreNotJudgedExactly) {
  HalfCosine sampler;
  sampler.change().randoms = 3;
  sampler.at_last = [](Draw& d, std::span<const double> u) {
    const double phi = std::atan2(d.wi.y, d.wi.x) + 6 * u[2], rho = std::hypot(d.wi.x, d.wi.y);
    d.wi.x = rho * std::cos(phi), d.wi.y = rho * std::sin(phi);
  };
  const auto found = judged(sampler);
  EXPECT_EQ(found.at("jacobian").outcome, Outcome::undecided);
  EXPECT_THAT(found.at("jacobian").statement, HasSubstr("depends on 3 random numbers"));
  EXPECT_THAT(failed(found), testing::IsEmpty());
}

// A reflectance of 0.5 / pi, except at directions of the light at which the test replaces it.
class Replaced final : public ReflectanceModel {
 public:
  explicit Replaced(std::function<double(const Vec3<double>&)> value) : value_(std::move(value)) {
    info_.name = info_.family = "replaced";
    info_.outside = true;
  }
  const ReflectanceInfo& info() const override { return info_; }
  void eval(const ParameterValues<double>&, const Directions<double>& d, double* out) const override {
    for (std::size_t k = 0; k < d.count; ++k)
      out[k] = d.wi_z[k] > 0 && d.wo_z[k] > 0 ? value_({d.wi_x[k], d.wi_y[k], d.wi_z[k]}) : 0;
  }
  using ReflectanceModel::eval;

 private:
  std::function<double(const Vec3<double>&)> value_;
  ReflectanceInfo info_;
};

TEST(Sampler, AWeightThatIsNotFiniteIsAFinding) {
  // The sampler returns no value, so that only the mean of the weights looks at f.
  HalfCosine sampler;
  sampler.change().values = {};
  const auto subject = [](double there) {
    const auto model = std::make_shared<const Replaced>([there](const Vec3<double>& w) {
      return w.x > 0.5 && w.x < 0.52 && std::abs(w.y) < 0.1 ? there : 0.5 / kPi;
    });
    return Subject::material("replaced", make_material(Reflectance(model), {"fr"}), OutsideFacts{});
  };
  EXPECT_EQ(judged(sampler, 1, subject(0.5 / kPi)).at("sample_mean").outcome, Outcome::pass);
  for (const double there : {std::nan(""), HUGE_VAL}) {
    const auto found = judged(sampler, 1, subject(there));
    const Finding& mean = found.at("sample_mean");
    EXPECT_EQ(mean.outcome, Outcome::fail) << mean.statement;
    EXPECT_THAT(mean.statement, HasSubstr("the mean of the weights is not finite"));
    EXPECT_THAT(mean.statement, HasSubstr(std::isnan(there) ? "f*cos_i of eval is nan" : "is inf"));
    EXPECT_THAT(mean.statement, testing::Not(HasSubstr("noise")));
    ASSERT_TRUE(mean.witness);
    EXPECT_EQ(mean.witness->angles.size(), 4u);
    EXPECT_EQ(mean.witness->parameters.size(), 2u);  // the random numbers
  }
  // The density function alone is no number at a few of the directions.
  HalfCosine unknown;
  unknown.change().gives_pdf = false;
  unknown.change().values = {};
  const auto right = unknown.density_of;
  unknown.density_of = [right](const Vec3<double>& w) {
    return w.x > 0.5 && w.x < 0.52 && std::abs(w.y) < 0.1 ? std::nan("") : right(w);
  };
  EXPECT_THAT(judged(unknown).at("sample_mean").statement, HasSubstr("with a density of nan"));
}

TEST(Sampler, AValueDoesNotEqualAnEvalThatIsNoNumber) {
  const auto model = std::make_shared<const Replaced>(
      [](const Vec3<double>& w) { return w.x > 0.5 ? std::nan("") : 0.5 / kPi; });
  HalfCosine sampler;
  sampler.at_last = [](Draw& d, std::span<const double>) { d.values[0] = {0.5 / kPi, 0.5 / kPi, 0.5 / kPi}; };
  const auto found =
      judged(sampler, 1, Subject::material("x", make_material(Reflectance(model), {"fr"}), OutsideFacts{}));
  EXPECT_EQ(found.at("sample_value").outcome, Outcome::fail) << found.at("sample_value").statement;
}

TEST(Sampler, AFewLostSamplesAreNoFinding) {
  // A cosine sampler, so that all weights are equal except for the lost ones.
  HalfCosine sampler;
  sampler.share = 1 - 1e-12;
  double lost = 5e-5;
  sampler.at_last = [&lost](Draw& d, std::span<const double> u) {
    if (std::abs(u[1] - 0.3) < lost / 2) d.pdf = 0;
  };
  const auto few = judged(sampler);
  EXPECT_EQ(few.at("sample_distribution").outcome, Outcome::pass) << few.at("sample_distribution").statement;
  EXPECT_EQ(few.at("sample_mean").outcome, Outcome::pass) << few.at("sample_mean").statement;
  lost = 4e-3;
  const auto many = judged(sampler);
  EXPECT_THAT(
      many.at("sample_distribution").statement,
      testing::ContainsRegex("do not follow the density: [0-9]+ samples for 0 expected of 16384 are lost"));
  EXPECT_EQ(many.at("density_mass").outcome, Outcome::fail);
}

TEST(Sampler, ADrawOfAGeneratorMayUseAllRandomNumbers) {
  HalfCosine sampler;
  sampler.change().randoms = 40;
  sampler.change().generated = true;
  long draws = 0, zeros = 0;
  sampler.at_last = [&](Draw& d, std::span<const double> u) {
    ++draws;
    zeros += u.back() == 0;
    d.used = 2;
  };
  judged(sampler);
  EXPECT_LT(double(zeros), 0.001 * double(draws));
}

TEST(Sampler, AnInaccurateIntegralDecidesNothing) {
  HalfCosine sampler;
  sampler.change().gives_pdf = false;
  const auto right = sampler.density_of;
  sampler.density_of = [right](const Vec3<double>& w) {
    const bool dark = std::sin(900 * w.x) * std::sin(900 * w.y) < 0;
    return right(w) * (dark ? 0.5 : 1.5);
  };
  const auto found = judged(sampler);
  EXPECT_EQ(found.at("sample_distribution").outcome, Outcome::undecided)
      << found.at("sample_distribution").statement;
  EXPECT_THAT(found.at("sample_distribution").statement, HasSubstr("not accurate enough"));
}

// Values of Abramowitz and Stegun, tables 26.1 and 26.7.
TEST(SamplerStatistics, TailsAreThoseOfTables) {
  EXPECT_NEAR(two_sided_tail(1.959963985), 0.05, 1e-9);
  EXPECT_NEAR(two_sided_quantile(0.05), 1.959963985, 1e-8);
  EXPECT_NEAR(chi_square_tail(18.307038, 10), 0.05, 1e-7);
  EXPECT_NEAR(chi_square_tail(124.342, 100), 0.05, 1e-5);
  EXPECT_NEAR(chi_square_tail(2, 2), std::exp(-1), 1e-12);
  EXPECT_NEAR(chi_square_tail(200, 2) / std::exp(-100), 1, 1e-9);
  EXPECT_NEAR(poisson_two_sided(0, 5), 2 * std::exp(-5), 1e-12);
  EXPECT_NEAR(sidak(1e-4, 10), 1.00005e-5, 1e-9);
}

TEST(SamplerCells, CoverTheHemisphere) {
  std::vector<Vec3<double>> points;
  Random random(2);
  for (int k = 0; k < 5000; ++k)
    points.push_back(direction(degrees(3 * random.uniform()), degrees(360 * random.uniform())));
  for (const Cells& cells : {Cells(points), Cells({})}) {
    double area = 0;
    for (const Cell& c : cells.all()) area += (c.s1 - c.s0) * (c.phi1 - c.phi0);
    EXPECT_NEAR(area, 2 * kPi, 1e-12);
    for (const Vec3<double>& w : points) {
      const Cell& c = cells.all()[cells.find(w)];
      EXPECT_LE(c.s0, 1 - w.z + 1e-15);
      EXPECT_GE(c.s1, 1 - w.z - 1e-15);
    }
  }
}

// The forms of the catalogue and of the programs to which materials are exported; every third in ./test, all
// in ./test --full.
std::vector<Reflectance> sampled_forms() {
  std::vector<Reflectance> all(catalogue().begin(), catalogue().end()), out;
  all.insert(all.end(), targets().begin(), targets().end());
  for (std::size_t k = 0; k < all.size(); k += thorough() ? 1 : 3) out.push_back(all[k]);
  return out;
}

class CatalogueSamplers : public testing::TestWithParam<Reflectance> {};

// Of a lobe that is 650 times as long as wide the integrals stay inaccurate, which is said: no check fails.
TEST_P(CatalogueSamplers, PassEveryCheckThatLooksAtThem) {
  const Subject subject = Subject::form(GetParam());
  const auto findings = judge_sampler(subject, *catalogue_sampler(GetParam()), CheckOptions{}, 1 << 16);
  for (std::size_t k = 0; k < findings.size(); ++k)
    EXPECT_NE(findings[k].outcome, Outcome::fail) << kSamplerChecks[k] << ": " << findings[k].statement;
  for (const std::string_view check : {"jacobian", "sample_mean", "density_support", "sample_range"}) {
    const Finding& finding =
        findings[std::size_t(std::ranges::find(kSamplerChecks, check) - std::begin(kSamplerChecks))];
    EXPECT_EQ(finding.outcome, Outcome::pass) << check << ": " << finding.statement;
  }
}

INSTANTIATE_TEST_SUITE_P(All, CatalogueSamplers, testing::ValuesIn(sampled_forms()),
                         [](const auto& of) { return std::string(of.param->info().name); });

}  // namespace
}  // namespace brdf::validate
