#include "prove/largest_albedo.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <queue>

#include "io/files/parallel.h"

namespace brdf::prove {
namespace {

using Clock = std::chrono::steady_clock;

// Returns the view of a grid that is likely to reflect most.
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

// The accuracy of the albedo of one view with finer and finer cells.
struct Steps {
  static constexpr auto accuracies = SumOfAlbedos::kAccuracies;
  std::array<double, accuracies.size()> widths{};
  double low = 0, high = 0;  // the narrowest bounds of the albedo

  Steps(const SumOfAlbedos& albedo, const Views& view) {
    io::parallel_for(accuracies.size(), [&](std::size_t k) {
      const Bounds b = albedo(view, accuracies[k]).value;
      widths[k] = b.hi - b.lo;
      if (k + 1 == accuracies.size()) low = b.lo, high = b.hi;
    });
  }
};

struct Region {
  Box box;
  Bounds bounds{};
  std::size_t cut = 0;  // the variable that contributes more to the width
  double accuracy = 0;
  std::size_t node = 0;  // of the tree
  bool operator<(const Region& other) const { return bounds.hi < other.bounds.hi; }
};

// A tree of regions that grows at any leaf. It is put into the order of a cover only at the end.
struct GrowingTree {
  struct Node {
    Cover::Node node;
    std::size_t first = 0;  // index of its first half if it was cut; the second half follows
  };
  std::vector<Node> nodes{Node{}};

  void cut(std::size_t k, int variable, double at) {
    nodes[k].node.variable = variable;
    nodes[k].node.cut = at;
    nodes[k].first = nodes.size();
    nodes.insert(nodes.end(), 2, Node{});
  }
  void put(std::vector<Cover::Node>& out, std::size_t k = 0) const {
    out.push_back(nodes[k].node);
    if (nodes[k].node.variable < 0) return;
    put(out, nodes[k].first);
    put(out, nodes[k].first + 1);
  }
};

// Examines a box with as few cells as suffice to decide, or to see that finer cells would not decide: each
// step gains less than the step before.
Region examined(const SumOfAlbedos& albedo, const Steps& steps, double most, Box box) {
  constexpr double kMostlyCells = 3, kNear = 0.1, kSmall = 1.0 / 64;
  const auto size = [&](std::size_t k) { return box[k].hi - box[k].lo; };
  AlbedoBounds found;
  double before = std::numeric_limits<double>::infinity(), accuracy = 0;
  for (std::size_t k = 0; k < steps.widths.size(); ++k) {
    accuracy = steps.accuracies[k];
    found = albedo(SumOfAlbedos::views_of(box), accuracy);
    const auto [low, high] = found.value;
    const double width = high - low;
    const bool apart =
        !(width < std::max(kNear, kMostlyCells * steps.widths[k])) && (k > 0 || size(0) > kSmall);
    if (high <= most || apart || high - (before - width) > most) break;
    before = width;
  }
  Region r{box, SumOfAlbedos::within_range(found.value), 0, accuracy};
  if (box.size() > 1)
    r.cut = (found.reach[0] == found.reach[1] ? size(0) >= size(1) : found.reach[0] > found.reach[1]) ? 0 : 1;
  return r;
}

}  // namespace

LargestAlbedo largest_of(const SumOfAlbedos& albedo, double half_width, double limit,
                         const SearchOptions& options) {
  const Clock::time_point start = Clock::now();
  LargestAlbedo found;
  found.domain = albedo.domain();
  found.low_at = brightest(albedo);
  const Steps steps(albedo, found.low_at);
  found.low = steps.low;
  const double near = found.low + 2 * half_width;
  const double most = steps.high <= limit ? std::min(near, limit) : near;

  std::priority_queue<Region> open;
  double decided = 0;  // the largest upper bound of the decided regions
  GrowingTree tree;
  const auto keep = [&](Region r) {
    ++found.cover.boxes;
    Cover::Node& leaf = tree.nodes[r.node].node;
    leaf.bounds = r.bounds;
    leaf.accuracy = r.accuracy;
    leaf.open = r.bounds.hi > most;
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
    std::vector<std::size_t> nodes;
    for (std::size_t k = 0; k < 4 && !open.empty(); ++k, open.pop()) {
      const Region& r = open.top();
      const double at = cut_of(found.domain.variables[r.cut], r.box[r.cut]);
      halves.insert(halves.end(), 2, r.box);
      halves.end()[-2][r.cut].hi = halves.end()[-1][r.cut].lo = at;
      tree.cut(r.node, int(r.cut), at);
      nodes.insert(nodes.end(), {tree.nodes.size() - 2, tree.nodes.size() - 1});
    }
    std::vector<Region> parts(halves.size());
    io::parallel_for(halves.size(),
                     [&](std::size_t k) { parts[k] = examined(albedo, steps, most, halves[k]); });
    for (std::size_t k = 0; k < parts.size(); ++k) {
      parts[k].node = nodes[k];
      keep(std::move(parts[k]));
    }
  }
  found.cover.range = {found.low, std::max(open.empty() ? decided : open.top().bounds.hi, found.low)};
  found.cover.open = long(open.size());
  tree.put(found.cover.nodes);
  for (; !open.empty() && found.cover.left.size() < Cover::kListed; open.pop())
    found.cover.left.push_back(open.top().box);
  return found;
}

}  // namespace brdf::prove
