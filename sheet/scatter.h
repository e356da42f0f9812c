// How much the values of a table scatter, by every kind of rows that ought to agree.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "io/samples/noise.h"
#include "sheet/pairs.h"
#include "sheet/view.h"

namespace brdf::sheet {

// Rows that ought to agree: what they differ by, and how many differences tell it.
struct Agreement {
  std::string_view rows;  // "mirrored", "reciprocal", "repeated"
  double value;           // relative standard deviation of one value
  std::size_t count;      // pairs of rows
  bool needs_isotropy;    // an anisotropic sample makes them differ, too
};

// A smooth error of an instrument (a drift, a tilt, a table that was smoothed) leaves neighbours in
// agreement; rows that a symmetry makes equal show it.
struct Scatter {
  io::Noise neighbours;               // about a law that is smooth in the directions
  std::vector<Agreement> agreements;  // each of 8 pairs or more whose values are no copies of each other
  bool is_isotropic = true;           // no turn of the sample shows the opposite
  // The largest of all; none where nothing is known. `isotropic`: whether the sample may be taken for
  // isotropic.
  std::optional<double> value(bool isotropic) const;
  std::optional<double> value() const { return value(is_isotropic); }
  // The agreement that is largest, if it is larger than the neighbours' scatter by more than so few pairs
  // allow; else null.
  const Agreement* largest(bool isotropic) const;
};

// `pairs`: reciprocal ones; none where a cause makes them differ. Rows beyond 80 degrees are left out of
// agreements, since errors of an angle grow there.
Scatter scatter_of(const View& view, io::Noise neighbours, const std::vector<Pair>& pairs, bool is_isotropic);

}  // namespace brdf::sheet
