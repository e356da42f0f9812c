// Reflectances that are not in the catalogue are judged like the forms. Facts that they lack are named, and
// neither fail nor are left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <sstream>

#include "brdf/reflectance_of.h"
#include "validate/form/checks.h"
#include "validate/numerics/numerics.h"
#include "validate/report/report.h"
#include "validate/search/extremes.h"
#include "validate/search/search.h"

namespace brdf::validate {
namespace {

// --- A user's form with three weights and two widths, without further known facts -------------------------

template <class T>
struct ThreeWeights {
  T ground, gloss, fuzz;
  static constexpr auto fields() {
    return std::array{
        Field{&ThreeWeights::ground, ParameterInfo{"ground", 0, 1, 0.3, 1, "", false, "g", Role::diffuse}},
        Field{&ThreeWeights::gloss, ParameterInfo{"gloss", 0, 1, 0.3, 1, "", false, "s", Role::specular}},
        Field{&ThreeWeights::fuzz, ParameterInfo{"fuzz", 0, 1, 0.3, 1, "", false, "z", Role::specular}}};
  }
  constexpr std::array<T, 3> linear() const { return {ground, gloss, fuzz}; }
  static constexpr ThreeWeights from_linear(const std::array<T, 3>& w) { return {w[0], w[1], w[2]}; }
};

// The width across comes first, and the names have nothing in common with the catalogue's.
template <class T>
struct TwoSpreads {
  T filling, warp;
  static constexpr auto fields() {
    return std::array{
        Field{&TwoSpreads::filling,
              ParameterInfo{"filling", 0.1, 1, 0.3, 1, "", true, "a", Role::width_across}},
        Field{&TwoSpreads::warp, ParameterInfo{"warp", 0.1, 1, 0.3, 1, "", true, "b", Role::width}}};
  }
};

struct velvet : Takes<ThreeWeights, TwoSpreads> {
  static constexpr std::string_view name = "velvet", family = "velvet";
  static constexpr NoViolations violations{};
  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& s, const Geometry<G>& g) {
    const S slope = square(g.h.x / s.warp) + square(g.h.y / s.filling);
    return {S(1 / kPi), S(1 / kPi) * math::exp(-slope / square(g.h.z)),
            S(3 / (2 * kPi)) * (g.cos_i * g.cos_o)};
  }
};

// --- Values alone ------------------------------------------------------------------------------------------

using Values = std::function<double(double weight, double shape, const Vec3<double>&, const Vec3<double>&)>;

double matt(double weight, double, const Vec3<double>&, const Vec3<double>&) {
  return weight / kPi;
}

class Lambda : public ReflectanceModel {
 public:
  explicit Lambda(Values f, Role shape = Role::other) : f_(std::move(f)) {
    shape_.front().role = shape;
    info_.name = info_.family = "lambda";
    info_.weights = weights_;
    info_.shape = shape_;
  }
  const ReflectanceInfo& info() const override { return info_; }
  void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override {
    for (std::size_t i = 0; i < d.count; ++i)
      out[i] =
          std::min(d.wi_z[i], d.wo_z[i]) < 0 ? 0 : f_(p.weights.front(), p.shape.front(), d.wi(i), d.wo(i));
  }
  using ReflectanceModel::eval;

 protected:
  ReflectanceInfo info_;

 private:
  Values f_;
  std::array<ParameterInfo, 1> weights_{ParameterInfo{"amount", 0, 1, 0.5, 1, "", false, "", Role::specular}},
      shape_{ParameterInfo{"sharpness", 0, 1, 0.5, 1, "", false, ""}};
};

// Declares derivatives. The derivative by the shape is right; the derivative by the weight is NaN for some
// directions.
class Torn final : public Lambda {
 public:
  Torn() : Lambda(matt) { info_.differentiable = true; }
  void gradient(const ParameterValues<double>& p, const Directions<double>& d,
                const LobeRows& out) const override {
    eval(p, d, out.data);
    for (std::size_t i = 0; i < d.count; ++i) {
      out.data[out.stride + i] = 0;
      out.data[2 * out.stride + i] = d.wi_z[i] < 0.5 ? NAN : 1 / kPi;
    }
  }
};

// One lobe of (1 + sharpness)/8, which states this derivative by the sharpness: 1/8 is right.
class OneLobe final : public Lambda {
 public:
  explicit OneLobe(double stated)
      : Lambda([](double weight, double sharpness, const auto&, const auto&) {
          return weight * (1 + sharpness) / 8;
        }),
        stated_(stated) {
    info_.differentiable = true;
    info_.lobes = lobes_;
  }
  void lobes(std::span<const double> shape, Partial partial, const Directions<double>& d,
             const LobeRows& out) const override {
    for (std::size_t i = 0; i < d.count; ++i) {
      out.data[i] = (1 + shape[0]) / 8;
      if (partial != Partial::none) out.data[out.stride + i] = stated_;
    }
  }

