// Random test cases of integrals. The same seed gives the same cases on every platform.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "brdf/material.h"

namespace brdf::validate {

// One case: a term of one channel, and the fixed direction in radians.
struct IntegralCase {
  Term term;
  double theta, phi;
};

// Returns the cases of one set; empty if there is no such set. Every case has the lobe alone. "isotropic",
// "grazing" and "anisotropic" use the catalogue's first microfacet form. One set is named after the first
// form that has widths but no microfacets, and uses that form. "v_cavity" uses the first form with a
// V-cavity kink.
std::vector<IntegralCase> integral_cases(const std::string& set, std::uint64_t seed);
// Returns the names of the sets.
std::vector<std::string> integral_sets();

// Describes the case in words: form, shape, angles in degrees.
std::string place_of(const IntegralCase& c);

}  // namespace brdf::validate
