#include "fit/assess/hidden_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

constexpr double kWeight = 0.04;                            // of the lobe that may be hidden
constexpr double kNarrowestLobe = 1e-4, kWidestLobe = 0.3;  // range of tested widths
constexpr int kWidths = 14;
constexpr double kErrors = 3;  // a lobe is visible if its weight exceeds this many standard errors
constexpr double kUnknownScatter = 0.05, kLeastScatter = 0.005;
constexpr double kLeastValue = 0.01;  // relative to the median: assumed size of values close to zero

// Ward's lobe (1992, equation 4) with weight 1 at every row, for any width.
struct WardLobe {
  std::vector<double> slope_squared, scale;  // tan^2 theta_h; 1/(4 pi sqrt(cos_i cos_o))

  explicit WardLobe(const FitData& data) {
    for (std::size_t k = 0; k < data.rows(); ++k) {
      const double x = data.wi_x[k] + data.wo_x[k], y = data.wi_y[k] + data.wo_y[k],
                   z = data.wi_z[k] + data.wo_z[k];
      slope_squared.push_back((x * x + y * y) / (z * z));
      scale.push_back(1 / (4 * std::numbers::pi * std::sqrt(data.wi_z[k] * data.wo_z[k])));
    }
  }
  double at(std::size_t k, double alpha) const {
    return scale[k] * std::exp(-slope_squared[k] / (alpha * alpha)) / (alpha * alpha);
  }
};

// Returns whether a lobe of this width would be visible in a channel with values of these standard
// deviations.
bool is_seen(const WardLobe& lobe, const std::vector<double>& values, const std::vector<double>& noise,
             double alpha) {
  double own = 0, mixed = 0, of_lobe = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double f = values[k] / noise[k], l = lobe.at(k, alpha) / noise[k];
    own += f * f;
    mixed += f * l;
    of_lobe += l * l;
  }
  const double information = of_lobe - (own > 0 ? mixed * mixed / own : 0);
  return kWeight * std::sqrt(std::max(information, 0.0)) > kErrors;
}

}  // namespace

std::optional<double> hidden_width(const FitData& data, std::optional<double> scatter) {
  const WardLobe lobe(data);
  const double share = std::max(scatter.value_or(kUnknownScatter), kLeastScatter);
  double narrowest = kWidestLobe;
  for (const std::vector<double>& values : data.values) {
    std::vector<double> sizes;
    for (const double f : values) sizes.push_back(std::abs(f));
    const double least = std::max(kLeastValue * io::median(sizes), 1e-12);
    std::vector<double> noise;
    for (const double f : sizes) noise.push_back(share * std::max(f, least));
    // Start with the narrowest width: wider lobes may be visible although narrower ones are not.
    double seen = kNarrowestLobe;
    for (int k = 0; k < kWidths; ++k) {
      const double alpha = kNarrowestLobe * std::pow(kWidestLobe / kNarrowestLobe, k / double(kWidths - 1));
      if (is_seen(lobe, values, noise, alpha)) {
        seen = alpha;
        break;
      }
      seen = kWidestLobe;
    }
    narrowest = std::min(narrowest, seen);
  }
  if (narrowest <= kNarrowestLobe) return std::nullopt;
  return narrowest;
}

}  // namespace brdf::fit
