#include "prove/shader/albedo_bound.h"

#include <chrono>
#include <cmath>
#include <queue>

#include "prove/scalar/elementary.h"

namespace brdf::prove {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kFirstCosines = 4, kFirstTurns = 4;  // kFirstTurns: in each quarter of the azimuth
constexpr int kFewCells = 64, kManyCells = 2000, kMostCells = kManyCells << 7;

Bounds azimuth_of(double turn) {  // of a turn in [0, 2]
  const Bounds a = turn <= 1 ? angle_at(turn, 1 - turn) : angle_at(turn - 1, 2 - turn);
  const double quarter_lo = turn <= 1 ? 0 : kPiBounds.lo / 2, quarter_hi = turn <= 1 ? 0 : kPiBounds.hi / 2;
  return {quarter_lo + a.lo, quarter_hi + a.hi};
}

struct Viewers {
  Bounds cosine, turn;
  double most = 0, open = 0;  // its largest contribution, and the uncertain part of that

  bool operator<(const Viewers& other) const { return open < other.open; }
};

// Returns the projected solid angle, rounded upward.
double measure(const Bounds& cosine, const Bounds& turn) {
  const bool negative = turn.lo < 0;
  const double near = std::fabs(negative ? turn.hi : turn.lo), far = std::fabs(negative ? turn.lo : turn.hi);
  const double width = azimuth_of(far).hi - azimuth_of(near).lo;
  return 0.5 * (cosine.hi - cosine.lo) * (cosine.hi + cosine.lo) * width * (1 + 1e-14);
}

// Returns false if f may be NaN.
bool examine(const ViewerBounds& f, Viewers& v) {
  const Bounds b = f(v.cosine, v.turn);
  if (!std::isfinite(b.lo)) return false;
  const double size = measure(v.cosine, v.turn);
  v.most = std::max(b.hi, 0.0) * size;
  v.open = (std::max(b.hi, 0.0) - std::max(b.lo, 0.0)) * size;
  return true;
}

struct Region {
  Box box;
  double most;
  int cells = kManyCells;  // the limit of cells for this box
  bool operator<(const Region& other) const { return most < other.most; }
};

}  // namespace

double albedo_at_most(const ViewerBounds& f, double enough, int most_cells) {
  std::priority_queue<Viewers> cells;
  double sum = 0;
  int asked = 0;
  const auto add = [&](Viewers v) {
    ++asked;
    if (!examine(f, v)) return false;
    sum += v.most;
    cells.push(v);
    return true;
  };
  for (int j = 0; j < kFirstCosines; ++j)
    for (int k = -2 * kFirstTurns; k < 2 * kFirstTurns; ++k)
      if (!add({{double(j) / kFirstCosines, double(j + 1) / kFirstCosines},
                {double(k) / kFirstTurns, double(k + 1) / kFirstTurns}}))
        return HUGE_VAL;
  double before = sum;
  for (int next = asked + kFewCells; sum * (1 + 1e-12) > enough && asked < most_cells;) {
    // Half as many cells more must bring a good part of the missing gain; otherwise the box itself is too
    // wide.
    if (asked >= next) {
      if (before - sum < 0.1 * (sum - enough)) break;
      before = sum;
      next = asked + std::max(kFewCells, asked / 2);
    }
    const Viewers v = cells.top();
    cells.pop();
    sum -= v.most;
    Viewers low = v, high = v;
    // Cuts the longer side; the azimuth's side is scaled by the sine.
    const double middle = 0.5 * (v.cosine.lo + v.cosine.hi), sine = std::sqrt(1 - middle * middle);
    if (v.cosine.hi - v.cosine.lo > 1.5 * sine * (v.turn.hi - v.turn.lo))
      low.cosine.hi = high.cosine.lo = middle;
    else
      low.turn.hi = high.turn.lo = 0.5 * (v.turn.lo + v.turn.hi);
    if (!add(low) || !add(high)) return HUGE_VAL;
  }
  double total = 0;  // summed again: the running sum has the rounding errors of all subtractions
  for (; !cells.empty(); cells.pop()) total += cells.top().most;
  return total * (1 + 1e-12);
}

Cover bound_albedo(const Domain& domain, const std::function<ViewerBounds(const Box&)>& of, double enough,
                   const SearchOptions& options) {
  const auto start = Clock::now();
  Cover cover;
  const auto most_of = [&](const Box& box, int cells) {
    ++cover.boxes;
    return albedo_at_most(of(box), enough, cells);
  };
  std::priority_queue<Region> open;
  double decided = 0;
  const auto keep = [&](Region r) {
    if (r.most <= enough)
      decided = std::max(decided, r.most);
    else
      open.push(std::move(r));
  };
  keep({whole(domain), most_of(whole(domain), kManyCells)});
  const auto exhausted = [&] {
    return cover.boxes >= options.leaves ||
           std::chrono::duration<double>(Clock::now() - start).count() > options.seconds;
  };
  // Uses more cells if they bring the bound a good part of the way; otherwise the box is too wide.
  const auto refined = [&](Region& r) {
    if (!std::isfinite(r.most) || r.cells >= kMostCells) return false;
    const double before = r.most;
    r.cells *= 4;
    r.most = std::min(before, most_of(r.box, r.cells));
    return before - r.most > 0.25 * (before - enough);
  };
  while (!open.empty() && !exhausted()) {
    Region r = open.top();
    open.pop();
    if (refined(r)) {
      keep(std::move(r));
      continue;
    }
    double least = HUGE_VAL;
    std::vector<Region> best;
    for (std::size_t k = 0; k < domain.variables.size(); ++k) {
      const double cut = cut_of(domain.variables[k], r.box[k]);
      if (!(r.box[k].lo < cut && cut < r.box[k].hi)) continue;
      Box low = r.box, high = r.box;
      low[k].hi = high[k].lo = cut;
      const double first = most_of(low, kFewCells), second = most_of(high, kFewCells);
      // The sum distinguishes a cut that helps one half from a cut that helps neither.
      const double score = std::max(first, second) + 0.5 * std::min(first, second);
      if (!best.empty() && !(score < least)) continue;
      least = score;
      best = {{low, first, r.cells}, {high, second, r.cells}};
    }
    if (best.empty()) {
      open.push(r);
      break;
    }
    for (Region& half : best) {
      if (half.most > enough && std::isfinite(half.most))
        half.most = std::min(half.most, most_of(half.box, half.cells));
      keep(std::move(half));
    }
  }
  cover.range = {0, open.empty() ? decided : open.top().most};
  cover.open = long(open.size());
  for (; !open.empty() && cover.left.size() < Cover::kListed; open.pop())
    cover.left.push_back(open.top().box);
  return cover;
}

}  // namespace brdf::prove
