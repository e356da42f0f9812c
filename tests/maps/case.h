// Maps of a synthetic stack together with the truth from which the stack was made.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <utility>

#include "io/samples/degrees.h"
#include "tests/maps/stack.h"

namespace brdf {

struct Case {
  io::TemporaryFolder folder;
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
    return known_of(surface.material(double(x), double(y)), surface.normal(double(x), double(y)),
                    settings.fits_normal, stack.lights, noise);
  }
};

// Calls visit(name without its channel, plane, truth, scale, known) for each parameter of a texel. `known`
// is true if 3 % noise would leave a standard error below 5 % of the scale. The scale is the absolute value
// of the parameter, or 1 for the components of a normal.
template <class Visit>
void for_each_known(const Case& c, std::size_t texel, Visit&& visit) {
  const Knowledge known = c.known(texel, 0.03);
  for (std::size_t q = 0; q < known.names.size(); ++q) {
    const std::string& name = known.names[q];
    const std::string kind = name.substr(0, name.find('.'));
    const double scale = kind == "normal" ? 1 : std::abs(known.values[q]);
    visit(kind, name, known.values[q], scale, known.errors[q] < 0.05 * scale);
  }
}

struct Share {
  int part = 0, all = 0;
  double value() const { return double(part) / all; }
};

// Parameters that are known to 5 % at 3 % noise must be found to 1e-6 without noise.
inline void expect_truth(std::size_t size, bool fits_normal, unsigned threads = 1) {
  const Case c(small_stack(size, 151), fits_normal);
  const texel::Planes maps = c.fit(std::size_t{1} << 28, threads);
  std::map<std::string, Share> told;
  double worst = 0;
  int wrong = 0;
  for (std::size_t k = 0; k < size * size; ++k)
    for_each_known(c, k, [&](const auto& kind, const auto& name, double value, double scale, bool known) {
      ++told[kind].all;
      told[kind].part += known;
      if (!known) return;
      const double off = std::abs(double((*maps.find(name))[k]) - value) / scale;
      worst = std::max(worst, off);
      if (!(off < 1e-6) && ++wrong < 5)
        std::cout << name << " at " << k % size << ", " << k / size << ": off by " << off << " of " << value
                  << '\n';
    });
  for (const auto& [kind, share] : told)
    std::cout << kind << ": " << 100 * share.value() << " % identifiable\n";
  std::cout << "largest deviation " << worst << ", above 1e-6: " << wrong << '\n';
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(told["kd"].value(), 0.9);
  EXPECT_GE(told["alpha_x"].value(), 0.6);
  if (fits_normal) {
    EXPECT_GE(told["normal"].value(), 0.9);
  }
  EXPECT_GT(worst, 0);  // something was compared
}

// Tests the coverage of the standard errors at 3 % noise. The residual makes this noise uniform, so that no
// few pixels dominate. The width depends on the few images that see the highlight, and so does its standard
// error. For small maps the coverage of widths must therefore only exceed `least_of_widths`.
inline void expect_coverage(std::size_t size, double least_of_widths, unsigned threads = 1) {
  synth::TexelOptions o = small_stack(size, 151);
  o.noise = 0.03;
  Case c(o, true);
  c.settings.options.metric = fit::Metric::log_relative;
  const texel::Planes maps = c.fit(std::size_t{1} << 28, threads);
  std::map<std::string, Share> inside;
  for (std::size_t k = 0; k < size * size; ++k)
    for_each_known(c, k, [&](const auto& kind, const auto& name, double value, double, bool known) {
      const double error = double((*maps.find("standard_error." + name))[k]);
      if (kind == "ks" || kind == "f0" || !known || !(error > 0)) return;
      ++inside[kind].all;
      inside[kind].part += std::abs(double((*maps.find(name))[k]) - value) < 1.96 * error;
    });
  const std::map<std::string, double> least{{"kd", 0.92}, {"normal", 0.92}, {"alpha_x", least_of_widths}};
  for (const auto& [kind, low] : least) {
    const Share& share = inside[kind];
    std::cout << kind << ": " << share.part << " of " << share.all << " within 1.96 standard errors, "
              << 100 * share.value() << " %\n";
    EXPECT_GT(share.all, 600) << kind;
    EXPECT_GT(share.value(), low) << kind;
    EXPECT_LT(share.value(), 0.98) << kind;
  }
}

// Returns the material of a texel according to the planes.
inline Material material_at(const texel::Planes& planes, Material m, std::size_t texel) {
  const auto at = [&](const std::string& name) { return double((*planes.find(name))[texel]); };
  const ReflectanceInfo& form = info(m.terms[0].form);
  for (std::size_t k = 0; k < form.shape.size(); ++k)
    m.terms[0].shape[0][k] = at(std::string(form.shape[k].name));
  for (std::size_t c = 0; c < m.channels.size(); ++c)
    for (std::size_t k = 0; k < form.weights.size(); ++k)
      m.terms[0].weights[c][k] = at(texel::plane_name(std::string(form.weights[k].name), m.channels[c]));
  return m;
}

// Returns the peak signal-to-noise ratio in decibels of the picture from the maps, under a light and from a
// viewpoint that were not photographed. The peak is the brightest pixel of the true picture.
inline double psnr(const Case& c, const texel::Planes& maps) {
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

}  // namespace brdf
