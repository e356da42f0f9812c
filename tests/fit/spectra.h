// Returns a metal of many bands, `apart` nm from each other, with an f0 that rises with wavelength, on a
// faint diffuse term.
#pragma once

#include <cmath>

#include "tests/fit/samples.h"

namespace brdf::fit {

inline Material metal_of_bands(int apart) {  // nm
  std::vector<std::string> bands;
  for (int nm = 400; nm <= 700; nm += apart) bands.push_back(std::to_string(nm) + "nm");
  Material m = make_material(*find_form("cook_torrance"), bands);
  m.terms[0].shape[0] = {0.2, 0.2};
  for (std::size_t k = 0; k < bands.size(); ++k) {
    const double nm = 400 + apart * double(k);
    m.terms[0].weights[k] = {0.05 + 0.03 * std::sin(nm / 40), 0.95,
                             0.5 + 0.4 / (1 + std::exp((560 - nm) / 25))};
  }
  return m;
}

inline Material metal_of_31_bands() {
  return metal_of_bands(10);
}

}  // namespace brdf::fit
