#include "render/picture/dither.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "brdf/random.h"

namespace brdf::render {
namespace {

constexpr int kSide = kDitherTile, kCount = kSide * kSide;

// Points of a repeating tile, and the density of points round each place.
class Pattern {
 public:
  Pattern() {
    for (int k = 0; k < kCount; ++k) {
      const auto apart = [](int d) { return double(std::min(d, kSide - d)); };
      const double x = apart(k % kSide), y = apart(k / kSide);
      kernel_[std::size_t(k)] = std::exp(-(x * x + y * y) / (2 * 1.5 * 1.5));
    }
  }
  bool has(int at) const { return set_[std::size_t(at)]; }
  void toggle(int at) {
    const double sign = has(at) ? -1 : 1;
    set_[std::size_t(at)] = !has(at);
    for (int k = 0; k < kCount; ++k) {
      const int x = (k % kSide - at % kSide + kSide) % kSide, y = (k / kSide - at / kSide + kSide) % kSide;
      crowd_[std::size_t(k)] += sign * kernel_[std::size_t(y * kSide + x)];
    }
  }
  // The point with the highest density, and the place without a point with the lowest density.
  int tightest() const { return extreme(true); }
  int emptiest() const { return extreme(false); }

 private:
  int extreme(bool point) const {
    int best = -1;
    for (int k = 0; k < kCount; ++k) {
      if (has(k) != point) continue;
      const double here = crowd_[std::size_t(k)];
      if (best < 0 || (point ? here > crowd_[std::size_t(best)] : here < crowd_[std::size_t(best)])) best = k;
    }
    return best;
  }

  std::array<double, kCount> kernel_{}, crowd_{};
  std::array<bool, kCount> set_{};
};

// Returns a tenth of the places as points, spread evenly: the point with the highest density moves to the
// emptiest place until it no longer moves.
Pattern first_points(std::uint64_t seed) {
  Pattern pattern;
  Random random(seed);
  for (int placed = 0; placed < kCount / 10;) {
    const int at = int(random.uniform() * kCount);
    if (pattern.has(at)) continue;
    pattern.toggle(at);
    ++placed;
  }
  for (int moves = 0; moves < kCount; ++moves) {
    const int from = pattern.tightest();
    pattern.toggle(from);
    const int to = pattern.emptiest();
    pattern.toggle(to);
    if (to == from) break;
  }
  return pattern;
}

}  // namespace

std::vector<float> void_and_cluster(unsigned long long seed) {
  const Pattern first = first_points(seed);
  std::vector<float> thresholds(kCount);
  const auto rank = [&](int at, int place) { thresholds[std::size_t(at)] = (float(place) + 0.5f) / kCount; };
  int ones = 0;
  for (int k = 0; k < kCount; ++k) ones += first.has(k);
  Pattern falling = first, rising = first;
  for (int place = ones - 1; place >= 0; --place) {
    const int at = falling.tightest();
    falling.toggle(at);
    rank(at, place);
  }
  for (int place = ones; place < kCount; ++place) {
    const int at = rising.emptiest();
    rising.toggle(at);
    rank(at, place);
  }
  return thresholds;
}

float dither_threshold(int x, int y) {
  static const std::vector<float> tile = void_and_cluster(1);
  return tile[std::size_t(y % kSide * kSide + x % kSide)];
}

}  // namespace brdf::render
