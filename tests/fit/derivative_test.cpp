// Tests the derivatives that the solver uses, and a fit that takes the aperture into account.
#include <random>

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "brdf/forms.h"
#include "fit/model/lobe_columns.h"
#include "fit/solve/minima.h"
#include "samples.h"

namespace brdf::fit {
namespace {

// Compares the solver's derivatives, which come from Dual in batches, with the independent implementation
// ceres::Jet.
template <class F>
double worst_against_jets(F form) {
  constexpr int n = int(parameter_count<typename F::template Shape<double>>);
  using Jet = ceres::Jet<double, n == 0 ? 1 : n>;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform;
  DirectionArrays<double> pairs(kBlockRows);
  for (std::size_t j = 0; j < kBlockRows; ++j)
    pairs.set(j, direction(radians(1.4 * uniform(random)), radians(6.28 * uniform(random))),
              direction(radians(1.4 * uniform(random)), radians(6.28 * uniform(random))));
  double worst = 0;
  for (int repeat = 0; repeat < 5; ++repeat) {
    const Material m = random_material(form, random, 1, false);
    LobeColumns block(form);
    block.evaluate(m.terms[0].shape[0], {}, n == 0 ? Partial::none : Partial::shape, pairs.view(), {});
    std::vector<Jet> values;
    for (int k = 0; k < n; ++k) values.emplace_back(m.terms[0].shape[0][std::size_t(k)], k);
    const auto shape = from_values<typename F::template Shape<Jet>>(std::span<const Jet>(values));
    for (std::size_t j = 0; j < kBlockRows; ++j) {
      const auto d = pairs.view();
      const auto lobes = F::lobes(shape, geometry(d.wi(j), d.wo(j)));
      for (std::size_t k = 0; k < lobes.size(); ++k) {
        const double size = std::abs(lobes[k].a) + lobes[k].v.norm();
        if (size < 1e-12) continue;
        worst = std::max(worst, std::abs(block.lobe(k)[j] - lobes[k].a) / size);
        for (int p = 0; p < n; ++p)
          worst = std::max(worst, std::abs(block.derivative(k, std::size_t(p))[j] - lobes[k].v[p]) / size);
      }
    }
  }
  return worst;
}

TEST(Derivatives, OfEveryFormEqualJets) {
  for_each_form([](auto form) {
    if constexpr (LinearForm<decltype(form)>) {
      EXPECT_LT(worst_against_jets(form), 1e-12) << form.name;
    }
  });
}

// Compares the gradient of the streamed cost with central differences of the cost, for every residual and
// loss.
TEST(Derivatives, OfTheCostEqualDifferences) {
  Material truth = make_material(*find_form("oren_nayar"));
  truth.terms.push_back(make_term(*find_form("cook_torrance"), 3));
  const io::SampleTable table = measured(truth, {"hemisphere"}, 0.1);
  FitOptions options;
  options.anisotropic = true;
  for (Metric metric : {Metric::log, Metric::cosine_l2, Metric::log_relative})
    for (auto loss : {LossFunction::Kind::none, LossFunction::Kind::huber, LossFunction::Kind::cauchy,
                      LossFunction::Kind::cube_root}) {
      options.metric = metric;
      const FitData data = prepare(table, options);
      const Model model(forms({"oren_nayar", "cook_torrance"}), data.channels, options);
      const SampleStream stream(data, model, {metric, {loss, 0.05}}, 0);
      std::vector<double> p = model.initial();
      for (std::size_t k = 0; k < model.shape_slots(); ++k) p[k] += 0.1 * double(k);
      for (std::size_t k = model.shape_slots(); k < p.size(); ++k) p[k] = 0.2 + 0.01 * double(k);
      const NormalEquations n = stream.normal_equations(p);
      for (std::size_t k = 0; k < p.size(); ++k) {
        const double h = 1e-5;
        std::vector<double> q = p;
        q[k] = p[k] + h;
        const double above = stream.normal_equations(q).cost;
        q[k] = p[k] - h;
        const double slope = (above - stream.normal_equations(q).cost) / (2 * h);
        EXPECT_NEAR(n.gradient[k], slope, 1e-5 * (std::abs(slope) + n.cost))
            << int(metric) << " " << int(loss) << " " << model.slots()[k].name;
      }
    }
}

TEST(Aperture, AFitThatKnowsItFindsTheTruth) {
  Material truth = make_material(*find_form("ward"), {"f"});
  truth.terms[0].shape[0] = {0.05, 0.05};
  synth::Instrument instrument;
  instrument.grid.parts = {"in_plane"};
  instrument.grid.theta_i = {20, 40, 60};
  instrument.aperture = 3;
  const io::SampleTable table = synth::measure(truth, instrument);
  FitOptions options;
  options.cross_validation = false;
  const double blurred = fit_one(table, {"ward"}, options).material.terms[0].shape[0][0];
  options.aperture = 3;
  const double sharp = fit_one(table, {"ward"}, options).material.terms[0].shape[0][0];
  EXPECT_NEAR(sharp, 0.05, 5e-5);
  EXPECT_GT(std::abs(blurred - 0.05), 20 * std::abs(sharp - 0.05));
}

}  // namespace
}  // namespace brdf::fit
