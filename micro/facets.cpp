#include "micro/facets.h"

#include <algorithm>
#include <cmath>

#include "brdf/scalar.h"

namespace brdf::micro {

Vec normal(const Facet& f) {
  const double scale = 1 / std::sqrt(1 + f.slope_x * f.slope_x + f.slope_y * f.slope_y);
  return {-f.slope_x * scale, -f.slope_y * scale, scale};
}

Vec cosine_direction(const Facet& facet, Random& random) {
  // A uniform point on the unit sphere around the tip of the normal, as seen from the facet, is cosine
  // distributed.
  const double z = 2 * random.uniform() - 1, phi = 2 * kPi * random.uniform();
  const double r = std::sqrt(std::max(1 - z * z, 0.0));
  const Vec sum = normal(facet) + Vec{r * std::cos(phi), r * std::sin(phi), z};
  const double length = std::sqrt(dot(sum, sum));
  return length > 1e-9 ? sum * (1 / length) : normal(facet);
}

}  // namespace brdf::micro