 private:
  double stated_;
  std::array<LobeWeight, 1> lobes_{};
};

Reflectance lambda(Values f, Role shape = Role::other) {
  return Reflectance(std::make_shared<const Lambda>(std::move(f), shape));
}

using Outcomes = std::map<std::string, Finding>;

Outcomes judged(const Reflectance& reflectance) {
  Outcomes found;
  for (const Finding& f : run_checks({Subject::form(reflectance)}, {})) found[f.check] = f;
  return found;
}

std::vector<std::string> checks_that_are(const Outcomes& found, Outcome outcome) {
  std::vector<std::string> names;
  for (const auto& [name, f] : found)
    if (f.outcome == outcome) names.push_back(name);
  return names;
}

using Names = std::vector<std::string>;

TEST(Outside, AFormOfOnesOwnIsJudgedByEveryCheckThatItHasFactsFor) {
  const Outcomes found = judged(velvet{});
  const auto of_all = std::ranges::count_if(kChecks, [](const Check& c) { return c.of == Check::Of::all; });
  EXPECT_EQ(found.size(), std::size_t(of_all)) << "all but the checks of shaders and their samplers";
  EXPECT_EQ(checks_that_are(found, Outcome::fail), Names{});
  EXPECT_EQ(checks_that_are(found, Outcome::not_applicable),
            (Names{"albedo", "normalisation", "white_furnace"}));
  EXPECT_NEAR(found.at("energy").value, 1, 1e-6);
  ASSERT_TRUE(found.at("energy").tied);
  EXPECT_NE(found.at("energy").statement.find("the largest with equal widths 1 (warp "), std::string::npos)
      << found.at("energy").statement;
}

TEST(Outside, ValuesAloneAreJudgedAndWhatTheyLackIsNamed) {
  const Outcomes found = judged(lambda(matt));
  EXPECT_EQ(checks_that_are(found, Outcome::fail), Names{});
  EXPECT_EQ(checks_that_are(found, Outcome::not_applicable),
            (Names{"albedo", "derivatives", "normalisation", "sampling", "white_furnace"}));
  EXPECT_NE(found.at("sampling").statement.find("sharpness"), std::string::npos);
  EXPECT_NE(found.at("derivatives").statement.find("no derivatives"), std::string::npos);
  EXPECT_NEAR(found.at("energy").value, 1, 1e-6);
}

TEST(Outside, AKnownWidthIsSampledByTheCosine) {
  EXPECT_EQ(judged(lambda(matt, Role::width)).at("sampling").outcome, Outcome::pass);
}

// A narrow peak that no sample meets has no part in the variance of the samples.
TEST(Outside, SamplesThatMissANarrowPeakDecideNothing) {
  const auto with_peak = [](double height) {
    return lambda(
        [height](double weight, double, const Vec3<double>& wi, const Vec3<double>& wo) {
          const double x = wi.x + wo.x, y = wi.y + wo.y;
          return weight * (0.5 / kPi + height * std::exp(-4e5 * (x * x + y * y)));
        },
        Role::width);
  };
  const Finding missed = judged(with_peak(100)).at("sampling");
  EXPECT_EQ(missed.outcome, Outcome::undecided) << missed.statement;
  EXPECT_NE(missed.statement.find("may have missed a narrow part of the albedo"), std::string::npos);
  EXPECT_EQ(judged(with_peak(0)).at("sampling").outcome, Outcome::pass);
}

TEST(Outside, ViolationsOfValuesAloneAreFound) {
  const Outcomes found = judged(lambda(
      [](double weight, double, const Vec3<double>& wi, const Vec3<double>&) { return weight * wi.z; }));
  EXPECT_EQ(checks_that_are(found, Outcome::fail), (Names{"energy", "reciprocity"}));
  EXPECT_NEAR(found.at("energy").value, kPi, 1e-6);
  EXPECT_TRUE(found.at("energy").witness->command.empty());  // no command can reproduce it
}

TEST(Outside, ADerivativeThatIsNoNumberFails) {
  const Outcomes found = judged(Reflectance(std::make_shared<const Torn>()));
  EXPECT_EQ(checks_that_are(found, Outcome::fail), Names{"derivatives"});
  EXPECT_TRUE(std::isnan(found.at("derivatives").value));
}

// Fits use the derivatives of the lobes, so the check looks at these.
TEST(Outside, DerivativesOfLobesAreJudged) {
  const auto derivatives = [](double stated) {
    return judged(Reflectance(std::make_shared<const OneLobe>(stated))).at("derivatives");
  };
  EXPECT_EQ(derivatives(0.125).outcome, Outcome::pass);
  const Finding wrong = derivatives(0.126);
  EXPECT_EQ(wrong.outcome, Outcome::fail);
  EXPECT_NEAR(wrong.value, 0.001 / 0.126, 1e-9);  // relative to the stated derivative
}

// One lobe of 1e6 + (1 + sharpness)/8 - 1e6: finite differences show the rounding of the sum alone.
class Cancelled final : public Lambda {
 public:
  explicit Cancelled(double stated)
      : Lambda([](double weight, double sharpness, const auto&, const auto&) {
          return weight * value(sharpness);
        }),
        stated_(stated) {
    info_.differentiable = true;
    info_.lobes = lobes_;
  }
  void lobes(std::span<const double> shape, Partial partial, const Directions<double>& d,
             const LobeRows& out) const override {
    for (std::size_t i = 0; i < d.count; ++i) {
      out.data[i] = value(shape[0]);
      if (partial != Partial::none) out.data[out.stride + i] = stated_;
    }
  }

