// Where a material is too dark or too bright at its samples: over theta_h, the half vector's angle from the
// normal, and theta_d, the light's from the half vector (Rusinkiewicz 1998).
#pragma once

#include <limits>
#include <vector>

#include "brdf/material.h"
#include "io/samples/samples.h"

namespace brdf::measured {

// A table's rows in their cells, made ready once for one material after another.
class ResidualMap {
 public:
  static constexpr std::size_t kCells = 45;  // along each axis, of two degrees

  // `most_rows`: so many at most are looked at, with at least one of every cell; those of a cell are taken
  // evenly, always the same.
  explicit ResidualMap(const io::SampleTable& table,
                       std::size_t most_rows = std::numeric_limits<std::size_t>::max());

  // Of the rows that are looked at.
  Directions<double> directions() const { return directions_.view(); }

  // Mean ln(model/measured) of every cell, row by row from theta_d 0; NaN where no value above 0 was
  // measured. `model` is [channel of the table][row looked at]; an empty channel is left out.
  std::vector<double> cells(const std::vector<std::vector<double>>& model) const;
  // The same of a material, by its channels' counterparts; all NaN where it has none.
  std::vector<double> cells(const Material& material) const;

 private:
  std::vector<std::string> channels_;
  DirectionArrays<double> directions_;
  std::vector<std::size_t> cell_;            // of each row looked at
  std::vector<std::vector<double>> values_;  // measured, the same
};

}  // namespace brdf::measured
