// The noise that the catalogue's samplers would have for somebody else's reflectance.
#pragma once

#include <string>

#include "validate/joint/trio.h"

namespace brdf::validate {

struct CatalogueNoise {
  std::string form = {};  // empty: no sampler of the catalogue has its parameters in the subject's roles
  double noise = 0;       // relative standard deviation of one sample
};

// Returns the form of the catalogue whose sampler gives the least variance of f cos_i / pdf for this case. A
// form is tried if the subject has a parameter of the same role for each of its shape parameters; a width
// across the tangent may be the only width. `truth`: the albedo of the channel.
CatalogueNoise least_noise_of_catalogue(const Trio& trio, std::size_t channel, double truth,
                                        std::uint64_t seed);

}  // namespace brdf::validate