 private:
  static double value(double sharpness) {
    volatile double sum = 1e6 + (1 + sharpness) / 8;
    return sum - 1e6;
  }
  double stated_;
  std::array<LobeWeight, 1> lobes_{};
};

TEST(Outside, DifferencesThatAreRoundingAreNoReference) {
  const auto derivatives = [](double stated) {
    return judged(Reflectance(std::make_shared<const Cancelled>(stated))).at("derivatives");
  };
  const Finding right = derivatives(0.125);
  EXPECT_EQ(right.outcome, Outcome::pass) << right.value << right.statement;
  EXPECT_NE(right.statement.find("more the differences are no reference"), std::string::npos);
  EXPECT_EQ(derivatives(0.126).outcome, Outcome::fail);  // more than rounding
}

TEST(Outside, WeightsThatShareTheLightNeverExceedIt) {
  const Subject subject = Subject::form(velvet{});
  double least = 1, most = 0;
  for (std::size_t k = 0; k < 500; ++k) {
    const auto w = subject.at(cover_point(k, subject.dimensions(), 1)).terms.front().weights.front();
    most = std::max(most, w[0] + w[1] + w[2]);
    least = std::min({least, w[0], w[1], w[2]});
  }
  EXPECT_LE(most, 1);
  EXPECT_GT(most, 0.95);
  EXPECT_GE(least, 0);
}

TEST(Outside, ExtremesCoverEveryParameterOfAnyTable) {
  const ParameterGrid grid = extreme_parameters(velvet{});
  EXPECT_EQ(grid.weights, (std::vector<std::vector<double>>{{0, 1, 1}, {1.0 / 3, 1.0 / 3, 1.0 / 3}}));
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<double> values;
    for (const auto& shape : grid.shapes) values.push_back(shape[k]);
    EXPECT_EQ(*std::min_element(values.begin(), values.end()), 0.1);
    EXPECT_EQ(*std::max_element(values.begin(), values.end()), 1);
  }
  const auto apart = [](const auto& shape) { return shape[0] < shape[1]; };
  EXPECT_TRUE(std::any_of(grid.shapes.begin(), grid.shapes.end(), apart));
}

TEST(Outside, NumericsNameWhatTheyCannotMeasure) {
  std::ostringstream text;
  EXPECT_TRUE(report_numerics({velvet{}}, {}, false, text, [](int, int) {}));
  EXPECT_NE(text.str().find("velvet: not applicable"), std::string::npos) << text.str();
}

TEST(Outside, TheReportPlotsItWithoutInventingCommands) {
  ReportContent content;
  content.subjects = {Subject::form(velvet{}), Subject::form(lambda(matt))};
  content.findings = run_checks(content.subjects, {});
  const std::string html = to_html(content);
  for (const char* word : {"White furnace: velvet", "White furnace: lambda", "warp (both widths)"})
    EXPECT_NE(html.find(word), std::string::npos) << word;
  EXPECT_EQ(html.find("--form velvet"), std::string::npos);
  EXPECT_EQ(html.find("--form lambda"), std::string::npos);
}

}  // namespace
}  // namespace brdf::validate
