#include "fit/design/chosen.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/design/determination.h"
#include "fit/design/prediction.h"

namespace brdf::fit {
namespace {

// Returns the position of the largest value among the candidates that may be chosen. Values within 1e-9 of
// it count as equal, so that rounding does not decide; the first of them is taken.
std::size_t best_of(const std::vector<double>& gains, const std::vector<bool>& free) {
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < gains.size(); ++k)
    if (free[k]) largest = std::max(largest, gains[k]);
  for (std::size_t k = 0; k < gains.size(); ++k)
    if (free[k] && gains[k] >= largest - 1e-9 * std::abs(largest)) return k;
  return 0;
}

}  // namespace

Chosen choose_for_prediction(const Rows& rows, double repeats, const NoiseAndError& known,
                             std::vector<bool> free, std::size_t count) {
  NoiseAndError guarded = known;
  if (known.error_from == ErrorFrom::undetected) guarded.error = known.noise;
  Prediction prediction(rows.start, repeats, rows.candidates, rows.hemisphere, guarded);
  Chosen out;
  const auto parameters = std::size_t(rows.start.parameters());
  if (!(known.error > 0)) {
    Determination determination(rows.start, repeats, rows.candidates, rows.hemisphere, known.noise);
    for (out.for_parameters = std::min(parameters + 1, count); out.order.size() < out.for_parameters;) {
      const std::vector<double> falls = determination.falls();
      const std::size_t k = best_of(falls, free);
      free[k] = false;
      determination.read(k);
      prediction.read(k);
      out.order.push_back(k);
      out.gains.push_back(1 - std::exp(-0.5 * falls[k] / double(parameters)));
    }
  }
  double variance = prediction.variance();
  while (out.order.size() < count) {
    const std::size_t k = best_of(prediction.falls(), free);
    free[k] = false;
    prediction.read(k);
    const double left = prediction.variance();
    out.order.push_back(k);
    out.gains.push_back(1 - std::sqrt(std::max(left, 0.0) / variance));
    variance = left;
  }
  return out;
}

Rivals rivals_of(const Rows& a, const Rows& b, const NoiseAndError& known) {
  return {a.start,
          a.candidates,
          a.hemisphere,
          b.start,
          b.candidates,
          b.hemisphere,
          std::hypot(known.noise, known.error)};
}

Chosen choose_for_forms(const Rows& a, const Rows& b, const NoiseAndError& known, std::vector<bool> free,
                        std::size_t count) {
  Rivals rivals = rivals_of(a, b, known);
  Chosen out;
  while (out.order.size() < count) {
    const std::vector<double> gains = rivals.gains();
    const std::size_t k = best_of(gains, free);
    free[k] = false;
    out.differences.push_back(rivals.difference(k));
    rivals.read(k);
    out.order.push_back(k);
    out.gains.push_back(gains[k]);
  }
  return out;
}

std::vector<std::size_t> drawn(const std::vector<bool>& free, std::size_t count, Random& random) {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < free.size(); ++k)
    if (free[k]) all.push_back(k);
  count = std::min(count, all.size());
  for (std::size_t k = 0; k < count; ++k) {
    const auto other = k + std::size_t(random.uniform() * double(all.size() - k));
    std::swap(all[k], all[std::min(other, all.size() - 1)]);
  }
  all.resize(count);
  return all;
}

}  // namespace brdf::fit
