#include "validate/joint/jacobian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "io/files/numbers.h"

namespace brdf::validate {
namespace {

using Vector = Vec3<double>;

Vector difference_of(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
double length_of(const Vector& a) {
  return std::sqrt(dot(a, a));
}
double area_of(const Vector& a, const Vector& b) {
  return length_of({a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x});
}

using Numbers = std::vector<double>;

class Inverse {
 public:
  Inverse(const Trio& trio, std::uint64_t seed)
      : trio_(trio), width_(trio.facts().randoms), used_(std::min(trio.randoms_used(), width_)) {
    for_draws(trio, kStock, seed, [&](std::span<const double> u, std::span<const Draw> draws) {
      for (std::size_t k = 0; k < draws.size(); ++k)
        if (counts(trio.facts(), draws[k]))
          stock_.push_back({Numbers(u.begin() + long(k * width_), u.begin() + long((k + 1) * width_)),
                            draws[k].wi, draws[k].pdf});
    });
  }

  struct Stock {
    Numbers u;
    Vector wi;
    double pdf;
  };
  static constexpr std::size_t kStock = 4096;  // draws, of which those that count are kept
  const std::vector<Stock>& stock() const { return stock_; }
  std::size_t used() const { return used_; }

  // The density that these random numbers and the other values of a choice contribute at their direction.
  // std::nullopt near a boundary between branches, and if other than two numbers move the direction.
  std::optional<double> density_at(const Numbers& u, std::string& why) const {
    const std::vector<Vector> by = derivatives(u);
    if (by.empty()) return std::nullopt;
    std::vector<std::size_t> moving;
    for (std::size_t j = 0; j < used_; ++j)
      if (length_of(by[j]) > kMoves) moving.push_back(j);
    if (moving.size() != 2) {
      why = "the direction depends on " + std::to_string(moving.size()) + " random numbers at once";
      return std::nullopt;
    }
    const double area = area_of(by[moving[0]], by[moving[1]]);
    if (!(area > 1e-12)) return std::nullopt;
    double probability = 1;
    std::vector<Choice> choices;
    for (std::size_t j = 0; j < used_; ++j) {
      if (j == moving[0] || j == moving[1]) continue;
      Choice choice = choice_of(u, j);
      probability *= choice.share;
      choices.push_back(std::move(choice));
    }
    if (choices.size() > 1 && !are_independent(u, choices)) {
      why = "a choice depends on several random numbers together";
      return std::nullopt;
    }
    return probability / area;
  }

  // All random numbers, up to choices without effect, that lead to the direction.
  std::vector<Numbers> leading_to(const Vector& target, bool thorough) const {
    std::vector<Numbers> at = starts(target, thorough);
    std::vector<Solution> found;
    for (int step = 0; step < kMostSteps && !at.empty(); ++step) {
      // Each start takes one draw and two for each number that may move.
      const std::size_t rows = 1 + 2 * used_;
      Numbers u;
      for (const Numbers& one : at) {
        u.insert(u.end(), one.begin(), one.end());
        for (std::size_t j = 0; j < used_; ++j)
          for (const double sign : {-1.0, 1.0}) {
            Numbers moved = one;
            moved[j] = std::clamp(moved[j] + sign * kNewtonStep, 0.0, 1.0);
            u.insert(u.end(), moved.begin(), moved.end());
          }
      }
      const std::vector<Draw> draws = trio_.draw(u);
      std::vector<Numbers> next;
      for (std::size_t k = 0; k < at.size(); ++k) {
        const Draw* const own = draws.data() + k * rows;
        const Vector miss = difference_of(target, own->wi);
        if (length_of(miss) < kHit) {
          if (counts(trio_.facts(), *own)) add(found, at[k], own);
          continue;
        }
        if (auto moved = newton(at[k], own, miss)) next.push_back(std::move(*moved));
      }
      at = std::move(next);
    }
    std::vector<Numbers> out;
    for (Solution& s : found) out.push_back(std::move(s.u));
    return out;
  }

 private:
  static constexpr double kStep = 2e-4, kMoves = 1e-7, kNewtonStep = 1e-7, kHit = 1e-9, kSame = 1e-6;
  static constexpr int kMostSteps = 14;

  // Central differences of fourth order; empty if the second order differs, as at a boundary.
  std::vector<Vector> derivatives(const Numbers& u) const {
    Numbers rows;
    for (std::size_t j = 0; j < used_; ++j) {
      if (u[j] < 2 * kStep || u[j] > 1 - 2 * kStep) return {};
      for (const double times : {-2.0, -1.0, 1.0, 2.0}) {
        Numbers moved = u;
        moved[j] += times * kStep;
        rows.insert(rows.end(), moved.begin(), moved.end());
      }
    }
    const std::vector<Draw> draws = trio_.draw(rows);
    std::vector<Vector> out;
    for (std::size_t j = 0; j < used_; ++j) {
      const Vector inner = difference_of(draws[4 * j + 2].wi, draws[4 * j + 1].wi),
                   outer = difference_of(draws[4 * j + 3].wi, draws[4 * j].wi);
      const auto fourth = [](double a, double b) { return (8 * a - b) / (12 * kStep); };
      const Vector by{fourth(inner.x, outer.x), fourth(inner.y, outer.y), fourth(inner.z, outer.z)};
      const Vector second{inner.x / (2 * kStep), inner.y / (2 * kStep), inner.z / (2 * kStep)};
      if (!(length_of(difference_of(by, second)) <= 1e-4 * length_of(by) + 1e-9)) return {};
      out.push_back(by);
    }
    return out;
  }

  // The values of one random number for which the direction stays the same. `share` of them is the
  // probability of the choice.
  struct Choice {
    std::size_t number;
    double share = 0;
    std::vector<std::pair<double, double>> parts = {};

    bool holds(double x) const {
      return std::ranges::any_of(parts, [&](const auto& p) { return p.first <= x && x <= p.second; });
    }
  };

  // Returns whether the draw has the direction of `here`, and counts if that one counts.
  bool same_sample(const Draw& draw, const Draw& here) const {
    return length_of(difference_of(draw.wi, here.wi)) < kHit &&
           counts(trio_.facts(), draw) == counts(trio_.facts(), here);
  }

  Choice choice_of(const Numbers& u, std::size_t j) const {
    constexpr int kGrid = 64;
    const Draw here = trio_.draw_one(u);
    Numbers rows;
    for (int k = 0; k < kGrid; ++k) {
      Numbers moved = u;
      moved[j] = (k + 0.5) / kGrid;
      rows.insert(rows.end(), moved.begin(), moved.end());
    }
    const std::vector<Draw> draws = trio_.draw(rows);
    Choice out{j};
    const auto add = [&](double from, double to) {
      out.parts.emplace_back(from, to);
      out.share += to - from;
    };
    bool before = same_sample(draws[0], here);
    double from = 0;
    for (int k = 1; k < kGrid; ++k) {
      const bool now = same_sample(draws[std::size_t(k)], here);
      if (now == before) continue;
      double low = (k - 0.5) / kGrid, high = (k + 0.5) / kGrid;
      for (int step = 0; step < 44; ++step) {
        Numbers moved = u;
        moved[j] = (low + high) / 2;
        (same_sample(trio_.draw_one(moved), here) == before ? low : high) = moved[j];
      }
      if (before) add(from, low);
      from = low;
      before = now;
    }
    if (before) add(from, 1);
    return out;
  }

  // Returns whether the choices by several numbers are independent, so that their probabilities multiply. The
  // choices of a loop that rejects points are not: each depends on two numbers together.
  bool are_independent(const Numbers& u, const std::vector<Choice>& choices) const {
    constexpr int kGrid = 8;
    const Draw here = trio_.draw_one(u);
    for (std::size_t a = 0; a < choices.size(); ++a)
      for (std::size_t b = a + 1; b < choices.size(); ++b) {
        Numbers rows;
        std::vector<bool> expected;
        for (int k = 0; k < kGrid * kGrid; ++k) {
          Numbers moved = u;
          const double x = (k % kGrid + 0.5) / kGrid, y = (k / kGrid + 0.5) / kGrid;
          moved[choices[a].number] = x, moved[choices[b].number] = y;
          rows.insert(rows.end(), moved.begin(), moved.end());
          expected.push_back(choices[a].holds(x) && choices[b].holds(y));
        }
        const std::vector<Draw> draws = trio_.draw(rows);
        for (std::size_t k = 0; k < draws.size(); ++k)
          if (same_sample(draws[k], here) != expected[k]) return false;
      }
    return true;
  }

  std::optional<Numbers> newton(const Numbers& u, const Draw* own, const Vector& miss) const {
    // The two numbers that move the direction most.
    std::vector<std::pair<double, std::size_t>> order;
    std::vector<Vector> by;
    for (std::size_t j = 0; j < used_; ++j) {
      const double low = std::clamp(u[j] - kNewtonStep, 0.0, 1.0),
                   high = std::clamp(u[j] + kNewtonStep, 0.0, 1.0);
      const Vector d = difference_of(own[2 + 2 * j].wi, own[1 + 2 * j].wi);
      by.push_back({d.x / (high - low), d.y / (high - low), d.z / (high - low)});
      order.emplace_back(-length_of(by.back()), j);
    }
    if (order.size() < 2) return std::nullopt;
    std::ranges::sort(order);
    const std::size_t a = order[0].second, b = order[1].second;
    const double aa = dot(by[a], by[a]), ab = dot(by[a], by[b]), bb = dot(by[b], by[b]);
    const double determinant = aa * bb - ab * ab;
    if (!(determinant > 1e-18 * aa * bb)) return std::nullopt;
    const double am = dot(by[a], miss), bm = dot(by[b], miss);
    double da = (bb * am - ab * bm) / determinant, db = (aa * bm - ab * am) / determinant;
    const double longest = std::max(std::abs(da), std::abs(db));
    if (!std::isfinite(longest)) return std::nullopt;
    if (longest > 0.1) da *= 0.1 / longest, db *= 0.1 / longest;
    Numbers out = u;
    out[a] = std::clamp(out[a] + da, 0.0, 1.0);
    out[b] = std::clamp(out[b] + db, 0.0, 1.0);
    if (out[a] == u[a] && out[b] == u[b]) return std::nullopt;
    return out;
  }

  // Random numbers that lead to a direction, and which of them move it.
  struct Solution {
    Numbers u;
    std::vector<bool> moves;
    std::vector<double> same = {};  // the largest difference of each number between two equal solutions
  };

  // Two solutions are the same if the numbers that move the direction agree; the others are choices, and the
  // share of each choice is counted with its solution.
  void add(std::vector<Solution>& found, const Numbers& u, const Draw* own) const {
    constexpr double kLeastSlope = 1e-4;
    Solution s{u, {}};
    for (std::size_t j = 0; j < used_; ++j) {
      const double moved = length_of(difference_of(own[2 + 2 * j].wi, own[1 + 2 * j].wi));
      s.moves.push_back(moved > kLeastSlope * kNewtonStep);
      // In a narrow lobe, directions that count as hits belong to numbers that differ by more.
      constexpr double kHits = 8;
      s.same.push_back(std::max(kSame, kHits * kHit * 2 * kNewtonStep / std::max(moved, 1e-300)));
    }
    for (const Solution& other : found) {
      bool same = other.moves == s.moves;
      for (std::size_t j = 0; j < used_ && same; ++j)
        same = !s.moves[j] || std::abs(other.u[j] - u[j]) < s.same[j];
      if (same) return;
    }
    found.push_back(std::move(s));
  }

  // The stock's nearest directions in each cell of a grid over the random numbers, so that every lobe of a
  // mixture is represented.
  std::vector<Numbers> starts(const Vector& target, bool thorough) const {
    constexpr std::size_t kInCell[] = {1, 4}, kNearest[] = {8, 64};
    const int sides[] = {0, 64, 8, 5, 4, 3};
    const int side = used_ < std::size(sides) ? sides[used_] : 2;
    std::map<std::size_t, std::vector<std::pair<double, std::size_t>>> cells;
    std::vector<std::pair<double, std::size_t>> all;
    for (std::size_t k = 0; k < stock_.size(); ++k) {
      std::size_t cell = 0;
      for (std::size_t j = 0; j < std::min<std::size_t>(used_, 8); ++j)
        cell = cell * std::size_t(side) + std::size_t(std::min(int(stock_[k].u[j] * side), side - 1));
      const double far = -dot(stock_[k].wi, target);
      cells[cell].emplace_back(far, k);
      all.emplace_back(far, k);
    }
    std::vector<std::size_t> chosen;
    const auto take = [&](auto& list, std::size_t count) {
      count = std::min(count, list.size());
      std::ranges::partial_sort(list, list.begin() + long(count));
      for (std::size_t k = 0; k < count; ++k) chosen.push_back(list[k].second);
    };
    take(all, kNearest[thorough]);
    for (auto& [cell, list] : cells) take(list, kInCell[thorough]);
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    std::vector<Numbers> out;
    for (const std::size_t k : chosen) out.push_back(stock_[k].u);
    return out;
  }

  const Trio& trio_;
  std::size_t width_, used_;
  std::vector<Stock> stock_;
};

bool is_short(const DensityRow& row) {
  return row.claimed > row.truth && !agree(row.claimed, row.truth, kJacobianBound);
}

// Returns whether far fewer draws lie near the directions of these rows than the claimed density predicts: in
// a cap about each direction that holds `kInCap` draws by the claimed density.
bool draws_are_too_few(const Inverse& inverse, std::span<const DensityRow> rows) {
  constexpr double kInCap = 40, kFarBelow = 6;  // kFarBelow: standard deviations
  double expected = 0, observed = 0;
  for (const DensityRow& row : rows) {
    if (!is_short(row)) continue;
    // A cap of this area; caps larger than 10 degrees would reach other parts of a lobe.
    const double area = kInCap / (double(Inverse::kStock) * row.claimed);
    const double cosine = std::max(1 - area / (2 * kPi), std::cos(10 * kPi / 180));
    expected += 2 * kPi * (1 - cosine) * double(Inverse::kStock) * row.claimed;
    for (const Inverse::Stock& s : inverse.stock()) observed += dot(s.wi, row.wi) > cosine;
  }
  return observed + kFarBelow * std::sqrt(expected) < expected;
}

}  // namespace

JacobianRows jacobian_rows(const Trio& trio, int probes, std::uint64_t seed) {
  constexpr int kMostThorough = 6;
  JacobianRows out;
  if (!trio.facts().draws) return out;
  if (trio.facts().randoms < 2) {
    out.why = "a draw takes fewer than 2 random numbers";
    return out;
  }
  constexpr std::size_t kMostNumbers = 6;  // the search takes a draw for each number and start
  if (trio.randoms_used() > kMostNumbers) {
    out.why = "a draw uses " + std::to_string(trio.randoms_used()) + " random numbers, more than " +
              std::to_string(kMostNumbers);
    return out;
  }
  const Inverse inverse(trio, seed);
  int thorough_misses = 0;
  std::size_t most_roots = 0;
  for (const auto& stock : inverse.stock()) {
    if (out.probes == probes) break;
    if (stock.wi.z < 0.01) continue;
    if (std::ranges::any_of(std::span(stock.u).first(inverse.used()),
                            [](double x) { return x < 1e-3 || x > 1 - 1e-3; }))
      continue;
    ++out.probes;
    if (!inverse.density_at(stock.u, out.why)) continue;
    const double claimed = trio.facts().has_density ? trio.density_of(stock.wi, trio.at().wo) : stock.pdf;
    double truth = 0;
    std::vector<DensityPart> parts;
    const auto sum_up = [&](bool thorough) {
      std::vector<Numbers> all = inverse.leading_to(stock.wi, thorough);
      bool whole = true;
      most_roots = std::max(most_roots, all.size());
      truth = 0;
      parts.clear();
      for (const Numbers& u : all) {
        const auto part = inverse.density_at(u, out.why);
        whole = whole && part;
        truth += part.value_or(0);
        parts.push_back({u, part.value_or(0)});
      }
      return whole && !all.empty();
    };
    if (!sum_up(false)) continue;
    // A density above the sum may only mean that a lobe was not found.
    if (claimed > truth && !agree(claimed, truth, kJacobianBound)) {
      if (thorough_misses == kMostThorough) continue;
      if (!sum_up(true)) continue;
      thorough_misses += !agree(claimed, truth, kJacobianBound);
    }
    out.rows.push_back({stock.wi, claimed, truth, stock.u, parts});
  }
  // Of several lobes one may lead to a direction by random numbers that the search did not find, close to the
  // end of a branch. If it found fewer numbers than at other directions, the sum is a lower bound, and only
  // draws can show that the claimed density is too large.
  const auto may_miss = [&](const DensityRow& row) { return is_short(row) && row.parts.size() < most_roots; };
  if (std::ranges::any_of(out.rows, may_miss) && !draws_are_too_few(inverse, out.rows)) {
    const std::size_t left_out = std::erase_if(out.rows, may_miss);
    out.why = "another lobe may lead to " + io::plural(left_out, "direction") +
              ", by random numbers that the search did not find";
  }
  return out;
}

}  // namespace brdf::validate
