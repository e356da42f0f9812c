// Compares the noise that is estimated from a table with the noise that was added to it.
#include "io/samples/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <tuple>

#include "brdf/forms.h"
#include "io/csv/csv.h"
#include "io/files/numbers.h"
#include "io/files/temporary.h"
#include "synth/instrument.h"

namespace brdf::synth {
namespace {

enum class Pattern { light, viewer, both, in_plane, hemisphere, light_over_hemisphere, half_hemisphere };
constexpr int kPatterns = 7;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (double(random_() >> 11) * 0x1p-53); }
  double by_ratio(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  std::size_t below(std::size_t n) { return random_() % n; }

 private:
  std::mt19937_64 random_;
};

Material drawn_material(Draw& draw) {
  std::vector<Reflectance> forms;
  for (const Reflectance& form : catalogue())  // random weights of a basis may give a negative f
    if (info(form).fittable() && !info(form).basis && !info(form).about_light) forms.push_back(form);
  const Reflectance& form = forms[draw.below(forms.size())];
  const ReflectanceInfo& f = info(form);
  Material m = make_material(
      form, draw.below(3) ? std::vector<std::string>{"f"} : std::vector<std::string>{"r", "g", "b"});
  const double alpha = draw.by_ratio(0.02, 0.6);
  for (std::size_t k = 0; k < f.shape.size(); ++k) {
    const ParameterInfo& p = f.shape[k];
    double& value = m.terms[0].shape[0][k];
    if (p.name.starts_with("alpha"))
      value = draw.below(6) ? alpha : draw.by_ratio(0.02, 0.6);  // one in six has a width of its own
    else if (p.name == "exponent")
      value = 2 / (alpha * alpha);
    else if (p.name != "tangent_phi")
      value = draw.uniform(p.min, p.usual_max);
  }
  for (auto& weights : m.terms[0].weights)
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const std::string_view name = f.weights[k].name;
      weights[k] = name == "f0" ? draw.uniform(0.02, 0.9) : draw.uniform(name == "kd" ? 0.02 : 0.05, 1);
    }
  return m;
}

// Returns the directions of one scan of an instrument.
io::SampleTable scan(Pattern pattern, Draw& draw) {
  io::SampleTable t;
  const double step = draw.below(2) ? 1 : 2, apart = 10 + 2 * double(draw.below(4));
  const auto angles = [](double first, double by) {
    std::vector<double> list;
    for (double x = first; x <= 80; x += by) list.push_back(x);
    return list;
  };
  const std::vector<double> fine = angles(1, step), few = angles(10, apart);
  switch (pattern) {
    case Pattern::light:
      for (const double viewer : few)
        for (const double light : fine) t.add_directions(light, 180, viewer, 0);
      break;
    case Pattern::viewer:
      for (const double light : few)
        for (const double viewer : fine) t.add_directions(light, 180, viewer, 0);
      break;
    case Pattern::both:
      for (const double light : angles(5, 2.5 * step))
        for (const double viewer : angles(5, 2.5 * step)) t.add_directions(light, 180, viewer, 0);
      break;
    case Pattern::in_plane:
      return make_grid({.parts = {"in_plane"}, .theta_i = few, .step = step});
    case Pattern::hemisphere:
      return make_grid({.theta_i = few, .step = 5 * step});
    case Pattern::light_over_hemisphere:
      for (const double viewer : {0.0, 20.0, 40.0, 60.0})
        for (const double light : angles(5, 5))
          for (int azimuth = 0; azimuth < 360; azimuth += 10) t.add_directions(light, azimuth, viewer, 0);
      break;
    case Pattern::half_hemisphere:
      for (const double light : few)
        for (const double viewer : angles(5, 5))
          for (int azimuth = 0; azimuth <= 180; azimuth += 10) t.add_directions(light, 180, viewer, azimuth);
  }
  return t;
}

struct Case {
  io::SampleTable table;
  double noise;
  std::string words;
};

Case drawn_case(int number, const std::filesystem::path& folder) {
  Draw draw(std::uint64_t(number) + 1);
  const auto pattern = Pattern(number % kPatterns);
  io::SampleTable directions = scan(pattern, draw);
  const std::filesystem::path file = folder / "directions.csv";
  io::write_samples(file, directions);
  const Material material = drawn_material(draw);
  Instrument instrument;
  instrument.grid.parts = {file.string()};
  instrument.noise = draw.uniform(0.01, 0.05);
  instrument.seed = std::uint64_t(number) + 1;
  return {measure(material, instrument), instrument.noise,
          "table " + std::to_string(number) + ", pattern " + std::to_string(number % kPatterns) + ", " +
              std::string(info(material.terms[0].form).name)};
}

TEST(Noise, IsFoundWithinAFactorOfOneAndAHalfWhateverWasScanned) {
  const io::TemporaryFolder folder;
  std::vector<double> ratios;
  for (int number = 0; number < 200; ++number) {
    const Case c = drawn_case(number, folder.path());
    const io::Noise noise = io::relative_noise(c.table);
    ASSERT_TRUE(noise.value.has_value()) << c.words;
    ratios.push_back(*noise.value / c.noise);
    EXPECT_GT(ratios.back(), 1 / 1.5) << c.words << ", " << c.table.rows() << " rows";
    EXPECT_LT(ratios.back(), 1.5) << c.words << ", " << c.table.rows() << " rows";
  }
  EXPECT_NEAR(io::median(ratios), 1, 0.05);  // no bias
}

