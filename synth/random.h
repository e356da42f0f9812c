// Random numbers that are the same on every machine.
// Generates random numbers that are the same on every machine.
#pragma once

#include <cstdint>
#include <random>

namespace brdf::synth {

// Generates pairs of independent standard normal numbers (Box and Muller 1958). They are the same on every
// machine: the standard specifies the bits of the engine, but not std::normal_distribution.
class NormalPairs {
 public:
  explicit NormalPairs(std::uint64_t seed) : bits_(seed) {}
  struct Pair {
    double first, second;
  };
  // Returns the next pair.
  Pair next();

 private:
  std::mt19937_64 bits_;
};

}  // namespace brdf::synth
