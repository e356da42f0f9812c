// RGL files of known reflectances are read back, and sampled in the same way as by importers.
#include "io/formats/rgl_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brdf/integrals.h"
#include "brdf/random.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/formats/rgl.h"
#include "io/formats/tensor_file.h"
#include "tests/thorough.h"

namespace brdf::io {
namespace {

Material glossy(double alpha, double kd, std::vector<std::string> channels = {"r", "g", "b"}) {
  Material m = make_material(*find_form("cook_torrance"), std::move(channels));
  m.terms[0].shape[0] = {alpha, alpha};
  for (std::size_t c = 0; c < m.channels.size(); ++c)
    m.terms[0].weights[c] = {kd, 0.7, 0.5 - 0.1 * double(c % 3)};
  return m;
}

Content file_of(const Material& m, std::uint64_t bytes) {
  const rgl::Values values = [&](const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> f) {
    eval(m, wi, wo, f);
  };
  return {"written.bsdf", rgl::file_of(values, m.channels, {"a test", bytes})};
}

Vec3<double> anywhere(Random& random) {
  return direction(degrees(random.uniform(0, 80)), degrees(random.uniform(0, 360)));
}

// Returns the median relative error over pairs. Half of the pairs are within a few widths of the mirror
// direction.
double median_error(const Material& m, const Content& content) {
  const rgl::Measurement read(content);
  const double alpha = m.terms[0].shape[0][0];
  Random random(11);
  std::vector<double> errors, f(3), g(3);
  while (errors.size() < 4000) {
    const Vec3<double> wi = anywhere(random);
    Vec3<double> wo = anywhere(random);
    if (errors.size() % 2) {
      const double t = alpha * std::sqrt(1 / (1 - random.uniform(0, 0.97)) - 1),
                   p = random.uniform(0, 2 * kPi);
      Vec3<double> h{t * std::cos(p), t * std::sin(p), 1};
      h = h * (1 / std::sqrt(dot(h, h)));
      wo = h * (2 * dot(h, wi)) - wi;
      if (wo.z < 0.17) continue;
    }
    eval(m, wi, wo, f);
    read.eval_cos_o(wi, wo, g);
    errors.push_back(std::abs(g[1] / wo.z / f[1] - 1));
  }
  return median(errors);
}

TEST(RglWriter, ReadsBackWithinItsBounds) {
  BRDF_LONG_UNDER_SANITIZERS();
  for (const double alpha : {0.05, 0.1, 0.5})
    for (const double kd : {0.0, 0.3}) {
      const Material m = glossy(alpha, kd);
      const Content small = file_of(m, 4'000'000);
      EXPECT_NEAR(double(small.bytes.size()), 4e6, 2e5);
      const double error = median_error(m, small);
      EXPECT_LT(error, 0.002) << alpha << " " << kd;
      EXPECT_GT(error, 1e-6);  // a table cannot be as exact as a formula
    }
  const Material hardest = glossy(0.05, 0.3);
  EXPECT_LT(median_error(hardest, file_of(hardest, 25'000'000)), 0.0005);
}

TEST(RglWriter, KeepsBandsAndOneChannel) {
  const Content bands = file_of(glossy(0.2, 0.1, {"450nm", "550nm", "650nm", "700nm"}), 400'000);
  EXPECT_THAT(rgl::Measurement(bands).channels(), ::testing::ElementsAre("450nm", "550nm", "650nm", "700nm"));
  const Material grey = glossy(0.2, 0.1, {"f"});
  std::vector<double> f(1), g(3);
  const Vec3<double> wi = direction(30_deg, 10_deg), wo = direction(40_deg, 150_deg);
  eval(grey, wi, wo, f);
  rgl::Measurement(file_of(grey, 400'000)).eval_cos_o(wi, wo, g);
  for (const double value : g) EXPECT_NEAR(value / wo.z / f[0], 1, 0.02);
}

TEST(RglWriter, RefusesChannelsWithoutAPlace) {
  EXPECT_THROW(file_of(glossy(0.2, 0.1, {"a", "b"}), 400'000), InputError);
  EXPECT_THROW(file_of(glossy(0.2, 0.1, {"650nm", "450nm"}), 400'000), InputError);
  EXPECT_THROW(file_of(glossy(0.2, 0.1), 1000), InputError);
}

// One slice of a file's `luminance`, sampled like importers do (measured.cpp of Mitsuba, the bilinear
// density of Warp2D): rows by their marginal distribution, then columns.
class Luminance {
 public:
  Luminance(const TensorFile& file, std::size_t slice) : side_(file.shape("luminance")[3]) {
    const std::vector<float> all = file.floats("luminance");
    const auto begin = all.begin() + std::ptrdiff_t(slice * side_ * side_);
    cells_.assign(begin, begin + std::ptrdiff_t(side_ * side_));
    for (std::size_t row = 0; row < side_; ++row) totals_.push_back(total(&cells_[row * side_]));
    whole_ = total(totals_.data());
  }

  // Returns the density on the unit square, with mean 1.
  double density(double x, double y) const {
    const auto [row, v] = cell_of(y);
    return value(interpolated(row, v), x) * square(double(side_ - 1)) / whole_;
  }
  void sample(double u1, double u2, double& x, double& y) const {
    y = invert(totals_, u1 * whole_);
    const auto [row, v] = cell_of(y);
    const std::vector<double> line = interpolated(row, v);
    x = invert(line, u2 * total(line.data()));
  }

 private:
  double total(const double* nodes) const {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < side_; ++k) sum += 0.5 * (nodes[k] + nodes[k + 1]);
    return sum;
  }
  std::pair<std::size_t, double> cell_of(double u) const {
    const double x = u * double(side_ - 1);
    const std::size_t k = std::min(std::size_t(x), side_ - 2);
    return {k, x - double(k)};
  }
  std::vector<double> interpolated(std::size_t row, double v) const {
    std::vector<double> line(side_);
    for (std::size_t k = 0; k < side_; ++k)
      line[k] = (1 - v) * cells_[row * side_ + k] + v * cells_[(row + 1) * side_ + k];
    return line;
  }
  double value(const std::vector<double>& nodes, double u) const {
    const auto [k, t] = cell_of(u);
    return (1 - t) * nodes[k] + t * nodes[k + 1];
  }
  // Returns the position at which the integral of the piecewise linear nodes reaches `area`.
  double invert(const std::vector<double>& nodes, double area) const {
    std::size_t k = 0;
    for (; k + 2 < side_; ++k) {
      const double step = 0.5 * (nodes[k] + nodes[k + 1]);
      if (area < step) break;
      area -= step;
    }
    const double a = nodes[k], b = nodes[k + 1], slope = b - a;
    const double t = std::abs(slope) < 1e-12 * (a + b)
                         ? area / a
                         : (std::sqrt(std::max(a * a + 2 * area * slope, 0.0)) - a) / slope;
    return (double(k) + std::min(std::max(t, 0.0), 1.0)) / double(side_ - 1);
  }

  std::size_t side_;
  std::vector<double> cells_, totals_;
  double whole_ = 0;
};

// Returns the importer's density of wo per solid angle.
double pdf_of(const Luminance& luminance, const Vec3<double>& wi, const Vec3<double>& wo) {
  Vec3<double> m = wi + wo;
  m = m * (1 / std::sqrt(dot(m, m)));
  const double theta = std::acos(std::min(m.z, 1.0)), x = std::sqrt(theta * 2 / kPi);
  const double y = (std::atan2(m.y, m.x) + kPi) / (2 * kPi);
  const double jacobian = std::max(2 * kPi * kPi * x * std::sin(theta), 1e-6) * 4 * dot(wi, m);
  return luminance.density(x, y) / jacobian;
}

TEST(RglWriter, ImportersSampleWithBoundedWeightsAndTheirDensity) {
  const Material m = glossy(0.3, 0.2);
  const Content content = file_of(m, 1'000'000);
  const TensorFile file(content);
  const rgl::Measurement read(content);
  const std::size_t slice = file.shape("theta_i")[0] / 2;
  const double theta_i = file.floats("theta_i")[slice];
  const Vec3<double> wi{std::sin(theta_i), 0, std::cos(theta_i)};
  const Luminance luminance(file, slice);
  constexpr int kRings = 6, kSectors = 8, kSamples = 40000;
  std::vector<double> counts(kRings * kSectors), expected(kRings * kSectors);
  Random random(5);
  double sum = 0, squares = 0, largest = 0;
  for (int k = 0; k < kSamples; ++k) {
    double x, y;
    luminance.sample(random.uniform(), random.uniform(), x, y);
    const double theta = x * x * kPi / 2, phi = (2 * y - 1) * kPi;
    const Vec3<double> h{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
    const Vec3<double> wo = h * (2 * dot(h, wi)) - wi;
    if (wo.z <= 0) continue;
    double f[3];
    read.eval_cos_o(wi, wo, f);
    const double weight = (f[0] + f[1] + f[2]) / 3 / pdf_of(luminance, wi, wo);
    sum += weight;
    squares += weight * weight;
    largest = std::max(largest, weight);
    const int ring = std::min(int(kRings * (1 - wo.z)), kRings - 1);
    const int sector = std::min(int(kSectors * (std::atan2(wo.y, wo.x) / (2 * kPi) + 0.5)), kSectors - 1);
    ++counts[std::size_t(ring * kSectors + sector)];
  }
  // The sampling weights are bounded and their mean is the albedo.
  double albedo = 0;
  for (const AlbedoResult& a : directional_albedo(m, radians(theta_i), {})) albedo += a.value / 3;
  const double mean = sum / kSamples, error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
  EXPECT_NEAR(mean, albedo, 4 * error + 0.003 * albedo);
  EXPECT_LT(largest, 2 * albedo);
  EXPECT_LT(error * std::sqrt(kSamples), 0.2 * albedo);
  // Compares the counts in rings of equal solid angle and sectors with the integral of the density.
  constexpr int kSteps = 24;
  double chi2 = 0;
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector) {
      double integral = 0;
      for (int a = 0; a < kSteps; ++a)
        for (int b = 0; b < kSteps; ++b) {
          const double z = 1 - (ring + (a + 0.5) / kSteps) / kRings, s = std::sqrt(1 - z * z);
          const double phi = ((sector + (b + 0.5) / kSteps) / kSectors - 0.5) * 2 * kPi;
          integral += pdf_of(luminance, wi, {s * std::cos(phi), s * std::sin(phi), z});
        }
      const double area = 2 * kPi / (kRings * kSectors);
      const double wanted = kSamples * integral / (kSteps * kSteps) * area;
      const double count = counts[std::size_t(ring * kSectors + sector)];
      chi2 += square(count - wanted) / std::max(wanted, 5.0);
    }
  // chi2 of 48 cells has mean 48 and standard deviation 10; the bounds are 4 standard deviations.
  EXPECT_LT(chi2, 48 + 4 * 10);
  EXPECT_GT(chi2, 48 - 4 * 10);
}

}  // namespace
}  // namespace brdf::io