Instrument hemisphere(double noise) {
  Instrument instrument;
  instrument.grid.theta_i = {10, 30, 50, 70};
  instrument.noise = noise;
  return instrument;
}

Material gloss(std::vector<std::string> channels) {
  return make_material(*find_form("cook_torrance"), std::move(channels));
}

TEST(Noise, IsThatOfEachChannel) {
  io::SampleTable t = measure(gloss({"a", "b"}), hemisphere(0.01));
  const io::SampleTable other = measure(gloss({"a", "b"}), hemisphere(0.04));
  t.values[1] = other.values[1];
  const io::Noise noise = io::relative_noise(t);
  ASSERT_TRUE(noise.channels[0] && noise.channels[1]);
  EXPECT_NEAR(*noise.channels[0], 0.01, 0.0015);
  EXPECT_NEAR(*noise.channels[1], 0.04, 0.006);
  EXPECT_GT(*noise.value, *noise.channels[0]);
  EXPECT_LT(*noise.value, *noise.channels[1]);
}

TEST(Noise, DoesNotDependOnTheOrderOfRows) {
  Instrument instrument = hemisphere(0.03);
  instrument.grid.step = 1.5;  // more rows of one kind of scan than are used
  const io::SampleTable t = measure(gloss({"f"}), instrument);
  ASSERT_GT(t.rows(), 12000u);
  std::vector<std::uint32_t> rows(t.rows());
  std::iota(rows.begin(), rows.end(), 0u);
  const double sorted = io::relative_noise(t, rows).value.value();
  std::shuffle(rows.begin(), rows.end(), std::mt19937(1));
  EXPECT_NEAR(io::relative_noise(t, rows).value.value(), sorted, 1e-12);
}

TEST(Noise, OfACopiedSideIsThatOfTheScans) {
  io::SampleTable t = measure(gloss({"f"}), hemisphere(0.03));
  std::map<std::tuple<double, double, double>, double> side;
  for (std::size_t k = 0; k < t.rows(); ++k) {
    const double azimuth = std::abs(std::remainder(t.phi_o[k], 360.0));
    t.values[0][k] = side.try_emplace({t.theta_i[k], t.theta_o[k], azimuth}, t.values[0][k]).first->second;
  }
  EXPECT_NEAR(io::relative_noise(t).value.value(), 0.03, 0.005);
}

TEST(Noise, OfRepeatedRowsNeedsNoNeighbours) {
  io::SampleTable t;
  t.channels = {"f"};
  t.values.resize(1);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Draw draw(3);
  for (int k = 0; k < 200; ++k) {
    const double light = draw.uniform(0, 80), viewer = draw.uniform(0, 80), azimuth = draw.uniform(0, 360),
                 law = draw.by_ratio(0.01, 10);  // unrelated values in all directions
    for (int repeat = 0; repeat < 2; ++repeat) {
      t.add_directions(light, 0, viewer, azimuth);
      t.values[0].push_back(law * std::exp(0.03 * normal(random)));
    }
  }
  EXPECT_NEAR(io::relative_noise(t).value.value(), 0.03, 0.005);
}

TEST(Noise, IsUnknownWhereRowsTellNothingOfOneAnother) {
  Draw draw(5);
  io::SampleTable t;
  t.channels = {"f"};
  t.values.resize(1);
  for (int k = 0; k < 1000; ++k) {
    t.add_directions(draw.uniform(0, 80), draw.uniform(0, 360), draw.uniform(0, 80), draw.uniform(0, 360));
    t.values[0].push_back(draw.uniform(0.9, 1.1));
  }
  EXPECT_FALSE(io::relative_noise(t).value);
  io::SampleTable few;
  few.channels = {"f"};
  few.values.resize(1);
  for (int k = 0; k < 20; ++k) {
    few.add_directions(30, 180, 4 * k, 0);
    few.values[0].push_back(draw.uniform(0.9, 1.1));
  }
  EXPECT_FALSE(io::relative_noise(few).value);
}

TEST(Noise, ByLevelTellsADarkFloorFromAShareOfTheValue) {
  Material m = gloss({"f"});
  m.terms[0].weights[0][0] = 0.02;
  Instrument share = hemisphere(0.03), floor = hemisphere(0);
  floor.noise_floor = 0.0003;
  const auto levels = [&](const Instrument& instrument) {
    const io::SampleTable t = measure(m, instrument);
    std::vector<std::uint32_t> rows(t.rows());
    std::iota(rows.begin(), rows.end(), 0u);
    return io::noise_by_level(t, rows);
  };
  const auto even = levels(share), rising = levels(floor);
  ASSERT_GE(even.size(), 3u);
  ASSERT_GE(rising.size(), 3u);
  for (const io::NoiseAtLevel& x : even) EXPECT_NEAR(x.relative, 0.03, 0.008) << x.level;
  for (const io::NoiseAtLevel& x : rising) EXPECT_NEAR(x.relative * x.level / 0.0003, 1, 0.35) << x.level;
  EXPECT_GT(rising.front().relative, 3 * rising.back().relative);
}

}  // namespace
}  // namespace brdf::synth
