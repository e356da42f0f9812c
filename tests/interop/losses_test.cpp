// ctest: interop.largest label=interop timeout=7200 env=BRDF_THOROUGH=1 needs=plain @tests@/test_interop --gtest_filter=Largest.*
// Tests the stated losses: a search finds them, they are measured in the way in which the users of the
// files read them, and a refit never increases them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <tuple>

#include "brdf/random.h"
#include "interop/pbrt_colour.h"
#include "interop/programs.h"
#include "interop/read_back.h"
#include "interop/rgl.h"
#include "io/files/content.h"
#include "io/files/temporary.h"
#include "io/formats/merl.h"
#include "io/material/material_json.h"
#include "io/material/settings.h"
#include "io/samples/degrees.h"

namespace brdf::interop {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Material chosen(const std::string& form, const std::vector<std::string>& set) {
  return io::choose_material({.form = form, .set = set});
}
Exported written(const char* program, const Material& m, bool naive = false) {
  return export_to(*find_program(program), m, "thing", naive);
}

// A rough wood with a faint wide lobe, a smooth varnish, a brushed metal, and a paint with a coloured lobe.
std::vector<Material> subjects() {
  return {chosen("cook_torrance", {"kd=0.21,0.09,0.05", "ks=0.35", "f0=0.03", "alpha=0.32"}),
          chosen("cook_torrance", {"kd=0.05,0.02,0.02", "ks=0.9", "f0=0.045", "alpha=0.06"}),
          chosen("cook_torrance", {"kd=0", "ks=1", "f0=0.85,0.7,0.55", "alpha_x=0.35", "alpha_y=0.12"}),
          chosen("cook_torrance", {"kd=0.12", "ks=0.5,0.35,0.15", "f0=0.4", "alpha=0.28"})};
}

// Returns the largest difference on a grid that avoids all directions of the search's own grid and is about
// ten times as dense.
double densest(const Material& wanted, const Material& carried, double step) {
  const bool turned = is_anisotropic(wanted);
  double worst = 0;
  for (double phi_i = turned ? 0.7 : 0; phi_i < (turned ? 180 : 1); phi_i += turned ? 17 : 1)
    for (double theta_i = 0.3 * step; theta_i <= 80; theta_i += step) {
      io::SampleTable row;
      for (double theta_o = 0.3 * step; theta_o <= 80; theta_o += step)
        for (double phi = 0.4; phi < (turned ? 360 : 180.5); phi += 1.9)
          row.add_directions(theta_i, phi_i, theta_o, phi_i + phi);
      const DirectionArrays<double> directions = io::unit_directions(row);
      const auto f = values_at(wanted, directions.view()), g = values_at(carried, directions.view());
      worst = std::max(worst, figures_of(f, g, directions.view()).largest);
    }
  return worst;
}

// Returns four materials. With BRDF_THOROUGH it adds every material of the data folder and every form at
// its defaults.
std::vector<Material> many_subjects() {
  std::vector<Material> all = subjects();
  if (!std::getenv("BRDF_THOROUGH")) return all;
  for (const auto& file : std::filesystem::directory_iterator(BRDF_SOURCE_DIR "/data/materials"))
    if (file.path().extension() == ".json") all.push_back(io::read_material(file.path().string()));
  for (const Reflectance& form : catalogue()) all.push_back(make_material(form));
  return all;
}

TEST(Largest, IsNotExceededOnADenserGrid) {
  const bool thorough = std::getenv("BRDF_THOROUGH") != nullptr;
  int written_ones = 0;
  for (const Program& program : programs())
    for (const Material& m : many_subjects()) {
      Exported e;
      try {
        e = export_to(program, m, "thing", !thorough);
      } catch (const InputError&) {
        continue;  // refused: other tests check this
      }
      ++written_ones;
      const double found = densest(m, e.carried, thorough ? 1.3 : 3.7);
      EXPECT_LE(found, 1.05 * e.loss.largest.difference + 1e-9) << program.name << ": " << in_words(e.loss);
      // The reported value must be an actual value in the reported direction.
      std::vector<double> f(m.channels.size()), g(f.size());
      const Largest& l = e.loss.largest;
      eval(m, io::unit_vector(l.theta_i, l.phi_i), io::unit_vector(l.theta_o, l.phi_o), f);
      eval(e.carried, io::unit_vector(l.theta_i, l.phi_i), io::unit_vector(l.theta_o, l.phi_o), g);
      const std::size_t c =
          std::size_t(std::ranges::find(e.carried.channels, l.channel) - e.carried.channels.begin());
      if (e.loss.none_found()) continue;
      ASSERT_LT(c, f.size());
      EXPECT_NEAR(f[c], l.wanted, 1e-12 * l.wanted);
      EXPECT_NEAR(g[c], l.carried, 1e-12 * std::abs(l.carried));
    }
  EXPECT_GE(written_ones, thorough ? 320 : 28);
}

// The search must notice a difference at one azimuth and a value that is not a number. Nothing else
// differs, so that the loss would otherwise be "exact".
TEST(Largest, SeesOneAzimuthAndWhatIsNoNumber) {
  const auto constant = [](const Vec3<double>&, const Vec3<double>&, std::span<double> f) { f[0] = 0.1; };
  const auto brighter = [](const Vec3<double>& wi, const Vec3<double>&, std::span<double> f) {
    f[0] = wi.y > 0.5 ? 0.2 : 0.1;
  };
  const auto no_number = [](const Vec3<double>& wi, const Vec3<double>&, std::span<double> f) {
    f[0] = wi.z < 0.5 ? std::nan("") : 0.1;
  };
  const AlbedoOptions coarse{.tolerance = 0.1, .max_evaluations = 2000};
  const Comparison comparison(material_of(constant, {"f"}), coarse);
  EXPECT_TRUE(comparison.loss_of(material_of(constant, {"f"})).none_found());
  const Loss turned = comparison.loss_of(material_of(brighter, {"f"}));
  EXPECT_FALSE(turned.none_found());
  EXPECT_NEAR(turned.largest.difference, 0.1 / (0.1 + kDark), 1e-12);
  EXPECT_FALSE(comparison.loss_of(material_of(no_number, {"f"})).none_found());
  EXPECT_EQ(relative_difference(-kDark, 0), 0.5);
}

TEST(Largest, IsAtGrazingLightWhereNoEvenGridHasIt) {
  const Material wood = subjects()[0];
  const Loss loss = written("gltf", wood, true).loss;
  EXPECT_NEAR(loss.largest.theta_i, 80, 1);
  EXPECT_NEAR(loss.largest.theta_o, 80, 1);
  EXPECT_THAT(in_words(loss), HasSubstr("largest at least"));
}

// The weight of a lobe is written as the share specularFactor, and its colour as specularColorFactor.
TEST(Gltf, HoldsTheLobesWeightAndColour) {
  const Exported plain = written(
      "gltf", chosen("cook_torrance", {"kd=0.2,0.05,0.02", "ks=0.45", "f0=0.042", "alpha=0.02"}), true);
  EXPECT_THAT(plain.text, HasSubstr("\"specularFactor\": 0.45"));
  EXPECT_THAT(plain.text, Not(HasSubstr("specularColorFactor")));
  EXPECT_LT(plain.loss.median, 0.03);
  const Exported coloured = written("gltf", subjects()[3]);
  EXPECT_THAT(coloured.text, HasSubstr("specularColorFactor"));
  EXPECT_LT(coloured.loss.median, 0.05);
  EXPECT_GT(coloured.loss.rms, 1e-4);
}

// KHR_materials_anisotropy: V = clamp(0.5/(N.L |(at T.V, ab B.V, N.V)| + N.V |(at T.L, ab B.L, N.L)|), 0,
// 1).
TEST(Gltf, OfTwoWidthsIsHeldWhereTheExtensionHoldsIt) {
  const double at = 0.28, ab = 0.09;
  const Material source = chosen("cook_torrance", {"kd=0", "ks=1", "f0=0.8", "alpha_x=0.28", "alpha_y=0.09"});
  const Exported e = written("gltf", source, true);
  EXPECT_FALSE(e.loss.none_found());
  for (const auto& [theta, phi] : {std::pair{74.0, 0.0}, {68.0, 90.0}, {35.0, 0.0}}) {
    const Vec3<double> l = io::unit_vector(theta, phi), v = io::unit_vector(theta, phi + 180);
    const auto length = [&](const Vec3<double>& w) { return std::hypot(at * w.x, ab * w.y, w.z); };
    const double free = 0.5 / (l.z * length(v) + v.z * length(l)), held = std::min(free, 1.0);
    const double d = 1 / (kPi * at * ab), cos_d = l.z;  // along the normal
    const double fresnel = 0.8 + 0.2 * std::pow(1 - cos_d, 5);
    double f = 0, exact = 0;
    eval(e.carried, l, v, {&f, 1});
    eval(source, l, v, {&exact, 1});
    EXPECT_NEAR(f, d * held * fresnel, 1e-9 * f);
    EXPECT_NEAR(exact, d * free * fresnel, 1e-9 * exact);
  }
  EXPECT_TRUE(
      written("gltf", chosen("cook_torrance", {"kd=0", "ks=1", "f0=0.8", "alpha=0.09"})).loss.none_found());
  EXPECT_FALSE(written("three", source, true).loss.largest.difference > 1);  // three.js does not clamp V
}

TEST(Pbrt, ShowsSpectraOfColouredIndices) {
  const ColourSpectrum spectrum({0.21, 0.6, 1.4});
  EXPECT_LT(spectrum.residual(), 1e-9);
  const Exported gold = written("pbrt", chosen("cook_torrance_conductor", {"kd=0", "ks=1", "n=0.18,0.42,1.37",
                                                                           "k=3.42,2.35,1.77", "alpha=0.2"}));
  EXPECT_FALSE(gold.loss.none_found());
  EXPECT_THAT(gold.text, Not(HasSubstr(": exact")));
  // The values of the form differ from the values of the program.
  EXPECT_THAT(gold.text, Not(HasSubstr("the same values in brdf")));
  EXPECT_THAT(gold.text, HasSubstr("by channel, without the spectra of the program: brdf eval --form"));
  const Exported grey =
      written("pbrt", chosen("cook_torrance_conductor", {"kd=0.1", "ks=0.6", "n=1.1", "k=6", "alpha=0.2"}));
  EXPECT_TRUE(grey.loss.none_found());
  EXPECT_THAT(grey.text, HasSubstr("the same values in brdf: brdf eval --form"));
  // In a yellow metal, the red index is nearly pure extinction. With the program's spectra its red is one
  // eighth brighter along the normal than by channel.
  Material yellow = make_material(find_program("pbrt")->targets[0].target, {"r", "g", "b"});
  Term& term = yellow.terms[0];
  const std::array n{0.0087, 0.505, 1.60}, k{9.8, 2.28, 1.80};
  term.shape.clear();
  for (std::size_t c = 0; c < 3; ++c) {
    term.weights[c] = {0, 1};
    term.shape.push_back({0.2, 0.2, n[c], k[c]});
  }
  std::vector<double> by_channel(3), shown(3);
  const Vec3<double> up{0, 0, 1};
  eval(yellow, up, up, by_channel);
  eval(shown_by_pbrt(yellow), up, up, shown);
  const std::array expected{0.124, 0.009, 0.027};
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(shown[c] / by_channel[c] - 1, expected[c], 0.002) << c;
}

// Mitsuba takes the indices of each colour directly. The other programs hold the reflectance along the
// normal of each colour.
TEST(Conductors, OfAnIndexPerColourAreWrittenByEveryProgram) {
  const Material copper =
      chosen("cook_torrance_conductor", {"kd=0", "ks=1", "n=0.25,0.95,1.2", "k=3.4,2.6,2.4", "alpha=0.25"});
  for (const Program& program : programs()) {
    const Exported e = export_to(program, copper, "copper", true);
    EXPECT_LT(e.loss.rms, 0.12) << program.name;
    std::vector<double> f(3), g(3);
    const Vec3<double> up{0, 0, 1};
    eval(copper, up, up, f);
    eval(e.carried, up, up, g);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(g[c] / f[c], 1, 0.12) << program.name << " " << c;
  }
  const Material dull =
      chosen("cook_torrance_conductor", {"kd=0", "ks=1", "n=3.4,2.7,2.1", "k=2.6,2.7,2.4", "alpha=0.25"});
  EXPECT_THAT(written("mitsuba", dull).text, HasSubstr("<rgb name=\"eta\" value="));
}

Material coated() {
  Material m = chosen("cook_torrance", {"kd=0.25,0.1,0.06", "ks=0.3", "f0=0.05", "alpha=0.35"});
  m.terms.push_back(chosen("cook_torrance", {"kd=0", "ks=0.2", "f0=0.9,0.7,0.6", "alpha_x=0.2",
                                             "alpha_y=0.08", "tangent_phi=25"})
                        .terms[0]);
  m.terms.back().weights.resize(3, m.terms.back().weights[0]);
  return m;
}

TEST(Sums, OfTwoLobesAreTheSumOfTheirParts) {
  Material two = coated();
  for (const Program& program : programs()) {
    if (!program.adds) {
      try {
        export_to(program, two, "two", true);
        ADD_FAILURE() << program.name << " does not refuse";
      } catch (const Refused& e) {
        EXPECT_THAT(e.what(), HasSubstr("one lobe in addition to the diffuse part"));
      }
      continue;
    }
    if (program.name == "mitsuba" || program.name == "pbrt") two.terms[1].tangent_phi = {};
    const Exported e = export_to(program, two, "two", true);
    EXPECT_EQ(e.words.size(), 2u) << program.name;
    EXPECT_THAT(e.text, HasSubstr(", term 2 of a sum of 2: brdf eval --form"));
    EXPECT_THAT(e.text, Not(HasSubstr("| brdf eval")));  // no single command evaluates the sum
    EXPECT_LT(e.loss.rms, 0.08) << program.name << in_words(e);
    two = coated();
  }
  EXPECT_TRUE(written("blender", two).loss.none_found());
}

// Shares of nested mixes: a for the second material, 1 - a for the first.
TEST(Sums, ArePbrtsNestedMixes) {
  Material two = coated();
  two.terms[1].tangent_phi = {};
  const Exported e = written("pbrt", two, true);
  std::vector<double> amounts;
  for (std::size_t at = 0; (at = e.text.find("float amount\" [ ", at)) != e.text.npos;)
    amounts.push_back(std::stod(e.text.substr(at += 16)));
  ASSERT_EQ(amounts.size(), 2u);
  const int ks = info(e.carried.terms[0].form).weight_index(Role::specular);
  // The second lobe has a share of the whole; the first lobe has a share of the remainder.
  EXPECT_NEAR(amounts[1], e.carried.terms[1].weights[0][std::size_t(ks)], 1e-8);
  EXPECT_NEAR(amounts[0] * (1 - amounts[1]), e.carried.terms[0].weights[0][std::size_t(ks)], 1e-8);
  EXPECT_THAT(e.text, HasSubstr("MakeNamedMaterial \"thing\"\n    \"string type\" \"mix\""));
}

// Following the advice must give the material: dp/du laid at the stated angle, and tangent_phi 0.
TEST(Advice, OnTheTangentGivesTheMaterialWhenItIsFollowed) {
  for (const auto& [along, across, phi] : {std::tuple{0.11, 0.31, -37.0}, {0.33, 0.12, 62.0}})
    for (const char* program : {"mitsuba", "pbrt"}) {
      const auto at = [&](double tangent) {
        return chosen("cook_torrance_conductor",
                      {"kd=0", "ks=1", "n=1.2", "k=7", "alpha_x=" + std::to_string(along),
                       "alpha_y=" + std::to_string(across), "tangent_phi=" + std::to_string(tangent)});
      };
      double angle = 0;
      try {
        written(program, at(phi));
        ADD_FAILURE() << program << " does not refuse";
      } catch (const Refused& e) {
        const std::string said = e.what(), before = "orient dp/du at ";
        ASSERT_THAT(said, HasSubstr(before));
        angle = std::stod(said.substr(said.find(before) + before.size()));
      }
      const Exported e = written(program, at(0), true);
      Material turned = e.carried;
      for (Term& term : turned.terms)
        term.tangent_phi = radians(term.tangent_phi.radians() + angle * kPi / 180);
      double f = 0, g = 0;
      const Vec3<double> wi = io::unit_vector(40, -37), wo = io::unit_vector(58, 141);
      eval(at(phi), wi, wo, {&f, 1});
      eval(turned, wi, wo, {&g, 1});
      // For Mitsuba, the separable masking remains.
      EXPECT_NEAR(g / f, 1, std::string(program) == "mitsuba" ? 6e-5 : 1e-12) << program << " " << angle;
    }
}

// Mitsuba masks both directions separately, which shows near grazing only. A search up to 80 degrees that
// finds nothing is no proof.
TEST(Largest, IsLookedForBeyondTheSearchBeforeFormulasAreCalledAlike) {
  const Exported thin =
      written("mitsuba", chosen("cook_torrance_dielectric", {"kd=0", "ks=1", "eta=5", "alpha=0.001"}));
  ASSERT_TRUE(thin.loss.none_found());
  EXPECT_FALSE(thin.is_same);
  EXPECT_THAT(thin.text, Not(HasSubstr(": exact")));
  EXPECT_THAT(thin.text, HasSubstr(": no difference above 1e-9 at "));
  EXPECT_THAT(thin.text, HasSubstr("of directions up to 80 degrees from the normal; beyond, at least "));
  EXPECT_GT(thin.loss.beyond->difference, 1e-3);
  // The form itself with its own parameters is exact.
  const Exported own = written("osl", chosen("ward", {"kd=0.2", "ks=0.3", "alpha=0.2"}));
  EXPECT_NE(own.is_same, own.text.find(": exact") == std::string::npos);
}

TEST(Tables, AreMeasuredAsTheirUsersReadThem) {
  const Material paint = chosen("cook_torrance", {"kd=0.3,0.2,0.1", "ks=1", "f0=0.05", "alpha=0.2"});
  const io::Content file{"paint.bsdf", rgl_of(paint, "paint", 400'000)};
  const Material table = read_back_rgl(file);
  const auto loss = loss_of_table(paint, table);
  ASSERT_TRUE(loss);
  EXPECT_FALSE(loss->none_found());
  EXPECT_GT(loss->largest.difference, 0.01);
  EXPECT_LT(loss->median, 0.02);
  EXPECT_LE(densest(paint, table, 5.3), 1.1 * loss->largest.difference) << in_words(*loss);
}

TEST(Tables, OfMerlAreReadByTheCell) {
  const Material paint = chosen("cook_torrance", {"kd=0.25,0.2,0.1", "ks=1", "f0=0.05", "alpha=0.22"});
  io::SampleTable cells;
  io::merl::add_cell_directions(cells);
  cells.channels = paint.channels;
  cells.values = values_at(paint, io::unit_directions(cells).view());
  cells.sigma.resize(3);
  const io::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "paint.binary";
  io::merl::write(path, cells);
  const Material table = read_back_merl(io::read_content(path));
  const auto loss = loss_of_table(paint, table);
  ASSERT_TRUE(loss);
  EXPECT_GT(loss->largest.difference, 0.02);
  EXPECT_LT(loss->median, 0.01);
  EXPECT_LE(densest(paint, table, 2.3), 1.05 * loss->largest.difference) << in_words(*loss);
}

TEST(Formulas, AreInFloat) {
  const Loss loss = Comparison(subjects()[0]).loss_of(in_float(subjects()[0]));
  EXPECT_GT(loss.rms, 1e-9);
  EXPECT_LT(loss.rms, 1e-6);
}

}  // namespace
}  // namespace brdf::interop
