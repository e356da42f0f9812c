// Seeded random numbers that are identical on every machine. The engines of the standard library guarantee
// this; its distributions do not.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>

#include "brdf/math.h"

namespace brdf {

// Returns a number in [0, 1) from the upper 53 bits of a number of a 64-bit engine.
template <class Engine>
double uniform01(Engine& engine) {
  static_assert(Engine::max() == ~std::uint64_t{0} && Engine::min() == 0);
  return double(engine() >> 11) * 0x1p-53;
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  explicit Random(std::seed_seq& seeds) : engine_(seeds) {}
  double uniform() { return uniform01(engine_); }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }
  // Returns a normal variate with mean 0 and variance 1: the pairs of Box and Muller in Marsaglia's polar
  // form, which needs no sine.
  double normal() {
    if (spare_) return *std::exchange(spare_, std::nullopt);
    double x, y, r2;
    do {
      x = uniform(-1, 1);
      y = uniform(-1, 1);
      r2 = x * x + y * y;
    } while (r2 >= 1 || r2 == 0);
    const double scale = std::sqrt(-2 * math::log(r2) / r2);
    spare_ = y * scale;
    return x * scale;
  }

 private:
  std::mt19937_64 engine_;
  std::optional<double> spare_;
};

}  // namespace brdf
