// Samplers against their densities (chi-square test), against the bounds of their weights, and albedos by
// Monte Carlo integration against the quadrature.
#include "brdf/sampling.h"
#include "brdf/forms.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/gamma.hpp>
#include <functional>
#include <iostream>
#include <numeric>
#include <random>

#include "brdf/integrals.h"
#include "brdf/material.h"
#include "tests/libbrdf/widths.h"
#include "tests/thorough.h"

namespace brdf {
namespace {

// One sampler with one set of parameters.
struct Subject {
  Reflectance form;
  std::vector<double> shape;
};

Vec3<double> draw(const Subject& subject, double u1, double u2, double u3, const Vec3<double>& wo,
                  double share) {
  return subject.form->sample(subject.shape, u1, u2, u3, wo, share);
}
double density(const Subject& subject, const Vec3<double>& wi, const Vec3<double>& wo, double share) {
  return subject.form->pdf(subject.shape, wi, wo, share);
}
// Returns f cos_i of the diffuse or the specular part at weight 1, with F = 1.
double value_cos(const Subject& subject, const Vec3<double>& wi, const Vec3<double>& wo, bool specular) {
  Term term = make_term(subject.form, 1);
  term.shape[0] = subject.shape;
  const ReflectanceInfo& f = info(subject.form);
  for (std::size_t k = 0; k < f.weights.size(); ++k)
    term.weights[0][k] = f.weights[k].name == "f0"   ? 1
                         : f.weights[k].name == "ks" ? double(specular)
                                                     : double(!specular);
  double value = 0;
  eval_cos(Material{{"y"}, {term}}, wi, wo, {&value, 1});
  return value;
}

std::vector<Subject> subjects() {
  return {{lambert{}, {}},
          {oren_nayar{}, {0.5}},
          {phong{}, {4}},
          {phong{}, {80}},
          {blinn_phong{}, {4}},
          {blinn_phong{}, {80}},
          {ward{}, {0.2, 0.2}},
          {ward{}, {0.15, 0.6}},
          {cook_torrance{}, {0.15, 0.15}},
          {cook_torrance{}, {0.2, 0.8}},
          {cook_torrance{}, {1, 1}},
          {cook_torrance_beckmann{}, {0.15, 0.15}},
          {cook_torrance_beckmann{}, {0.2, 0.8}},
          {cook_torrance_beckmann{}, {1, 1}},
          {cook_torrance_student{}, {0.3, 0.3, 1.8}},
          {cook_torrance_dielectric{}, {0.2, 0.8, 1.5}},
          {cook_torrance_vcavity{}, {0.2, 0.6, 1.5}},
          {ward_as_coded{}, {0, 0.3, 0.6}},
          {cook_torrance_as_coded{}, {0.5, 0}},
          {phong_as_coded{}, {0}}};
}
const std::vector<double> kViewAngles{0, 35, 75, 86};

// --- Chi-square -------------------------------------------------------------------------------------------

constexpr int kRings = 12, kSectors = 24;  // equal steps of the cosine and of the azimuth

int bin_of(const Vec3<double>& w) {
  if (w.z < 0) return -1;
  const double turn = std::atan2(w.y, w.x) / (2 * kPi) + 1;
  return std::min(int(w.z * kRings), kRings - 1) * kSectors + int((turn - std::floor(turn)) * kSectors);
}

// Returns the integral over a cell by adaptive quartering of Simpson's rule.
double integral(const std::function<double(double, double)>& f, double x0, double x1, double y0, double y1,
                int depth, double coarse = -1) {
  const auto simpson = [&](double a, double b, double c, double d) {
    double sum = 0;
    const double weight[]{1, 4, 1};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        sum += weight[i] * weight[j] * f(a + 0.5 * i * (b - a), c + 0.5 * j * (d - c));
    return sum * (b - a) * (d - c) / 36;
  };
  if (coarse < 0) coarse = simpson(x0, x1, y0, y1);
  const double x = 0.5 * (x0 + x1), y = 0.5 * (y0 + y1);
  const double parts[]{simpson(x0, x, y0, y), simpson(x, x1, y0, y), simpson(x0, x, y, y1),
                       simpson(x, x1, y, y1)};
  const double fine = std::accumulate(parts, parts + 4, 0.0);
  if (depth == 0 || std::abs(fine - coarse) < 1e-8) return fine;
  return integral(f, x0, x, y0, y, depth - 1, parts[0]) + integral(f, x, x1, y0, y, depth - 1, parts[1]) +
         integral(f, x0, x, y, y1, depth - 1, parts[2]) + integral(f, x, x1, y, y1, depth - 1, parts[3]);
}

// Returns the probability of a deviation at least this large. Bins are pooled until each expects 10
// samples; the directions below the horizon form a bin of their own.
double p_value(const std::vector<double>& observed, const std::vector<double>& expected) {
  double chi2 = 0, pooled_seen = 0, pooled_expected = 0;
  int bins = 0;
  for (std::size_t k = 0; k < observed.size(); ++k) {
    pooled_seen += observed[k];
    pooled_expected += expected[k];
    if (pooled_expected < 10 && k + 1 < observed.size()) continue;
    if (pooled_expected > 1e-3 || pooled_seen > 0) {
      chi2 += square(pooled_seen - pooled_expected) / std::max(pooled_expected, 1e-3);
      ++bins;
    }
    pooled_seen = pooled_expected = 0;
  }
  return bins < 2 ? 1 : boost::math::gamma_q(0.5 * (bins - 1), 0.5 * chi2);
}

double chi_square_test(const Subject& subject, const Vec3<double>& wo, std::mt19937_64& random,
                       const std::function<double(const Vec3<double>&)>& claimed) {
  constexpr int kSamples = 60000;
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> observed(kRings * kSectors + 1), expected(kRings * kSectors + 1);
  for (int k = 0; k < kSamples; ++k) {
    const double u1 = unit(random), u2 = unit(random);
    const int bin = bin_of(draw(subject, u1, u2, unit(random), wo, 0.7));
    observed[bin < 0 ? observed.size() - 1 : std::size_t(bin)] += 1;
  }
  double above = 0;
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector) {
      const auto f = [&](double cosine, double turn) {
        return 2 * kPi * claimed(from_cosine(std::max(cosine, 1e-9), 2 * kPi * turn));
      };
      const double mass = integral(f, double(ring) / kRings, (ring + 1.0) / kRings, double(sector) / kSectors,
                                   (sector + 1.0) / kSectors, 7);
      above += mass;
      expected[std::size_t(ring * kSectors + sector)] = kSamples * mass;
    }
  expected.back() = kSamples * std::max(0.0, 1 - above);
  return p_value(observed, expected);
}

TEST(Sampling, FollowsItsDensity) {
  BRDF_LONG_UNDER_SANITIZERS();
  std::mt19937_64 random(11);
  const std::vector<Subject> all = subjects();
  const double tests = double(all.size() * kViewAngles.size());
  for (const Subject& subject : all)
    for (double theta : kViewAngles) {
      const Vec3<double> wo = direction(degrees(theta), radians(0.6));
      const double p =
          chi_square_test(subject, wo, random, [&](const auto& wi) { return density(subject, wi, wo, 0.7); });
      // Sidak correction: a significance level of 1 % for all tests together.
      EXPECT_GT(p, 1 - std::pow(0.99, 1 / tests)) << info(subject.form).name << " at " << theta;
    }
}

TEST(Sampling, TheTestNoticesAWrongDensity) {
  std::mt19937_64 random(12);
  const Vec3<double> wo = direction(radians(0.6), radians(0.6));
  const Subject used{cook_torrance{}, {0.2, 0.2}}, claimed{cook_torrance{}, {0.23, 0.23}};
  EXPECT_LT(chi_square_test(used, wo, random, [&](const auto& wi) { return density(claimed, wi, wo, 0.7); }),
            1e-4);
}

// --- Weights ----------------------------------------------------------------------------------------------

// Returns the largest ratio of lobe value to density among samples of the lobe alone.
double largest_weight(const Subject& subject, const Vec3<double>& wo, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  double largest = 0;
  for (int k = 0; k < 6000; ++k) {
    const double u1 = unit(random), u2 = unit(random);
    const Vec3<double> wi = draw(subject, u1, u2, 0, wo, 1);
    if (wi.z <= 0) continue;
    largest = std::max(largest, value_cos(subject, wi, wo, true) / density(subject, wi, wo, 1));
  }
  return largest;
}

TEST(SamplingWeights, AreBounded) {
  BRDF_LONG_UNDER_SANITIZERS();
  std::mt19937_64 random(13);
  for (double theta : kViewAngles) {
    const Vec3<double> wo = direction(degrees(theta), radians(0.6));
    for (double n : {4.0, 80.0}) {
      EXPECT_LE(largest_weight({phong{}, {n}}, wo, random), (n + 2) / (n + 1) * (1 + 1e-12));
      const double k = (n + 2) * (n + 4) / (8 * kPi * (std::exp2(-n / 2) + n));
      EXPECT_LE(largest_weight({blinn_phong{}, {n}}, wo, random), k * 16 * kPi / (n + 2));
    }
    // Sampling visible normals: the weight is a ratio of masking functions and at most 1.
    for (double alpha : {0.1, 0.5, 1.0}) {
      EXPECT_LE(largest_weight({cook_torrance{}, {alpha, 0.5 * alpha}}, wo, random), 1 + 1e-12);
      EXPECT_LE(largest_weight({cook_torrance_beckmann{}, {alpha, 0.5 * alpha}}, wo, random), 1 + 1e-12);
      // V-cavities sampled by Gaussian slopes: G cos_d/(cos_o cos_h) <= 2, times 4/pi.
      EXPECT_LE(largest_weight({cook_torrance_1982{}, {alpha, 0.5 * alpha}}, wo, random),
                8 / kPi * (1 + 1e-12));
      // The weight is 2 cos_i/(cos_i + cos_o), at most 2.
      EXPECT_LE(largest_weight({ward_bounded{}, {alpha, 0.5 * alpha}}, wo, random), 2);
    }
    // Walter's weight of Ward's lobe, (wo.h) cos_h^3 sqrt(cos_i/cos_o), is unbounded towards grazing
    // angles.
    EXPECT_LE(largest_weight({ward{}, {0.2, 0.4}}, wo, random), std::sqrt(1 / wo.z) * (1 + 1e-12));
  }
  EXPECT_GT(largest_weight({cook_torrance{}, {0.1, 0.1}}, direction({}, {}), random), 0.99);
}

// --- Albedo -----------------------------------------------------------------------------------------------

struct Estimate {
  double mean, standard_error;
};
// Estimates the integral of f cos_i = value(wi) from directions drawn by the subject's sampler.
Estimate albedo_by_sampling(const Subject& subject, const Vec3<double>& wo, double share, int samples,
                            std::mt19937_64& random,
                            const std::function<double(const Vec3<double>&)>& value) {
  std::uniform_real_distribution<double> unit(0, 1);
  double sum = 0, sum2 = 0;
  for (int k = 0; k < samples; ++k) {
    const double u1 = unit(random), u2 = unit(random);
    const Vec3<double> wi = draw(subject, u1, u2, unit(random), wo, share);
    const double w = wi.z <= 0 ? 0 : value(wi) / density(subject, wi, wo, share);
    sum += w;
    sum2 += w * w;
  }
  const double mean = sum / samples;
  return {mean, std::sqrt(std::max(sum2 / samples - mean * mean, 0.0) / samples)};
}

TEST(SamplingAlbedo, AgreesWithTheQuadratureWithinThreeSigma) {
  BRDF_LONG_UNDER_SANITIZERS();
  std::mt19937_64 random(14);
  for (const Subject& subject : subjects())
    for (double theta : {20.0, 75.0}) {
      if (info(subject.form).lobes.empty()) continue;
      const Vec3<double> wo = direction(degrees(theta), radians(0.6));
      const auto lobes =
          lobe_albedos(subject.form, subject.shape, degrees(theta), radians(0.6), {.tolerance = 1e-8});
      const bool specular = lobes.size() > 1;
      const Estimate estimate = albedo_by_sampling(subject, wo, 0.8, 40000, random, [&](const auto& wi) {
        return value_cos(subject, wi, wo, specular);
      });
      const double truth = lobes[specular ? 1 : 0].value;
      EXPECT_NEAR(estimate.mean, truth, 3 * estimate.standard_error + 1e-9)
          << info(subject.form).name << " at " << theta;
      EXPECT_LT(estimate.standard_error, 0.01 * truth);
    }
}

Estimate albedo_by_sampling(const Term& term, const Vec3<double>& wo, double share, std::mt19937_64& random) {
  const Material material{{"y"}, {term}};
  return albedo_by_sampling({term.form, term.shape[0]}, wo, share, 4000, random, [&](const Vec3<double>& wi) {
    double value = 0;
    eval_cos(material, wi, wo, {&value, 1});
    return value;
  });
}
Term with_width(const Reflectance& form, double width) {
  Term term = make_term(form, 1);
  set_width(term, width, width);
  return term;
}

// Every form under uniform light: the sampler finds narrow lobes, and no direction has a weight much larger
// than its share.
TEST(SamplingAlbedo, OfEveryFormIsFoundWithFewSamples) {
  BRDF_LONG_UNDER_SANITIZERS();
  std::mt19937_64 random(15);
  for (const Reflectance& form : catalogue()) {
    const bool lobe_by_cosine = !info(form).follows_lobe && info(form).weight_index(Role::specular) >= 0;
    if (lobe_by_cosine) std::cout << "without a sampler of its own: " << info(form).name << '\n';
    for (double width : {0.03, 0.3})
      for (double theta : {0.0, 50.0, 75.0}) {
        const Term term = with_width(form, width);
        const Vec3<double> wo = direction(degrees(theta), radians(0.6));
        const Estimate estimate = albedo_by_sampling(term, wo, 0.5, random);
        const AlbedoResult truth = directional_albedo(term, 0, degrees(theta), radians(0.6),
                                                      {.fixed = Fixed::viewer, .tolerance = 1e-5});
        EXPECT_NEAR(estimate.mean, truth.value, 4.5 * estimate.standard_error + 1e-5)
            << info(form).name << " of width " << width << " at " << theta;
        if (lobe_by_cosine) continue;
        EXPECT_LT(estimate.standard_error * std::sqrt(4000), 1.2 * truth.value)
            << info(form).name << " of width " << width << " at " << theta;
      }
  }
}

TEST(SamplingAlbedo, OfANarrowLobeIsNotFoundByTheCosine) {
  std::mt19937_64 random(16);
  const Estimate estimate = albedo_by_sampling(with_width(cook_torrance_1982{}, 0.03),
                                               direction(degrees(75), radians(0.6)), 0, random);
  EXPECT_GT(estimate.standard_error * std::sqrt(4000), 4 * estimate.mean);
}

TEST(Sampling, FloatStaysFiniteAtTheExtremes) {
  for_each_form([](auto form) {
    using F = decltype(form);
    for (float theta : {0.0f, 1.0f, 1.5707f})
      for (float u : {0.0f, 0.5f, 0.99999994f})
        for (float u3 : {0.1f, 0.9f}) {
          const Vec3<float> wo{std::sin(theta), 0, std::cos(theta)};
          typename F::template Shape<float> shape{};
          for (const auto& field : shape.fields()) shape.*(field.member) = float(field.info.initial);
          const Vec3<float> wi = sample(form, shape, u, u, u3, wo);
          EXPECT_TRUE(std::isfinite(wi.x + wi.y + wi.z)) << F::name << ' ' << theta << ' ' << u;
          EXPECT_TRUE(std::isfinite(pdf(form, shape, wi, wo))) << F::name;
        }
  });
}

// The traced sampler has no more steps than these. A step that stays where it is must not leave the solution:
// the errors of the share were up to 0.12 when it did.
TEST(Sampling, FourteenStepsInvertTheGaussianSlopesInFloat) {
  double worst = 0;
  for (const double theta : {0.0, 1.0, 20.0, 45.0, 60.0, 70.0, 77.0, 85.0, 89.9}) {
    const double cosine = std::cos(theta * kPi / 180), sine = std::sin(theta * kPi / 180);
    const auto mass = [&](double x) {
      return 0.5 * cosine * std::erfc(-x) + sine * std::exp(-x * x) / (2 * std::sqrt(kPi));
    };
    const double whole = mass(std::min(cosine / sine, 6.0));
    for (int k = 0; k <= 20000; ++k) {
      const float u = std::min(float(k) / 20000, 1 - 0x1p-24f);
      const float slope = detail::visible_gaussian_slope(float(cosine), float(sine), u, 14);
      ASSERT_TRUE(std::isfinite(slope)) << theta << ' ' << u;
      worst = std::max(worst, std::abs(mass(double(slope)) / whole - double(u)));
    }
  }
  EXPECT_LT(worst, 6e-7);
  EXPECT_GT(worst, 1.5e-7);
}

}  // namespace
}  // namespace brdf
