#include "validate/search/search.h"

#include <algorithm>
#include <cmath>

#include "brdf/low_discrepancy.h"
#include "brdf/random.h"
#include "io/files/parallel.h"

namespace brdf::validate {
namespace {

double safe(double value) {
  return std::isnan(value) ? -HUGE_VAL : value;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t d = 0; d < a.size(); ++d) largest = std::max(largest, std::abs(a[d] - b[d]));
  return largest;
}

// Tries both neighbours along every axis and returns whether a better one was found.
bool explore(const Objective& f, std::vector<double>& point, double& value, double step, long& calls) {
  bool moved = false;
  for (double& x : point) {
    const double here = x;
    for (const double sign : {1.0, -1.0}) {
      x = std::clamp(here + sign * step, 0.0, 1.0);
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

Best climb(const Objective& f, std::vector<double> point, double value, double step, double finest,
           int steps) {
  long calls = 0;
  for (int k = 0; k < steps && step > finest; ++k) {
    const std::vector<double> base = point;
    if (!explore(f, point, value, step, calls)) {
      step *= 0.35;
      continue;
    }
    // A further step of the same length in the same direction.
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

std::vector<std::vector<double>> cube_corners(std::size_t dimensions, std::size_t most) {
  std::vector<std::vector<double>> points(std::size_t{1} << std::min(dimensions, most),
                                          std::vector<double>(dimensions));
  for (std::size_t c = 0; c < points.size(); ++c)
    for (std::size_t d = 0; d < std::min(dimensions, most); ++d) points[c][d] = double(c >> d & 1);
  return points;
}

std::vector<double> cover_point(std::size_t k, std::size_t dimensions, std::uint64_t seed) {
  std::vector<double> point = additive_recurrence_steps(dimensions);
  for (std::size_t d = 0; d < dimensions; ++d) {
    const double shift = 0.5 + 0.618033988749895 * double(seed % 1000003) * double(d + 1);
    point[d] = additive_recurrence(shift, point[d], k + 1);
  }
  return point;
}

namespace {

// The function f, or the lowest value once the budget is used up.
Objective within(Budget* budget, const Objective& f) {
  if (!budget || !f) return f;
  return [budget, &f](std::span<const double> point) { return budget->take() ? f(point) : -HUGE_VAL; };
}

}  // namespace

Best maximise(const Objective& whole, std::size_t dimensions, const SearchOptions& options,
              const std::vector<std::vector<double>>& extra, const Objective& whole_exact) {
  const Objective f = within(options.budget, whole), exact = within(options.budget, whole_exact);
  std::vector<Best> points;
  const auto for_each_point = [&](auto&& work) {
    io::parallel_for(
        points.size(), [&](std::size_t k) { work(points[k]); },
        options.any_thread ? io::all_processors() : 1);
  };
  for (const auto& point : extra) points.push_back({point, 0, 1});
  for (std::size_t k = 0; k < options.cover; ++k)
    points.push_back({cover_point(k, dimensions, options.seed), 0, 1});
  for_each_point([&](Best& b) { b.value = safe(f(b.point)); });
  long calls = long(points.size());
  // Keeps the best points that are at least `apart` from one another: several climbs to one summit would
  // find nothing new.
  const auto keep_best = [&](std::size_t count, double apart) {
    std::ranges::stable_sort(points, std::greater(), &Best::value);
    std::vector<Best> kept;
    for (const Best& b : points)
      if (kept.size() < std::max<std::size_t>(count, 1) &&
          std::ranges::none_of(kept, [&](const Best& k) { return distance(k.point, b.point) < apart; }))
        kept.push_back(b);
    points = std::move(kept);
  };
  if (dimensions > 0) {
    keep_best(options.starts, 0.03);
    for_each_point([&](Best& b) { b = climb(f, b.point, b.value, 0.1, options.coarse, options.steps); });
    for (const Best& b : points) calls += b.calls;
    keep_best(options.polish, 10 * options.coarse);
    for_each_point([&](Best& b) {
      if (exact) b.value = safe(whole_exact(b.point));
      b = climb(exact ? exact : f, b.point, b.value, options.coarse, options.finest, options.steps);
    });
    for (const Best& b : points) calls += b.calls + 1;
  }
  keep_best(1, 0);
  points.front().calls = calls;
  return points.front();
}

Best maximise_rough(const Objective& f, std::size_t dimensions, std::size_t evaluations, std::uint64_t seed) {
  constexpr std::size_t kKept = 24;
  Random random(seed);
  std::vector<Best> kept;
  const auto better = [](const Best& a, const Best& b) { return a.value > b.value; };
  for (std::size_t k = 0; k < std::max<std::size_t>(evaluations / 4, 1); ++k) {
    std::vector<double> point = cover_point(k, dimensions, seed);
    const double value = safe(f(point));
    if (kept.size() == kKept && !(value > kept.back().value)) continue;
    if (kept.size() == kKept) kept.pop_back();
    Best one{std::move(point), value, 0};
    kept.insert(std::ranges::upper_bound(kept, one, better), std::move(one));
  }
  for (std::size_t k = evaluations / 4; k < evaluations; ++k) {
    std::size_t rank = std::size_t(double(kept.size()) * square(random.uniform()));
    std::vector<double> point = kept[rank].point;
    const std::size_t always = std::size_t(double(dimensions) * random.uniform());
    for (std::size_t d = 0; d < dimensions; ++d) {
      if (d != always && random.uniform() > 0.25) continue;
      const double step = random.log_uniform(1e-8, 0.5), sign = random.uniform() < 0.5 ? -1 : 1;
      point[d] =
          random.uniform() < 0.05 ? std::round(point[d]) : std::clamp(point[d] + sign * step, 0.0, 1.0);
    }
    const double value = safe(f(point));
    if (!(value > kept[rank].value)) continue;
    kept[rank] = {std::move(point), value, 0};
    for (; rank > 0 && better(kept[rank], kept[rank - 1]); --rank) std::swap(kept[rank], kept[rank - 1]);
  }
  kept.front().calls = long(evaluations);
  return kept.front();
}

}  // namespace brdf::validate
