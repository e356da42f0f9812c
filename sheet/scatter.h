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

// The result of rotations of the sample; unknown without enough of them.
enum class Isotropy { unknown, seen, refuted };

// A smooth error of an instrument (a drift, a tilt, smoothing of the table) leaves neighbours in agreement.
// Rows that are equal by symmetry reveal such an error.
struct Scatter {
  io::Noise neighbours;  // noise about an interpolant that is smooth in the directions
  // One entry for each kind with at least 8 pairs of values that are not copies of each other.
  std::vector<Agreement> agreements;
  Isotropy isotropy = Isotropy::unknown;
  // Returns the largest estimate that no other estimate refutes; std::nullopt if there is no estimate.
  // `may_be_isotropic`: false if the user states the opposite.
  std::optional<double> value(bool may_be_isotropic = true) const;
  // Returns the noise that is known to be there. It is less than value() if only an isotropic sample makes
  // rows equal that differ, and no rotation shows that the sample is isotropic.
  std::optional<double> least(bool may_be_isotropic = true) const;
  // Returns the agreement that takes the place of the neighbours' noise; null if none does. It is the largest
  // one that exceeds this noise by more than the uncertainty that the number of pairs permits. Or it is the
  // smallest one, if mirrored or reciprocal rows agree so much better that the neighbours' noise must hold
  // the shape of a lobe: asymmetry only adds to their differences.
  const Agreement* decisive(bool may_be_isotropic = true) const;
};

// Estimates the noise. `pairs`: reciprocal pairs; pass an empty list if a cause makes the pairs differ.
// Rows beyond 80 degrees are omitted from the agreements, since errors of an angle grow there.
Scatter scatter_of(const View& view, io::Noise neighbours, const std::vector<Pair>& pairs, Isotropy isotropy);

}  // namespace brdf::sheet
