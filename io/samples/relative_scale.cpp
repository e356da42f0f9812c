#include "io/samples/relative_scale.h"

#include <algorithm>

#include "io/files/error.h"
#include "io/samples/degrees.h"

namespace brdf::io {

void make_relative(SampleTable& table) {
  double largest = 0;
  for (const auto& values : table.values) {
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < table.rows(); ++k) {
      const double weight = cos_degrees(table.theta_i[k]) * cos_degrees(table.theta_o[k]);
      sum += weight * values[k];
      weights += weight;
    }
    if (weights > 0) largest = std::max(largest, sum / weights);
  }
  if (!(largest > 0))
    throw InputError(table.name() + ": no mean value is above 0, so the scale is undefined");
  const double scale = kPi * largest;
  for (auto* columns : {&table.values, &table.sigma})
    for (auto& column : *columns)
      for (double& value : column) value /= scale;
  table.scale *= scale;
}

}  // namespace brdf::io
