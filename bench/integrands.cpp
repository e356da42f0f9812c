#include "bench/integrands.h"

#include <cubature.h>

#include <cmath>

#include "brdf/integrals.h"
#include "brdf/quadrature.h"
#include "brdf/random.h"
#include "brdf/reflectance.h"
#include "brdf/samplers.h"
#include "trade/measure/timing.h"

namespace brdf::bench {
namespace {

class Stopwatch {
 public:
  double seconds() const { return timing::seconds_now(timing::Clock::wall) - start_; }

 private:
  double start_ = timing::seconds_now(timing::Clock::wall);
};

// Evaluates f cos_o sin(theta_o), a block of directions at a time.
class Block {
 public:
  static constexpr std::size_t kMost = 1024;
  explicit Block(const Lobe& lobe)
      : lobe_(lobe), directions_(kMost), light_(direction(radians(lobe.theta), radians(kPi))) {}

  // trig(k) returns sine and cosine of the polar angle, then of the azimuth.
  template <class Trig>
  void evaluate(std::size_t count, double* out, Trig&& trig) {
    for (std::size_t first = 0; first < count; first += kMost) {
      const std::size_t n = std::min(kMost, count - first);
      for (std::size_t k = 0; k < n; ++k) {
        const auto [st, ct, sp, cp] = trig(first + k);
        directions_.set(k, light_, {st * cp, st * sp, ct});
        jacobian_[k] = st * ct;
      }
      eval_batch(lobe_.term, 0, directions_.view().part(0, n), out + first);
      for (std::size_t k = 0; k < n; ++k) out[first + k] *= jacobian_[k];
    }
    evaluations += long(count);
  }
  long evaluations = 0;

 private:
  const Lobe& lobe_;
  DirectionArrays<double> directions_;
  std::array<double, kMost> jacobian_;
  Vec3<double> light_;
};

double product(Block& block, int n) {
  const auto& rule = quadrature::gauss_legendre(n);
  std::vector<double> sine, cosine, out(static_cast<std::size_t>(n));
  for (const double v : rule.node) {
    sine.push_back(std::sin(kPi * v));
    cosine.push_back(std::cos(kPi * v));
  }
  double sum = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double theta = kPi / 2 * rule.node[i], st = std::sin(theta), ct = std::cos(theta);
    block.evaluate(out.size(), out.data(), [&](std::size_t j) {
      return std::array{st, ct, sine[j], cosine[j]};
    });
    double row = 0;
    for (std::size_t j = 0; j < out.size(); ++j) row += rule.weight[j] * out[j];
    sum += rule.weight[i] * row;
  }
  return kPi * kPi * sum;  // twice pi/2 times pi
}

int cubature_block(unsigned, std::size_t count, const double* x, void* data, unsigned, double* out) {
  static_cast<Block*>(data)->evaluate(count, out, [x](std::size_t k) {
    const double theta = x[2 * k], phi = x[2 * k + 1];
    return std::array{std::sin(theta), std::cos(theta), std::sin(phi), std::cos(phi)};
  });
  return 0;
}

// Records the results of a method that refines its estimate and therefore meets the tolerances one after the
// other.
class Milestones {
 public:
  void at(double value, double error, long evaluations) {
    for (std::size_t t = 0; t < kTolerances.size(); ++t)
      if (!results[t].claims)
        results[t] = {value, evaluations, error <= kTolerances[t] * std::abs(value), watch_.seconds()};
  }
  bool done() const { return results.back().claims; }
  Results results;

 private:
  Stopwatch watch_;
};

}  // namespace

Results pole_adapted(const Lobe& lobe) {
  Results results;
  for (std::size_t t = 0; t < kTolerances.size(); ++t) {
    const Stopwatch watch;
    AlbedoOptions options;
    options.tolerance = kTolerances[t];
    options.max_evaluations = kMostEvaluations;
    const AlbedoResult r = directional_albedo(lobe.term, 0, radians(lobe.theta), {}, options);
    results[t] = {r.value, r.evaluations, r.converged, watch.seconds()};
  }
  return results;
}

Results product_gauss(const Lobe& lobe) {
  Milestones milestones;
  Block block(lobe);
  double previous = HUGE_VAL;
  for (int n = 16; block.evaluations + long(n) * n <= kMostEvaluations && !milestones.done(); n *= 2) {
    const double value = product(block, n);
    milestones.at(value, std::abs(value - previous), block.evaluations);
    previous = value;
  }
  return milestones.results;
}

Results adaptive_cubature(const Lobe& lobe) {
  Results results;
  for (std::size_t t = 0; t < kTolerances.size(); ++t) {
    const Stopwatch watch;
    Block block(lobe);
    const double low[] = {0, 0}, high[] = {kPi / 2, kPi};
    double value = 0, error = 0;
    hcubature_v(1, cubature_block, &block, 2, low, high, std::size_t(kMostEvaluations), 0, kTolerances[t],
                ERROR_INDIVIDUAL, &value, &error);
    results[t] = {2 * value, block.evaluations, error <= kTolerances[t] * std::abs(value), watch.seconds()};
  }
  return results;
}

Results visible_normals(const Lobe& lobe) {
  constexpr std::size_t kBatch = 1000;
  const auto [along, across] = info(lobe.term.form).axes();
  const std::span<const double> shape = lobe.term.shape_of(0);
  const Roughness<double> widths{shape[std::size_t(along)], shape[std::size_t(across)]};
  const Vec3<double> wo = direction(radians(lobe.theta), {});  // the lobe is reciprocal
  Random random(1);
  Milestones milestones;
  DirectionArrays<double> directions(kBatch);
  std::array<double, kBatch> values, density;
  double sum = 0, sum2 = 0;
  for (long count = 0; count < kMostEvaluations && !milestones.done();) {
    for (std::size_t k = 0; k < kBatch; ++k) {
      const double u1 = random.uniform(), u2 = random.uniform();
      const Vec3<double> wi = mirrored(wo, sample_visible_ggx(widths, u1, u2, wo));
      directions.set(k, wi, wo);
      density[k] = wi.z > 0 ? pdf_visible_ggx(widths, geometry(wi, wo)) : 1;
    }
    eval_cos_batch(lobe.term, 0, directions.view(), values.data());
    for (std::size_t k = 0; k < kBatch; ++k) {
      const double x = values[k] / density[k];
      sum += x;
      sum2 += x * x;
    }
    count += long(kBatch);
    const double mean = sum / double(count);
    const double error = std::sqrt(std::max(sum2 / double(count) - mean * mean, 0.0) / double(count - 1));
    milestones.at(mean, 2 * error, count);
  }
  return milestones.results;
}

}  // namespace brdf::bench
