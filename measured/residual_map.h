// Maps the error of a material at its samples: over theta_h, the angle of the half vector from the normal,
// and theta_d, the angle of incidence from the half vector (Rusinkiewicz 1998).
#pragma once

#include <limits>
#include <vector>

#include "brdf/material.h"
#include "io/samples/samples.h"

namespace brdf::measured {

// The rows of a table sorted into cells. The object is prepared once and serves several materials.
class ResidualMap {
 public:
  static constexpr std::size_t kCells = 45;  // along each axis, of two degrees each

  // `most_rows`: uses at most this number of rows, but at least one of every cell. The rows of a cell are
  // selected evenly; the selection is deterministic.
  explicit ResidualMap(const io::SampleTable& table,
                       std::size_t most_rows = std::numeric_limits<std::size_t>::max());

  // Returns the directions of the rows that are used.
  Directions<double> directions() const { return directions_.view(); }

  // Returns the mean ln(model/measured) of every cell, row by row from theta_d 0; NaN for cells without a
  // positive measured value. `model` is [channel of the table][row used]; an empty channel is left out.
  std::vector<double> cells(const std::vector<std::vector<double>>& model) const;
  // Evaluates a material in the same way, using the counterparts of the channels. All cells are NaN if
  // there are no counterparts.
  std::vector<double> cells(const Material& material) const;

 private:
  std::vector<std::string> channels_;
  DirectionArrays<double> directions_;
  std::vector<std::size_t> cell_;            // of each row used
  std::vector<std::vector<double>> values_;  // measured values of these rows
};

}  // namespace brdf::measured
