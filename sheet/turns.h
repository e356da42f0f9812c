// The effect of rotations of the sample on the values.
#pragma once

#include <cstddef>
#include <optional>

#include "sheet/scatter.h"
#include "sheet/view.h"

namespace brdf::sheet {

// Statistics of pairs of rows with directions that are equal except for the rotation of the sample. With
// the light along the normal, the viewer's azimuth acts as the rotation. The statistics are of the absolute
// logarithm of the ratio of the two values. A logarithm has no largest value: a factor of 20 is not
// mistaken for noise of 180 %.
struct Turns {
  std::size_t turns = 0, differences = 0;
  double median = 0, far = 0;     // far: the 98 % quantile; 49 of 50 differences are below it
  std::optional<double> scatter;  // relative noise of one value about its neighbours; std::nullopt if unknown
  // Returns the median, or the 98 % quantile, that the noise alone would give for an isotropic sample. A
  // noise that is unknown is taken as 10 %.
  double noise_of_median() const, noise_of_far() const;
  // Returns whether the differences exceed the noise clearly.
  bool is_anisotropic() const;
  // Isotropy is seen if enough comparisons stay within a known noise.
  Isotropy isotropy() const;
  static constexpr std::size_t kFewest = 4, kEnough = 16;
};

// Compares the rows of scans. `scatter`: relative noise of one value.
Turns turns_of(const View& view, std::optional<double> scatter);

}  // namespace brdf::sheet
