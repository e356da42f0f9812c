#include "fit/assess/errors.h"

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"

namespace brdf::fit {

RelativeErrors relative_errors(const FitData& data, const std::vector<std::vector<double>>& model,
                               const RowRange& range) {
  std::vector<double> errors;
  double off = 0, all = 0;
  for (std::size_t c = 0; c < model.size(); ++c)
    for (std::size_t k = range.first; k < range.first + range.rows; ++k) {
      const double f = model[c][k], g = data.values[c][k];
      if (!(g > 0)) continue;
      errors.push_back(std::abs(f - g) / g);
      const double light = std::max(f, g) * data.wi_z[k];
      all += light;
      if (f > 2 * g || g > 2 * f) off += light;
    }
  if (errors.empty()) return {0, 0, 0};
  return {io::median(errors), io::quantile(errors, 0.9), off / all};
}

double rms_error(const FitData& data, const std::vector<std::vector<double>>& model) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t c = 0; c < model.size(); ++c)
    for (std::size_t k = 0; k < data.rows(); ++k) {
      const double f = model[c][k], g = data.values[c][k];
      if (!(g > 0)) continue;
      sum += (f - g) * (f - g) / (g * g);
      ++count;
    }
  return count == 0 ? 0 : std::sqrt(sum / double(count));
}

}  // namespace brdf::fit
