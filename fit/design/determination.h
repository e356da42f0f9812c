// Directions that determine the parameters of a model together, in the metric of the fit.
#pragma once

#include "fit/design/design_rows.h"

namespace brdf::fit {

// The covariance of the parameters of a fit to the rows read so far (D-optimal choice), in the fit's own
// metric and under noise that is proportional to the value, as in Forecast.
class Determination {
 public:
  // `start`: rows that were measured, each for `repeats` readings. `noise`: relative, of one reading.
  Determination(const DesignRows& start, double repeats, const DesignRows& candidates,
                const DesignRows& hemisphere, double noise);

  // Returns for every candidate by how much a reading there lowers the logarithm of the determinant of the
  // covariance. A reading of high weight and much noise may raise it.
  std::vector<double> falls() const;
  // Takes a reading at a candidate into account.
  void read(std::size_t candidate);

 private:
  const DesignRows& candidates_;
  RowMatrix normal_, scatter_;  // the covariance is normal^-1 scatter normal^-1, times the variance of noise
};

}  // namespace brdf::fit
