// The rows that a choice of directions works with: measured, to be chosen, and of the hemisphere.
#pragma once

#include "fit/design/design_rows.h"
#include "fit/design/next_directions.h"

namespace brdf::fit {

// The directions that can be chosen.
struct Reachable {
  FitData data;                   // with the values 1
  std::vector<std::size_t> rows;  // of the table
};
// Leaves out directions that lie beyond options.max_theta, that are in `start` or that are given before, and
// counts them in `out`. Throws InputError if there are too many directions.
Reachable reachable(const io::SampleTable& reach, const FitData& start, const FitOptions& options,
                    NextDirections& out);

// A solved model at all rows.
struct Rows {
  DesignRows start, candidates, hemisphere;
};
Rows rows_of(const Solved& solved, const FitData& start, const FitData& candidates,
             const FitOptions& options);
// Gives the candidates the weights that the fit to come will give them: from the noise if the rows of `start`
// are weighted by their standard deviations, or from the solid angles.
void weigh(const FitData& candidates, const FitData& start, double noise, Rows& rows);
// Keeps three channels at most, the first, the middle and the last one.
Rows of_few_channels(const Rows& rows);

// Returns the noise that the caller states, that of the columns of sigma, that of the table, or that of the
// residuals, in this order; and the error of the model.
NoiseAndError known_of(const Prepared& prepared, const FitData& start, const DesignRows& rows,
                       const std::string& source, const NextOptions& next);

}  // namespace brdf::fit
