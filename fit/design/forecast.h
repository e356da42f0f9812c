// What a fit to the measured rows and to further rows is expected to achieve, before the rows are measured.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/design/design_rows.h"
#include "fit/design/expected.h"

namespace brdf::fit {

// A forecast of the fit in its own metric, in first order about the solution. The widths contain the noise
// alone, as the standard errors of `brdf fit` do. The error of prediction also contains the error of the
// model: the fit leaves it where it is.
class Forecast {
 public:
  // `start`: rows that were measured, each for `repeats` readings. The references must outlive the forecast.
  Forecast(const Solved& solved, const DesignRows& start, double repeats, const DesignRows& candidates,
           const DesignRows& hemisphere, const NoiseAndError& known);

  // Returns the widths of all parameters that are not held, with the rows of these candidates added.
  std::vector<ExpectedWidth> widths(std::span<const std::size_t> added) const;
  // Returns the root mean square error of ln f over the hemisphere and the channels.
  double prediction_error(std::span<const std::size_t> added) const;

 private:
  // A row of the fit to come: the start's rows first.
  struct Row {
    const DesignRows* of;
    std::size_t number;
    double repeats;
  };
  std::vector<Row> rows_with(std::span<const std::size_t> added) const;
  // The inverse of the normal matrix of some rows, with the prior, and the mean weight of a row.
  struct Normal {
    RowMatrix inverse;
    double weight;
  };
  Normal normal_of(const std::vector<Row>& rows) const;

  const Solved& solved_;
  const DesignRows &start_, &candidates_, &hemisphere_;
  double repeats_;
  NoiseAndError known_;
  Eigen::VectorXd prior_;
};

}  // namespace brdf::fit
