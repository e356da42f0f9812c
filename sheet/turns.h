// What a turn of the sample changes.
#pragma once

#include <cstddef>
#include <optional>

#include "sheet/view.h"

namespace brdf::sheet {

// Of pairs of rows whose directions are equal but for the sample's turn, which light along the normal leaves
// to the viewer's azimuth, the absolute logarithm of the ratio of their values. A logarithm has no largest
// value: a factor of 20 is not taken for noise of 180 %.
struct Turns {
  std::size_t turns = 0, differences = 0;
  double median = 0, far = 0;     // far: all but one of fifty lie below it
  std::optional<double> scatter;  // relative, of one value about its neighbours; none where it is not known
  // How far the differences of an isotropic sample would reach by noise alone: the median, and the far ones.
  double noise_of_median() const, noise_of_far() const;
  bool is_anisotropic() const;
  static constexpr std::size_t kFewest = 4;
};

Turns turns_of(const View& view, std::optional<double> scatter);

}  // namespace brdf::sheet
