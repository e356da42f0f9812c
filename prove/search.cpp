#include "prove/search.h"

#include <chrono>
#include <cmath>

namespace brdf::prove {
namespace {

using Clock = std::chrono::steady_clock;

struct Search {
  const Domain& domain;
  const std::function<Bounds(const Box&)>& enclose;
  const std::function<bool(Bounds)>& decided;
  const SearchOptions& options;
  Clock::time_point start = Clock::now();
  std::vector<int> cuts = std::vector<int>(domain.variables.size());  // on the way to this box
  Cover result{};
  long leaves = 1;
  bool started = false;

  Bounds bounds_of(const Box& box) {
    ++result.boxes;
    return enclose(box);
  }
  bool exhausted() const {
    return leaves >= options.leaves ||
           std::chrono::duration<double>(Clock::now() - start).count() > options.seconds;
  }

  void put_leaf(const Box& box, Bounds b, bool open) {
    Cover::Node node;
    node.bounds = b;
    node.open = open;
    result.range = result.nodes.empty() || !started
                       ? b
                       : Bounds{std::fmin(result.range.lo, b.lo), std::fmax(result.range.hi, b.hi)};
    started = true;
    if (open) {
      ++result.open;
      if (result.left.size() < Cover::kListed) result.left.push_back(box);
    }
    result.nodes.push_back(node);
  }

  // The cut that gains most: first by halves that are decided, then by halves that become bounded, then by
  // the rise of the lower bounds. If nothing gains, the variable that was cut least often is chosen.
  struct Choice {
    int variable = -1;
    double cut = 0, score = -1;
    Bounds first{}, second{};
  };
  double gain(Bounds half, Bounds parent) const {
    if (decided(half)) return 100;
    if (!std::isfinite(half.lo)) return 0;
    if (!std::isfinite(parent.lo)) return 10;
    return std::fmin(1, std::fmax(0, (half.lo - parent.lo) / -parent.lo));
  }
  Choice best_cut(const Box& box, Bounds parent) {
    Choice best;
    for (std::size_t k = 0; k < box.size(); ++k) {
      const double at = cut_of(domain.variables[k], box[k]);
      if (!(box[k].lo < at && at < box[k].hi)) continue;
      Box half = box;
      half[k].hi = at;
      const Bounds first = bounds_of(half);
      half[k] = {at, box[k].hi};
      const Bounds second = bounds_of(half);
      // Halving a weight halves the negative part with it, without end.
      const double score = (gain(first, parent) + gain(second, parent) + 1e-3 / (1 + cuts[k])) *
                           (domain.variables[k].weight ? 1e-6 : 1);
      if (score > best.score) best = {int(k), at, score, first, second};
    }
    return best;
  }

  void divide(const Box& box, Bounds b) {
    if (decided(b)) return put_leaf(box, b, false);
    if (exhausted()) return put_leaf(box, b, true);
    const Choice choice = best_cut(box, b);
    if (choice.variable < 0) return put_leaf(box, b, true);
    Cover::Node node;
    node.variable = choice.variable;
    node.cut = choice.cut;
    result.nodes.push_back(node);
    ++leaves;
    const std::size_t k = std::size_t(choice.variable);
    ++cuts[k];
    Box half = box;
    half[k].hi = choice.cut;
    divide(half, choice.first);
    half[k] = {choice.cut, box[k].hi};
    divide(half, choice.second);
    --cuts[k];
  }
};

}  // namespace

Box whole(const Domain& domain) {
  Box box;
  for (const Variable& v : domain.variables) box.push_back({v.low, v.high});
  return box;
}

Cover cover(const Domain& domain, const std::function<Bounds(const Box&)>& enclose,
            const std::function<bool(Bounds)>& decided, const SearchOptions& options) {
  Search search{domain, enclose, decided, options};
  const Box box = whole(domain);
  search.divide(box, search.bounds_of(box));
  return std::move(search.result);
}

}  // namespace brdf::prove
