// Noise-free truth is recovered for published and random parameter sets, from a hemisphere plus 1-degree
// steps in plane.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

#include "../samples.h"
#include "brdf/forms.h"
#include "fit/solve/minima.h"

namespace brdf::fit {
namespace {

constexpr double kConditionLimit = 1e4;
constexpr double kDigits = 1e-6;

io::SampleTable dense_samples(const Material& truth) {
  synth::Instrument instrument;
  instrument.grid.parts = {"hemisphere", "in_plane"};
  return synth::measure(truth, instrument);
}

// Returns sqrt((J'J)^-1_jj)/|p_j| of the log residual at the truth: first the shape, then the weights per
// channel.
std::vector<double> relative_conditions(const Material& truth, const io::SampleTable& table) {
  const FitData data = prepare(table, {});
  const Model model({truth.terms[0].form}, truth.channels, {});
  std::vector<double> p = model.initial();
  for (std::size_t s = 0; s < model.shape_slots(); ++s)
    p[s] = model.slots()[s].to_solver(truth.terms[0].shape[0][model.slots()[s].members[0]]);
  const bool schlick = model.terms()[0].info->weight_index("f0") >= 0;
  for (std::size_t c = 0; c < truth.channels.size(); ++c) {
    std::vector<double> w = truth.terms[0].weights[c];
    if (schlick) w = {w[0], w[1] * w[2], w[1] * (1 - w[2])};
    std::copy(w.begin(), w.end(), p.begin() + std::ptrdiff_t(model.terms()[0].weights[c].first_slot));
  }
  const NormalEquations n = SampleStream(data, model, {}, 0).normal_equations(p);
  const Eigen::Index size = Eigen::Index(p.size());
  Eigen::MatrixXd h = Eigen::Map<const Eigen::MatrixXd>(n.hessian.a.data(), size, size);
  Eigen::VectorXd scale(size);
  for (Eigen::Index k = 0; k < size; ++k) scale(k) = h(k, k) > 0 ? 1 / std::sqrt(h(k, k)) : 0;
  h = scale.asDiagonal() * h * scale.asDiagonal();
  for (Eigen::Index k = 0; k < size; ++k)
    if (scale(k) == 0) h(k, k) = 1e-30;  // without effect: infinitely uncertain
  const Eigen::MatrixXd inverse = h.completeOrthogonalDecomposition().pseudoInverse();
  const auto deviation = [&](const Eigen::VectorXd& g) {
    const Eigen::VectorXd x = scale.cwiseProduct(g);
    return std::sqrt(std::max(x.dot(inverse * x), 0.0));
  };
  std::vector<double> out;
  for (std::size_t s = 0; s < model.shape_slots(); ++s) {
    Eigen::VectorXd g = Eigen::VectorXd::Zero(size);
    g(Eigen::Index(s)) = model.slots()[s].slope(p[s]);
    out.push_back(deviation(g) / std::abs(truth.terms[0].shape[0][model.slots()[s].members[0]]));
  }
  for (std::size_t c = 0; c < truth.channels.size(); ++c) {
    const Eigen::Index first = Eigen::Index(model.terms()[0].weights[c].first_slot);
    const std::vector<double>& w = truth.terms[0].weights[c];
    for (std::size_t k = 0; k < w.size(); ++k) {
      Eigen::VectorXd g = Eigen::VectorXd::Zero(size);
      if (schlick && k == 1) {
        g(first + 1) = g(first + 2) = 1;
      } else if (schlick && k == 2) {
        g(first + 1) = (1 - w[2]) / w[1];
        g(first + 2) = -w[2] / w[1];
      } else {
        g(first + Eigen::Index(k)) = 1;
      }
      out.push_back(deviation(g) / std::abs(w[k]));
    }
  }
  return out;
}

std::vector<double> flat(const Material& m) {
  const Model model({m.terms[0].form}, m.channels, {});
  std::vector<double> out;
  for (std::size_t s = 0; s < model.shape_slots(); ++s)
    out.push_back(m.terms[0].shape[0][model.slots()[s].members[0]]);
  for (const auto& w : m.terms[0].weights) out.insert(out.end(), w.begin(), w.end());
  return out;
}

struct Tally {
  int sets = 0, parameters = 0, ill_conditioned = 0, wrong = 0;
  double worst = 0;
};

void check(const Material& truth, Tally& tally, const std::string& what) {
  const io::SampleTable table = dense_samples(truth);
  FitOptions options;
  options.cross_validation = false;
  const FormFit f = fit(table, {{truth.terms[0].form}}, options).ranking.front();
  const std::vector<double> condition = relative_conditions(truth, table), found = flat(f.material),
                            expected = flat(truth);
  ++tally.sets;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    ++tally.parameters;
    if (!(condition[k] < kConditionLimit)) {
      ++tally.ill_conditioned;
      continue;
    }
    const double error = std::abs(found[k] - expected[k]) / std::abs(expected[k]);
    tally.worst = std::max(tally.worst, error);
    if (error < kDigits) continue;
    ++tally.wrong;
    ADD_FAILURE() << what << ": parameter " << k << " is " << found[k] << ", truth " << expected[k]
                  << ", condition " << condition[k] << ", " << name_of(f.verdict) << ", " << f.solver_message;
  }
}

void print(const std::string& name, const Tally& t, int skipped) {
  std::cout << "[ recovery ] " << name << ": " << t.sets << " sets, " << t.parameters << " parameters, "
            << t.ill_conditioned << " ill-conditioned, " << t.wrong << " wrong, worst error " << t.worst
            << ", " << skipped << " sets outside the claim\n";
}

struct Form {
  std::string name;
};
std::vector<std::string> fittable_forms() {
  std::vector<std::string> names;
  for (const Reflectance& form : catalogue())
    if (form.info().fittable()) names.emplace_back(form.info().name);
  return names;
}

class RandomSets : public ::testing::TestWithParam<std::string> {};

TEST_P(RandomSets, AHundredComeBackToSixDigits) {
  const Reflectance form = *find_form(GetParam());
  std::mt19937_64 random(7);
  Tally tally;
  for (int k = 0; k < 100; ++k) {
    Material truth = random_material(form, random);
    check(truth, tally, GetParam() + " set " + std::to_string(k));
  }
  print(GetParam(), tally, 0);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(tally.parameters - tally.ill_conditioned, 0);
}
INSTANTIATE_TEST_SUITE_P(Slow, RandomSets, ::testing::ValuesIn(fittable_forms()),
                         [](const auto& p) { return p.param; });

std::vector<std::vector<std::string>> rows_of(const std::string& file) {
  std::ifstream in(std::string(std::getenv("BRDF_DATA_DIR")) + "/tables/" + file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    rows.push_back(cells);
  }
  rows.erase(rows.begin());
  return rows;
}

// Maps the name of a published parameter set to the form that it belongs to. published_material() converts
// the numbers (conventions: Ngan 2005, Loew 2012).
struct Mapping {
  const char* set;
  const char* form;
};
constexpr Mapping kMappings[] = {{"ngan_ward", "ward"},
                                 {"ngan_wardduer", "ward_duer"},
                                 {"ngan_blinnphong", "blinn_phong_unnormalised"},
                                 {"low_cooktorrance_E1", "cook_torrance_vcavity"},
                                 {"low_cooktorrance_E2", "cook_torrance_vcavity"}};

Material published_material(const std::vector<std::string>& row, const Mapping& mapping) {
  Material m = make_material(*find_form(mapping.form));
  const bool ngan = row[0].starts_with("ngan");
  const double scale[3] = {1, ngan ? 1.15 : 1, ngan ? 1.66 : 1};
  const double shape = std::stod(row[9]);
  for (std::size_t c = 0; c < 3; ++c) {
    double kd = std::stod(row[2 + c]) * scale[c], ks = std::stod(row[5 + c]) * scale[c];
    if (std::string(mapping.form) == "blinn_phong_unnormalised")
      kd /= kPi, ks *= (shape + 2) / (2 * kPi);
    else if (!ngan)
      ks *= 4;
    m.terms[0].weights[c] = {kd, ks};
  }
  auto& s = m.terms[0].shape[0];
  s[0] = shape;
  if (s.size() > 1) s[1] = shape;
  if (s.size() > 2) s[2] = std::stod(row[11]);
  return m;
}

bool in_range(const Material& m) {
  const ReflectanceInfo& f = info(m.terms[0].form);
  for (std::size_t k = 0; k < f.shape.size(); ++k) {
    const double v = m.terms[0].shape[0][k];
    if (f.shape[k].name.starts_with("alpha") && v < 0.02) return false;
    if (f.shape[k].name == "exponent" && std::sqrt(2 / (v + 2)) < 0.02) return false;
    if (!(v >= f.shape[k].min && v <= f.shape[k].max)) return false;
  }
  for (const auto& w : m.terms[0].weights)
    for (double v : w)
      if (!(v > 0 && v <= kWeightMax)) return false;
  return true;
}

TEST(Published, MerlFitsComeBackToSixDigits) {
  if (!std::getenv("BRDF_DATA_DIR")) GTEST_SKIP() << "BRDF_DATA_DIR is unset: no published fits";
  const auto rows = rows_of("published_merl_fits.csv");
  for (const Mapping& mapping : kMappings) {
    Tally tally;
    int skipped = 0;
    for (const auto& row : rows) {
      if (row[0] != mapping.set) continue;
      const Material truth = published_material(row, mapping);
      if (!in_range(truth)) {
        ++skipped;
        continue;
      }
      check(truth, tally, row[0] + " " + row[1]);
    }
    print(mapping.set, tally, skipped);
    EXPECT_GT(tally.sets, 0);
    EXPECT_EQ(tally.wrong, 0);
  }
}

TEST(Published, WardPairsComeBackToSixDigits) {
  if (!std::getenv("BRDF_DATA_DIR")) GTEST_SKIP() << "BRDF_DATA_DIR is unset: no Ward pairs";
  double worst = 0;
  int sets = 0;
  for (const char* file : {"ward1992_table1.csv", "ward_latex_presets_alpha.csv"})
    for (const auto& row : rows_of(file)) {
      const bool weights = row.size() > 3;
      Material truth = make_material(*find_form("ward"), {"f"});
      truth.terms[0].shape[0] = {std::stod(row[weights ? 3 : 1]), std::stod(row[weights ? 4 : 2])};
      truth.terms[0].weights[0] = {weights ? std::stod(row[1]) : 0.3, weights ? std::stod(row[2]) : 0.05};
      synth::Instrument instrument;
      instrument.grid.parts = {"hemisphere", "in_plane"};
      instrument.grid.azimuths = {0, 45, 90, 135};
      instrument.grid.theta_i = {10, 30, 50, 70};
      FitOptions options;
      options.cross_validation = false;
      options.anisotropic = truth.terms[0].shape[0][0] != truth.terms[0].shape[0][1];
      const FormFit f = fit_one(synth::measure(truth, instrument), {"ward"}, options);
      ++sets;
      const double error =
          std::max(largest_relative_difference(f.material.terms[0].shape[0], truth.terms[0].shape[0]),
                   largest_relative_difference(f.material.terms[0].weights[0], truth.terms[0].weights[0]));
      worst = std::max(worst, error);
      EXPECT_LT(error, kDigits) << row[0];
    }
  std::cout << "[ recovery ] Ward pairs: " << sets << " sets, worst error " << worst << '\n';
  EXPECT_EQ(sets, 28);
}

}  // namespace
}  // namespace brdf::fit
