#include "validate/search.h"

#include <algorithm>
#include <cmath>

namespace brdf::validate {
namespace {

double safe(double value) {
  return std::isnan(value) ? -HUGE_VAL : value;
}

// Tries both neighbours along every axis; true where one was better.
bool explore(const Objective& f, std::vector<double>& point, double& value, double step, long& calls) {
  bool moved = false;
  for (double& x : point) {
    const double here = x;
    for (const double direction : {1.0, -1.0}) {
      x = std::clamp(here + direction * step, 0.0, 1.0);
      if (x == here) continue;
      ++calls;
      const double there = safe(f(point));
      if (there > value) {
        value = there;
        moved = true;
        break;
      }
      x = here;
    }
  }
  return moved;
}

Best climb(const Objective& f, std::vector<double> point, double value, const SearchOptions& options) {
  long calls = 0;
  double step = 0.1;
  for (int k = 0; k < options.steps && step > options.finest; ++k) {
    const std::vector<double> base = point;
    if (!explore(f, point, value, step, calls)) {
      step *= 0.35;
      continue;
    }
    // Once more as far in the same direction.
    std::vector<double> ahead = point;
    for (std::size_t d = 0; d < ahead.size(); ++d) ahead[d] = std::clamp(2 * point[d] - base[d], 0.0, 1.0);
    ++calls;
    double there = safe(f(ahead));
    explore(f, ahead, there, step, calls);
    if (there > value) {
      point = ahead;
      value = there;
    }
  }
  return {point, value, calls};
}

}  // namespace

std::vector<double> cover_point(std::size_t k, std::size_t dimensions, std::uint64_t seed) {
  double ratio = 2;  // root of x^(d+1) = x + 1
  for (int step = 0; step < 60; ++step) ratio = std::pow(1 + ratio, 1.0 / double(dimensions + 1));
  std::vector<double> point;
  double stride = 1;
  for (std::size_t d = 0; d < dimensions; ++d) {
    stride /= ratio;
    const double shift = 0.5 + 0.618033988749895 * double(seed % 1000003) * double(d + 1);
    double whole;
    point.push_back(std::modf(shift + stride * double(k + 1), &whole));
  }
  return point;
}

Best maximise(const Objective& f, std::size_t dimensions, const SearchOptions& options,
              const std::vector<std::vector<double>>& extra) {
  std::vector<std::vector<double>> points = extra;
  for (std::size_t k = 0; k < options.cover; ++k) points.push_back(cover_point(k, dimensions, options.seed));
  std::vector<double> values;
  for (const auto& point : points) values.push_back(safe(f(point)));
  std::vector<std::size_t> order(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  Best best{points[order[0]], values[order[0]], long(points.size())};
  if (dimensions == 0) return best;
  for (std::size_t k = 0; k < std::min(options.starts, order.size()); ++k) {
    const Best found = climb(f, points[order[k]], values[order[k]], options);
    best.calls += found.calls;
    if (found.value > best.value) {
      best.point = found.point;
      best.value = found.value;
    }
  }
  return best;
}

}  // namespace brdf::validate
