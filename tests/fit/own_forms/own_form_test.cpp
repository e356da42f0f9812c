// Forms outside the catalogue are fitted according to their tables, whatever the names of their parameters
// are.
#include <gtest/gtest.h>

#include "brdf/reflectance_of.h"
#include "fit/model/model.h"
#include "io/files/error.h"
#include "tests/fit/samples.h"
#include "tests/thorough.h"

namespace brdf::fit {
namespace {

// The weights differ in order and names from the weights of every form of the catalogue; f0 divides the
// gloss.
template <class T>
struct CoatWeights {
  T gloss, edge, body;
  static constexpr auto fields() {
    return std::array{
        Field{&CoatWeights::gloss,
              ParameterInfo{"gloss", 0, 10, 0.5, 1, "", false, "weight of the coat", Role::specular}},
        Field{&CoatWeights::edge,
              ParameterInfo{"edge", 0, 1, 0.1, 1, "", false, "reflectance along the normal", Role::f0}},
        Field{&CoatWeights::body,
              ParameterInfo{"body", 0, 10, 0.5, 1, "", false, "weight of what lies below", Role::diffuse}}};
  }
  constexpr std::array<T, 3> linear() const { return {gloss * (T(1) - edge), body, gloss * edge}; }
  static constexpr CoatWeights from_linear(const std::array<T, 3>& w) {
    const T gloss = w[0] + w[2];
    return {gloss, select(T(0) < gloss, w[2] / gloss, T(0.1)), w[1]};
  }
};

template <class T>
struct TwoPowers {
  T power_u, power_v;
  static constexpr auto fields() {
    return std::array{Field{&TwoPowers::power_u, ParameterInfo{"power_u", 1, 1e5, 30, 1e4, "", true,
                                                               "power along", Role::exponent}},
                      Field{&TwoPowers::power_v, ParameterInfo{"power_v", 1, 1e5, 30, 1e4, "", true,
                                                               "power across", Role::exponent_across}}};
  }
};

template <class G>
G log_cos_h(const Geometry<G>& g) {
  return G(0.5) * math::log(g.h.z * g.h.z / g.h2);
}

struct coat : Takes<CoatWeights, TwoPowers> {
  static constexpr std::string_view name = "coat", family = "coat";
  static constexpr NoViolations violations{};
  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const G x = g.h.x * g.h.x, y = g.h.y * g.h.y, across = select(G(1e-12) < x + y, x + y, G(1e-12));
    const S power = shape.power_u * S(x / across) + shape.power_v * S(y / across);
    const S lobe = math::exp(power * S(log_cos_h(g)));
    const G rest = G(1) - g.cos_d, rest2 = rest * rest;
    const S rise = S(rest2 * rest2 * rest);
    return {lobe * rise, S(1 / kPi), lobe};
  }
};

Material coat_material() {
  Material truth = make_material(coat{}, {"r", "g"});
  truth.terms[0].shape[0] = {12, 140};
  truth.terms[0].weights = {{0.8, 0.2, 0.3}, {0.5, 0.6, 0.1}};
  return truth;
}

io::SampleTable samples_of(const Material& truth) {
  synth::Instrument instrument;
  instrument.grid.azimuths = {0, 30, 60, 90};
  instrument.grid.theta_i = {20, 50, 75};
  return synth::measure(truth, instrument);
}

FitOptions options_of(bool anisotropic) {
  FitOptions options;
  options.cross_validation = false;
  options.anisotropic = anisotropic;
  return options;
}

void expect_found(const Material& found, const Material& truth) {
  EXPECT_LT(largest_relative_difference(found.terms[0].shape[0], truth.terms[0].shape[0]), 1e-6);
  for (std::size_t c = 0; c < truth.channels.size(); ++c)
    EXPECT_LT(largest_relative_difference(found.terms[0].weights[c], truth.terms[0].weights[c]), 1e-6);
}

TEST(OwnForm, ComesBackToSixDigits) {
  BRDF_LONG_UNDER_SANITIZERS();
  const Material truth = coat_material();
  for (const Metric metric : {Metric::log, Metric::cosine_l2}) {
    FitOptions options = options_of(true);
    options.metric = metric;
    const FormFit f = fit(samples_of(truth), {{coat{}}}, options).ranking.front();
    EXPECT_EQ(f.verdict, Verdict::converged);
    expect_found(f.material, truth);
  }
}

TEST(OwnForm, ObeysConstraintsByItsOwnNames) {
  Material truth = coat_material();
  truth.terms[0].shape[0] = {60, 60};
  const io::SampleTable table = samples_of(truth);
  FitOptions options = options_of(false);
  options.fix = {{"edge", {0.2, 0.6}}};
  options.bounds = {{"gloss", 0.1, 2}};
  options.start = {{"power", {50}}};
  expect_found(fit(table, {{coat{}}}, options).ranking.front().material, truth);
  options.fix = {{"power", {60}}, {"body", {0.3, 0.1}}, {"gloss", {0.8, 0.5}}};
  options.bounds = {{"edge", 0.1, 0.7}};
  options.start.clear();
  expect_found(fit(table, {{coat{}}}, options).ranking.front().material, truth);
}

TEST(OwnForm, TakesPartInSums) {
  Material truth = make_material(*find_form("lambert"), {"r", "g"});
  truth.terms[0].weights = {{0.3}, {0.4}};
  truth.terms.push_back(coat_material().terms[0]);
  truth.terms[1].shape[0] = {60, 60};
  for (auto& weights : truth.terms[1].weights) weights[2] = 0;  // the first term has the diffuse part
  const FormFit f =
      fit(samples_of(truth), {{*find_form("lambert"), coat{}}}, options_of(false)).ranking.front();
  EXPECT_EQ(f.verdict, Verdict::converged);
  EXPECT_NEAR(f.material.terms[0].weights[1][0], 0.4, 1e-7);
  EXPECT_NEAR(f.material.terms[1].shape[0][0], 60, 1e-4);
  EXPECT_EQ(f.material.terms[1].weights[0][2], 0);
}

// The lobe is symmetric about skew = 1/2, so that every minimum has a twin.
template <class T>
struct Skew {
  T skew;
  static constexpr auto fields() {
    return std::array{Field{&Skew::skew, ParameterInfo{"skew", 0, 1, 0.5, 1, "", false, "side of the lobe"}}};
  }
};

struct two_sided : Takes<LobeWeights, Skew> {
  static constexpr std::string_view name = "two_sided", family = "two_sided";
  static constexpr NoViolations violations{};
  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S side = shape.skew - S(0.5);
    return {S(1 / kPi), math::exp((S(2) + S(400) * (side * side)) * S(log_cos_h(g)))};
  }
};

