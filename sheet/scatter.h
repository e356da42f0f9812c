// Estimates the noise of a table's values from every kind of rows that should agree.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "io/samples/noise.h"
#include "sheet/pairs.h"
#include "sheet/view.h"

namespace brdf::sheet {

// The noise according to one kind of rows that should agree.
struct Agreement {
  std::string_view rows;  // "mirrored", "reciprocal", "repeated"
  double value;           // relative standard deviation of one value
  std::size_t count;      // pairs of rows
  bool needs_isotropy;    // these rows also differ if the sample is anisotropic
};

// A smooth error of an instrument (a drift, a tilt, smoothing of the table) leaves neighbours in agreement.
// Rows that are equal by symmetry reveal such an error.
struct Scatter {
  io::Noise neighbours;  // noise about an interpolant that is smooth in the directions
  // One entry for each kind with at least 8 pairs of values that are not copies of each other.
  std::vector<Agreement> agreements;
  bool is_isotropic = true;  // no rotation of the sample shows the opposite
  // Returns the largest estimate; std::nullopt if there is no estimate. `isotropic`: whether the sample may
  // be assumed to be isotropic.
  std::optional<double> value(bool isotropic) const;
  std::optional<double> value() const { return value(is_isotropic); }
  // Returns the largest agreement, if it exceeds the noise of the neighbours by more than the uncertainty
  // that the number of pairs permits; otherwise null.
  const Agreement* largest(bool isotropic) const;
};

// Estimates the noise. `pairs`: reciprocal pairs; pass an empty list if a cause makes the pairs differ.
// Rows beyond 80 degrees are omitted from the agreements, since errors of an angle grow there.
Scatter scatter_of(const View& view, io::Noise neighbours, const std::vector<Pair>& pairs, bool is_isotropic);

}  // namespace brdf::sheet
