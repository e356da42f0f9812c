// Maps of synthetic stacks against the truth they were made from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>

#include "fit/fit.h"
#include "maps/page.h"
#include "tests/maps/stack.h"

namespace brdf {
namespace {

struct Case {
  TemporaryFolder folder;
  Material material = lacquer();
  synth::TexelOptions options;
  texel::Stack stack;
  texel::Planes truth;
  maps::Settings settings;

  Case(synth::TexelOptions o, bool fits_normal)
      : options(std::move(o)), settings(settings_of(material, fits_normal)) {
    synth::write_stack(folder.path(), material, options);
    stack = texel::open_stack(folder.path());
    truth = texel::read_planes(folder.path() / "truth" / "truth.exr");
  }
  const maps::Normals* normals() const { return settings.fits_normal ? nullptr : &truth; }
  texel::Planes fit(std::size_t memory = std::size_t{1} << 28, unsigned threads = 1) const {
    return maps::fit_stack(stack, settings, normals(), {memory, threads});
  }
  Knowledge known(std::size_t texel, double noise) const {
    const synth::Surface surface(material, options);
    const std::size_t x = texel % options.width, y = texel / options.width;
    return known_of(surface.material(x, y), surface.normal(x, y), settings.fits_normal, stack.lights, noise);
  }
};

// What can be told at 3 % noise to 5 % is found to a millionth where there is no noise.
void expect_truth(bool fits_normal) {
  const Case c(small_stack(16, 151), fits_normal);
  const texel::Planes maps = c.fit();
  std::map<std::string, std::pair<int, int>> told;  // by the parameter's name, of all
  double worst = 0;
  for (std::size_t k = 0; k < 256; ++k) {
    const Knowledge known = c.known(k, 0.03);
    for (std::size_t q = 0; q < known.names.size(); ++q) {
      const std::string& name = known.names[q];
      const bool normal = name.starts_with("normal");
      const double scale = normal ? 1 : std::abs(known.values[q]);
      auto& [identified, all] = told[name.substr(0, name.find('.'))];
      ++all;
      if (!(known.errors[q] < 0.05 * scale)) continue;
      ++identified;
      const double off = std::abs(double((*maps.find(name))[k]) - known.values[q]) / scale;
      worst = std::max(worst, off);
      EXPECT_LT(off, 1e-6) << name << " at " << k % 16 << ", " << k / 16 << ": " << known.values[q];
    }
  }
  const auto share = [&](const char* name) { return double(told[name].first) / told[name].second; };
  EXPECT_GE(share("kd"), 0.9);
  EXPECT_GE(share("alpha_x"), 0.6);
  if (fits_normal) {
    EXPECT_GE(share("normal"), 0.9);
  }
  EXPECT_GT(worst, 0);  // something was compared
}

TEST(Maps, WithoutNoiseAreTheTruthUnderGivenNormals) {
  expect_truth(false);
}

TEST(Maps, WithoutNoiseAreTheTruthWhereNormalsAreFitted) {
  expect_truth(true);
}

// Under the residual that noise of this kind asks for, which makes it even: no few pixels decide.
TEST(Maps, StandardErrorsCoverTheTruth) {
  synth::TexelOptions o = small_stack(32, 151);
  o.noise = 0.03;
  Case c(o, true);
  c.settings.options.metric = fit::Metric::log_relative;
  const texel::Planes maps = c.fit();
  std::map<std::string, std::pair<int, int>> inside;
  for (std::size_t k = 0; k < 32 * 32; ++k) {
    const Knowledge known = c.known(k, 0.03);
    for (std::size_t q = 0; q < known.names.size(); ++q) {
      const std::string name = known.names[q], kind = name.substr(0, name.find('.'));
      const double scale = kind == "normal" ? 1 : std::abs(known.values[q]);
      const double error = double((*maps.find("standard_error." + name))[k]);
      if (kind == "ks" || kind == "f0" || !(known.errors[q] < 0.05 * scale) || !(error > 0)) continue;
      ++inside[kind].second;
      inside[kind].first += std::abs(double((*maps.find(name))[k]) - known.values[q]) < 1.96 * error;
    }
  }
  // A width is decided by the few images that see the highlight, and so is its standard error.
  const std::map<std::string, double> least{{"kd", 0.92}, {"normal", 0.92}, {"alpha_x", 0.9}};
  for (const auto& [kind, low] : least) {
    const auto [held, all] = inside[kind];
    std::cout << kind << ": " << held << " of " << all << " within 1.96 standard errors\n";
    EXPECT_GT(all, 600) << kind;
    EXPECT_GT(double(held) / all, low) << kind;
    EXPECT_LT(double(held) / all, 0.98) << kind;
  }
}

// The material of a texel as planes have it.
Material material_at(const texel::Planes& planes, Material m, std::size_t texel) {
  const auto at = [&](const std::string& name) { return double((*planes.find(name))[texel]); };
  const ReflectanceInfo& form = info(m.terms[0].form);
  for (std::size_t k = 0; k < form.shape.size(); ++k)
    m.terms[0].shape[0][k] = at(std::string(form.shape[k].name));
  for (std::size_t c = 0; c < m.channels.size(); ++c)
    for (std::size_t k = 0; k < form.weights.size(); ++k)
      m.terms[0].weights[c][k] = at(texel::plane_name(std::string(form.weights[k].name), m.channels[c]));
  return m;
}

// Decibels of the picture that the maps give under a light and from a viewpoint that were not photographed, its peak the
// brightest pixel of the true one.
double psnr(const Case& c, const texel::Planes& maps) {
  const Vec3<double> wi = io::unit_vector(40, 77), wo = io::unit_vector(15, 200);
  double peak = 0, square = 0;
  std::vector<double> truth(3), found(3);
  const std::size_t texels = maps.width * maps.height;
  const auto pixel = [&](const texel::Planes& planes, std::size_t k, std::vector<double>& out) {
    Vec3<double> n{double((*planes.find("normal.x"))[k]), double((*planes.find("normal.y"))[k]),
                   double((*planes.find("normal.z"))[k])};
    n = n * (1 / std::sqrt(dot(n, n)));
    eval_cos(material_at(planes, c.material, k), in_frame_of(n, wi), in_frame_of(n, wo), out);
  };
  for (std::size_t k = 0; k < texels; ++k) {
    pixel(c.truth, k, truth);
    pixel(maps, k, found);
    for (std::size_t ch = 0; ch < 3; ++ch) {
      peak = std::max(peak, truth[ch]);
      square += std::pow(found[ch] - truth[ch], 2);
    }
  }
  return 10 * std::log10(peak * peak * double(3 * texels) / square);
}

TEST(Maps, GiveThePictureUnderAnotherLight) {
  synth::TexelOptions o = small_stack(24, 151);
  for (const double noise : {0.0, 0.03}) {
    o.noise = noise;
    for (const bool fits_normal : {false, true}) {
      const Case c(o, fits_normal);
      const double decibels = psnr(c, c.fit());
      std::cout << "noise " << noise << ", normals " << (fits_normal ? "fitted" : "given") << ": " << decibels
                << " dB\n";
      EXPECT_GT(decibels, noise > 0 ? 35 : 90);
    }
  }
}

// The minimum and the verdict are those of a fit of the texel's table alone.
void expect_same_as_tables(bool fits_normal) {
  synth::TexelOptions o = small_stack(16, 151);
  o.noise = 0.03;
  o.saturation = 3;
  const Case c(o, fits_normal);
  const texel::Planes maps = c.fit();
  for (std::size_t k = 5; k < 256; k += 23) {
    const std::size_t x = k % 16, y = k / 16;
    const auto at = [&](const std::string& name) { return double((*maps.find(name))[k]); };
    const texel::Region here{x, y, 1, 1};
    const std::vector<float> pixels = texel::read_region(c.stack, here);
    // Of a given normal the very one; the map's is rounded to float.
    const texel::Planes& normals = fits_normal ? maps : c.truth;
    Vec3<double> n{double((*normals.find("normal.x"))[k]), double((*normals.find("normal.y"))[k]), 0};
    n.z = std::sqrt(1 - n.x * n.x - n.y * n.y);
    fit::FitOptions options;
    options.cross_validation = false;
    const fit::FitResult alone = fit::fit(maps::texel_table(c.stack, pixels, n), {c.settings.forms}, options);
    const fit::FormFit& best = alone.ranking[0];
    ASSERT_EQ(double(alone.rows), at("images")) << x << ", " << y;
    if (!fits_normal) {
      EXPECT_EQ(best.verdict, fit::Verdict(int(at("verdict")))) << x << ", " << y;
    }
    for (const fit::Estimate& e : best.estimates) {
      const std::string name = texel::plane_name(e.name, e.channel);
      if (e.status != fit::Status::free || e.standard_error > 0.3 * std::abs(e.value)) continue;
      // Where a parameter is hardly known, both stop at a cost that is known to 1e-12.
      const double within = std::max(1e-6 * std::abs(e.value), 2e-5 * e.standard_error);
      EXPECT_NEAR(at(name), e.value, within) << name << " at " << x << ", " << y;
      if (fits_normal) continue;
      EXPECT_NEAR(at("standard_error." + name), e.standard_error, 1e-4 * e.standard_error) << name;
    }
  }
}

TEST(Maps, AreThoseOfATexelsTableUnderGivenNormals) {
  expect_same_as_tables(false);
}

TEST(Maps, AreThoseOfATexelsTableWhereNormalsAreFitted) {
  expect_same_as_tables(true);
}

TEST(Maps, DoNotDependOnMemoryOrThreads) {
  synth::TexelOptions o = small_stack(0, 24);
  o.width = 66;
  o.height = 6;
  o.noise = 0.03;
  const Case c(o, false);
  const texel::Planes one = c.fit(), two = c.fit(20000, 2);
  ASSERT_EQ(one.names, two.names);
  for (std::size_t k = 0; k < one.values.size(); ++k)
    EXPECT_EQ(0,
              std::memcmp(one.values[k].data(), two.values[k].data(), one.values[k].size() * sizeof(float)))
        << one.names[k];
}

TEST(Maps, LeaveOutWhatIsMasked) {
  synth::TexelOptions o = small_stack(8, 40);
  Case c(o, false);
  texel::Planes mask{8, 8, {"Y"}, {std::vector<float>(64, 1.f)}};
  mask.values[0][9] = 0;
  texel::write_planes(c.folder.path() / "mask.exr", mask);
  c.stack = texel::open_stack(c.folder.path());
  const texel::Planes maps = c.fit();
  for (std::size_t k = 0; k < 64; ++k) EXPECT_EQ(std::isnan((*maps.find("verdict"))[k]), k == 9);
  EXPECT_EQ(maps::summary_of(maps).fitted, 63u);
}

TEST(Maps, TakeAMetricByTheNoiseOfSomeTexels) {
  synth::TexelOptions o = small_stack(9, 400);
  o.noise = 0.05;
  Case c(o, false);
  c.settings.options.metric = fit::Metric::automatic;
  const fit::Metric metric = maps::choose_metric(c.stack, c.settings, c.normals());
  EXPECT_NE(metric, fit::Metric::automatic);
  c.settings.options.metric = fit::Metric::cosine_l2;
  EXPECT_EQ(maps::choose_metric(c.stack, c.settings, c.normals()), fit::Metric::cosine_l2);
}

TEST(Maps, RefuseWhatTexelsCannot) {
  maps::Settings s = settings_of(lacquer(), false);
  s.options.loss = fit::Loss::huber;
  EXPECT_THROW(maps::check(s), InputError);
  s.options.loss_scale = 0.1;
  EXPECT_NO_THROW(maps::check(s));
  s.options.free_scale = true;
  EXPECT_THROW(maps::check(s), InputError);
  s.options.free_scale = false;
  s.options.random_starts = 3;
  EXPECT_THROW(maps::check(s), InputError);
}

}  // namespace
}  // namespace brdf
