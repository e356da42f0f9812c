#include "prove/largest_albedo.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <queue>

#include "io/parallel.h"

namespace brdf::prove {
namespace {

using Clock = std::chrono::steady_clock;

Views views_of(const Box& box) {
  return {box[0], box.size() > 1 ? box[1] : Bounds{0, 0}};
}

// Of a grid of views, the one that is likely to reflect most.
Views brightest(const SumOfAlbedos& albedo) {
  constexpr std::size_t kTurns = 64, kAzimuths = 4;
  constexpr double kGlance = 0.01;
  const std::size_t azimuths = albedo.turns() ? kAzimuths + 1 : 1;
  const auto view = [&](std::size_t k) {
    const double turn = double(k / azimuths) / kTurns, azimuth = double(k % azimuths) / kAzimuths;
    return Views{{turn, turn}, {azimuth, azimuth}};
  };
  std::vector<double> likely((kTurns + 1) * azimuths);
  io::parallel_for(likely.size(), [&](std::size_t k) {
    const Bounds b = albedo(view(k), kGlance).value;
    likely[k] = b.lo + b.hi;
  });
  return view(std::size_t(std::ranges::max_element(likely) - likely.begin()));
}

// How well ever finer cells know the albedo of one view.
struct Steps {
  static constexpr std::array<double, 4> accuracies{8e-3, 2e-3, 5e-4, 1.25e-4};
  std::array<double, 4> widths{};
  double low = 0;  // that it reflects at least

  Steps(const SumOfAlbedos& albedo, const Views& view) {
    io::parallel_for(accuracies.size(), [&](std::size_t k) {
      const Bounds b = albedo(view, accuracies[k]).value;
      widths[k] = b.hi - b.lo;
      if (k + 1 == accuracies.size()) low = b.lo;
    });
  }
};

struct Region {
  Box box;
  Bounds bounds{};
  std::size_t cut = 0;  // the variable that more of its width is of
  bool operator<(const Region& other) const { return bounds.hi < other.bounds.hi; }
};

// As few cells as it takes to decide, or to see that finer ones would not: a step gains less than the one before it.
Region examined(const SumOfAlbedos& albedo, const Steps& steps, double most, Box box) {
  constexpr double kMostlyCells = 3, kNear = 0.1, kSmall = 1.0 / 64;
  const auto size = [&](std::size_t k) { return box[k].hi - box[k].lo; };
  AlbedoBounds found;
  double before = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < steps.widths.size(); ++k) {
    found = albedo(views_of(box), steps.accuracies[k]);
    const auto [low, high] = found.value;
    const double width = high - low;
    const bool apart =
        !(width < std::max(kNear, kMostlyCells * steps.widths[k])) && (k > 0 || size(0) > kSmall);
    if (high <= most || apart || high - (before - width) > most) break;
    before = width;
  }
  Region r{box, {found.value.lo, std::min(found.value.hi, std::numeric_limits<double>::max())}, 0};
  if (box.size() > 1)
    r.cut = (found.reach[0] == found.reach[1] ? size(0) >= size(1) : found.reach[0] > found.reach[1]) ? 0 : 1;
  return r;
}

}  // namespace

LargestAlbedo largest_of(const SumOfAlbedos& albedo, double half_width, const SearchOptions& options) {
  const Clock::time_point start = Clock::now();
  LargestAlbedo found;
  found.domain.variables.push_back({"turn_from_normal", 0, 1, Variable::Cut::middle});
  if (albedo.turns()) found.domain.variables.push_back({"turn_from_first_axis", 0, 1, Variable::Cut::middle});
  const Steps steps(albedo, brightest(albedo));
  found.low = steps.low;
  const double most = found.low + 2 * half_width;

  std::priority_queue<Region> open;
  double decided = 0;  // the most of what needs no more
  const auto keep = [&](Region r) {
    ++found.cover.boxes;
    if (r.bounds.hi <= most)
      decided = std::max(decided, r.bounds.hi);
    else
      open.push(std::move(r));
  };
  keep(examined(albedo, steps, most, whole(found.domain)));
  const auto exhausted = [&] {
    return found.cover.boxes >= options.leaves ||
           std::chrono::duration<double>(Clock::now() - start).count() > options.seconds;
  };
  while (!open.empty() && !exhausted()) {
    std::vector<Box> halves;
    for (std::size_t k = 0; k < 4 && !open.empty(); ++k, open.pop()) {
      const Region& r = open.top();
      const double at = cut_of(found.domain.variables[r.cut], r.box[r.cut]);
      halves.insert(halves.end(), 2, r.box);
      halves.end()[-2][r.cut].hi = halves.end()[-1][r.cut].lo = at;
    }
    std::vector<Region> parts(halves.size());
    io::parallel_for(halves.size(),
                     [&](std::size_t k) { parts[k] = examined(albedo, steps, most, halves[k]); });
    for (Region& r : parts) keep(std::move(r));
  }
  found.cover.range = {found.low, std::max(open.empty() ? decided : open.top().bounds.hi, found.low)};
  found.cover.open = long(open.size());
  for (; !open.empty() && found.cover.left.size() < Cover::kListed; open.pop())
    found.cover.left.push_back(open.top().box);
  return found;
}

}  // namespace brdf::prove
