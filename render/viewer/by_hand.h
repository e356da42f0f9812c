// Functions that the caller passes to the window, so that users can combine manual changes with the solver.
// Rendering itself does not depend on fits.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/samples/samples.h"

namespace brdf::render {

// The 95 % confidence interval of a parameter of a fitted material.
struct Interval {
  std::size_t term = 0;
  bool is_weight = false;     // false: a shape parameter
  std::size_t parameter = 0;  // index in the form's table
  // Channel of a weight. For a shape parameter, the index of the set; a single set applies to all channels.
  std::size_t channel = 0;
  double low = 0, high = 0;
};

struct Fitted {
  Material material;
  std::vector<Interval> intervals;
  std::string words;  // quality of the fit, one line
};

struct Solver {
  // Returns the median of |material - measured|/measured over the table's values above 0; NaN if there are
  // no such values.
  std::function<double(const Material&, const io::SampleTable&)> error;
  // Fits, starting from this material. If `stop` is set, returns the best result so far. Throws InputError.
  std::function<Fitted(const Material&, const io::SampleTable&, const std::atomic<bool>& stop)> fit;
};

}  // namespace brdf::render
