#pragma once

#include <cstdint>
#include <random>

namespace brdf::synth {

// Pairs of independent standard normal numbers (Box and Muller 1958). The engine's bits are fixed by the
// standard, but std::normal_distribution is not: this is the same on every machine.
class NormalPairs {
 public:
  explicit NormalPairs(std::uint64_t seed) : bits_(seed) {}
  struct Pair {
    double first, second;
  };
  Pair next();

 private:
  std::mt19937_64 bits_;
};

}  // namespace brdf::synth