TEST(OwnForm, TwoMinimaOfOneCostAreTwoAndSaidSo) {
  Material truth = make_material(two_sided{}, {"f"});
  truth.terms[0].shape[0] = {0.2};
  const FormFit f =
      fit(measured(truth, {"hemisphere"}, 0.05), {{two_sided{}}}, options_of(false)).ranking.front();
  ASSERT_EQ(f.minima.size(), 2u);
  EXPECT_NEAR(f.minima[0].cost / f.minima[1].cost, 1, 1e-9);
  EXPECT_NEAR(f.minima[0].material.terms[0].shape[0][0] + f.minima[1].material.terms[0].shape[0][0], 1, 1e-5);
  EXPECT_TRUE(f.findings.back().starts_with("another local minimum has the same cost: skew 0."))
      << f.findings.back();
}

// Constant values do not depend on the width. All starting points end in the same minimum, wherever the
// width ends.
TEST(OwnForm, AValleyIsOneMinimum) {
  const Material white = make_material(*find_form("lambert"), {"f"});
  const FormFit f = fit_one(measured(white, {"hemisphere"}, 0.05), {"ward"}, options_of(false));
  for (std::size_t k = 1; k < f.minima.size(); ++k)
    EXPECT_GT(f.minima[k].cost, (1 + 1e-6) * f.minima[0].cost);
}

// The f0 of this model divides the lobes of two weights, so that no choice of lobe weights determines which
// lobe the f0 belongs to.
class Undetermined final : public ReflectanceModel {
 public:
  Undetermined() {
    info_.name = info_.family = "undetermined";
    info_.weights = kWeights;
    info_.lobes = kLobes;
  }
  const ReflectanceInfo& info() const override { return info_; }
  using ReflectanceModel::eval;
  void eval(const ParameterValues<double>&, const Directions<double>& d, double* out) const override {
    std::fill(out, out + d.count, 0.0);
  }

 private:
  static constexpr std::array kWeights{kDiffuseInfo, kSpecularInfo,
                                       ParameterInfo{"f0", 0, 1, 0.04, 1, "", false, "f0", Role::f0}};
  static constexpr std::array kLobes{LobeWeight{0, LobeWeight::Factor::rest},
                                     LobeWeight{1, LobeWeight::Factor::f0}};
  ReflectanceInfo info_;
};

TEST(OwnForm, WhoseWeightsDoNotFollowFromItsLobesIsRefused) {
  const Reflectance undetermined{std::make_shared<Undetermined>()};
  EXPECT_THROW(Model({undetermined}, {"f"}, {}), InputError);
}

}  // namespace
}  // namespace brdf::fit
