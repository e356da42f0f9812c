// Random numbers of the simulations: one independent stream for each (seed, surface, purpose), so that the
// work can be shared among any number of threads.
#pragma once

#include <cstdint>
#include <random>

namespace brdf::micro {

enum class Stream : std::uint32_t { geometry, scatter, radiance, exchange, masking };

class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t surface, Stream purpose) {
    std::seed_seq words{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                        static_cast<std::uint32_t>(surface), static_cast<std::uint32_t>(purpose)};
    engine_.seed(words);
  }
  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Standard normal.
  double normal() { return normal_(engine_); }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
};

}  // namespace brdf::micro
