// The choice of rows one after another, and rows at random to compare with.
#pragma once

#include <vector>

#include "brdf/random.h"
#include "fit/design/next_rows.h"
#include "fit/design/rivals.h"

namespace brdf::fit {

// Candidates in the order of the choice, each with its gain (NextRow::gain), and for two forms with the
// difference of their logarithms. The first ones, `for_parameters` of them, determine the parameters.
struct Chosen {
  std::vector<std::size_t> order;
  std::vector<double> gains, differences;
  std::size_t for_parameters = 0;
};

// Choose `count` of the free candidates, of which there are at least as many. `repeats`: readings for which
// each row of the start stands. If no error of the form is known, the first rows for the prediction, one more
// than the form has parameters, determine the parameters (Determination). Later rows lower the variance over
// the hemisphere. Unless the caller states that there is no error, they guard against one as large as the
// noise, which the residuals would not show.
Chosen choose_for_prediction(const Rows& rows, double repeats, const NoiseAndError& known,
                             std::vector<bool> free, std::size_t count);
Chosen choose_for_forms(const Rows& a, const Rows& b, const NoiseAndError& known, std::vector<bool> free,
                        std::size_t count);

// Returns the two models as rivals. An error of the models counts as noise.
Rivals rivals_of(const Rows& a, const Rows& b, const NoiseAndError& known);

// Returns `count` of the free candidates in random order, or all of them if there are fewer.
std::vector<std::size_t> drawn(const std::vector<bool>& free, std::size_t count, Random& random);

}  // namespace brdf::fit
