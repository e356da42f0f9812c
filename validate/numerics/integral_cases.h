// Random cases of integrals, reproducible everywhere from their seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "brdf/random.h"

namespace brdf::validate {

// One case: a term of one channel and the fixed direction (radians).
struct IntegralCase {
  Term term;
  double theta, phi;
};

// Sets of lobes alone: "isotropic", "grazing" and "anisotropic" of the
// catalogue's first form of microfacets; a set named after the first form
// that has widths and no microfacets; "v_cavity" of the first with that kink.
std::vector<IntegralCase> integral_cases(const std::string& set, std::uint64_t seed);
std::vector<std::string> integral_sets();

// In words: form, shape, angles in degrees.
std::string place_of(const IntegralCase& c);

}  // namespace brdf::validate
