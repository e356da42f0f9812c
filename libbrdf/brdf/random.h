// Seeded random numbers that are the same on every machine:
// the standard's engines are, its distributions are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace brdf {

// In [0, 1), from the upper 53 bits of a 64-bit engine's number.
template <class Engine>
double uniform01(Engine& engine) {
  static_assert(Engine::max() == ~std::uint64_t{0} && Engine::min() == 0);
  return double(engine() >> 11) * 0x1p-53;
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform() { return uniform01(engine_); }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace brdf
