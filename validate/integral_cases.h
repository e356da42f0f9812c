// Random cases of integrals, reproducible everywhere from their seed.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "brdf/material.h"

namespace brdf::validate {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // The library's distributions differ between implementations; this does not.
  double uniform() { return double(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }

 private:
  std::mt19937_64 engine_;
};

// One case: a term of one channel and the fixed direction (radians).
struct IntegralCase {
  Term term;
  double theta, phi;
};

// The cases of a set: isotropic, grazing, anisotropic, ward, v_cavity.
std::vector<IntegralCase> integral_cases(const std::string& set, std::uint64_t seed);
std::vector<std::string> integral_sets();

// In words: form, shape, angles in degrees.
std::string place_of(const IntegralCase& c);

}  // namespace brdf::validate
