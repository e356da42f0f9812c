// The maps of a page as pictures with colour bars, and the planes that they show.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "maps/stack_fit.h"

namespace brdf::maps {

// Returns the planes that hold parameters, without planes about their uncertainty.
std::vector<std::size_t> parameter_planes(const texel::Planes& maps);

// Returns a plane in which unidentified values are replaced by NaN.
std::vector<float> told(const texel::Planes& maps, std::size_t plane);

struct Range {
  double low = 0, high = 0;  // the first and the last percentile; NaN if there are no values
  std::size_t count = 0;
};

// Returns the range of the finite values.
Range range_of(const std::vector<float>& values);

// Returns the maps as one row of figures in HTML: the verdicts with the name, colour and count of each,
// then a map for each parameter and for the residual, with a colour bar and a histogram. Planes with
// equal values share one map. Fitted texels without an identifiable value are hatched.
std::string figures_of(const texel::Planes& maps, const Summary& summary);

}  // namespace brdf::maps
