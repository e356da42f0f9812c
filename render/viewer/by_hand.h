// What the caller lends the window, so that a hand and the solver work side by side: rendering knows nothing
// of fits.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/samples/samples.h"

namespace brdf::render {

// Between which values a parameter of a fitted material lies, 95 %.
struct Interval {
  std::size_t term = 0;
  bool is_weight = false;     // else of the shape
  std::size_t parameter = 0;  // its place in the form's table
  std::size_t channel = 0;    // of weights; of shapes the set, for all that there are
  double low = 0, high = 0;
};

struct Fitted {
  Material material;
  std::vector<Interval> intervals;
  std::string words;  // what it is worth, one line
};

struct Solver {
  // Median of |material - measured|/measured over the table's values above 0; not a number where there are
  // none.
  std::function<double(const Material&, const io::SampleTable&)> error;
  // Goes on from this material; where `stop` is set, returns the best so far. Throws InputError.
  std::function<Fitted(const Material&, const io::SampleTable&, const std::atomic<bool>& stop)> fit;
};

}  // namespace brdf::render
