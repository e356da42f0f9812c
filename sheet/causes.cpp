#include "sheet/causes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "brdf/angle.h"
#include "io/files/numbers.h"

namespace brdf::sheet {
namespace {

// The effect of a cause on each pair: log_ratio = size * lever. Pairs with a lever below `least` carry no
// information on the size.
struct Levers {
  std::vector<double> of_pairs;
  double least;
};

struct Weighted {
  double value, weight;
};

double weighted_median(std::vector<Weighted> values) {
  std::ranges::sort(values, [](const auto& a, const auto& b) { return a.value < b.value; });
  double half = 0, sum = 0;
  for (const Weighted& v : values) half += 0.5 * v.weight;
  for (const Weighted& v : values)
    if ((sum += v.weight) >= half) return v.value;
  return 0;
}

double cosine(double theta) {
  return std::cos(degrees(theta).radians());
}

class Search {
 public:
  Search(const View& view, const std::vector<Pair>& pairs) : view_(view), pairs_(pairs) {
    std::vector<double> sizes;
    for (const Pair& p : pairs) sizes.push_back(std::abs(p.log_ratio));
    difference_ = io::median(sizes);
    const double scatter = std::max(1.4826 * difference_, 0.005);
    for (const Pair& p : pairs) weights_.push_back(1 / std::hypot(scatter, p.uncertainty));
    nothing_ = remainder({}, 0);
  }

  double difference() const { return difference_; }

  Levers cosine_levers() const {
    return levers(0.3, [](const Pair& p) { return std::log(cosine(p.theta_a) / cosine(p.theta_b)); });
  }
  Levers drift_levers() const {
    return levers(0.2, [](const Pair& p) { return p.order; });
  }
  Levers gain_levers(std::size_t scan) const {
    return levers(0.5, [&](const Pair& p) { return double(p.scan_a == scan) - double(p.scan_b == scan); });
  }
  Levers dark_levers() const {
    const double middle = median_level();
    return levers(0.1, [&](const Pair& p) {
      return std::exp(middle - view_.level(p.forward)) / cosine(p.theta_b) -
             std::exp(middle - view_.level(p.backward)) / cosine(p.theta_a);
    });
  }

  // Estimates the size that removes most of the differences. Returns std::nullopt for fewer than four pairs
  // with a lever.
  std::optional<Explanation> explain(Cause cause, const Levers& levers,
                                     const std::vector<double>& before = {}) const {
    std::vector<Weighted> slopes;
    std::vector<double> told;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const double x = levers.of_pairs[k];
      if (std::abs(x) < levers.least) continue;
      const double slope = (pairs_[k].log_ratio - (before.empty() ? 0 : before[k])) / x;
      slopes.push_back({slope, weights_[k] * std::abs(x)});
      told.push_back(slope);
    }
    constexpr std::size_t kFewest = 4;
    if (told.size() < kFewest) return std::nullopt;
    Explanation e{cause,
                  weighted_median(std::move(slopes)),
                  io::quantile(told, 0.25),
                  io::quantile(told, 0.75),
                  0,
                  told.size(),
                  0};
    std::vector<double> residuals;
    for (const double slope : told) residuals.push_back(std::abs(slope - e.size));
    e.standard_error =
        1.2533 * 1.4826 * io::median(std::move(residuals)) / std::sqrt(0.5 * double(told.size()));
    const double left = before.empty() ? nothing_ : remainder(before);
    e.share = left > 0 ? 1 - remainder(levers.of_pairs, e.size, before) / left : 0;
    return e;
  }

  std::vector<double> effect(const Levers& levers, double size) const {
    std::vector<double> out;
    for (const double x : levers.of_pairs) out.push_back(size * x);
    return out;
  }

 private:
  template <class Of>
  Levers levers(double least, Of&& of) const {
    Levers out{{}, least};
    for (const Pair& p : pairs_) {
      const double x = of(p);
      out.of_pairs.push_back(std::isfinite(x) ? x : 0);
    }
    return out;
  }

  double median_level() const {
    std::vector<double> levels;
    for (const Pair& p : pairs_) levels.push_back(view_.level(p.forward));
    std::erase_if(levels, [](double x) { return std::isnan(x); });
    return io::median(std::move(levels));
  }

  // Returns the weighted sum of the absolute differences that remain.
  double remainder(const std::vector<double>& levers, double size,
                   const std::vector<double>& before = {}) const {
    double sum = 0;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      sum += weights_[k] * std::abs(pairs_[k].log_ratio - (before.empty() ? 0 : before[k]) -
                                    (levers.empty() ? 0 : size * levers[k]));
    return sum;
  }
  double remainder(const std::vector<double>& before) const { return remainder({}, 0, before); }

  const View& view_;
  const std::vector<Pair>& pairs_;
  std::vector<double> weights_;
  double difference_, nothing_;
};

// Returns the light with the gain that explains most, with the share of the rest that another light
// explains.
std::optional<Explanation> one_light(const Search& search, const std::vector<Pair>& pairs) {
  constexpr std::size_t kFewestLights = 3;  // with two lights, the wrong one cannot be identified
  std::set<std::size_t> scans;
  for (const Pair& p : pairs) scans.insert({p.scan_a, p.scan_b});
  std::optional<Explanation> best;
  std::size_t lights = 0;
  for (const std::size_t s : scans) {
    auto e = search.explain(Cause::gain, search.gain_levers(s));
    if (!e) continue;
    ++lights;
    e->scan = s;
    if (!best || e->share > best->share) best = e;
  }
  if (!best || lights < kFewestLights) return std::nullopt;
  const std::vector<double> taken = search.effect(search.gain_levers(best->scan), best->size);
  for (const std::size_t s : scans) {
    if (s == best->scan) continue;
    if (const auto e = search.explain(Cause::gain, search.gain_levers(s), taken))
      best->others = std::max(best->others, e->share);
  }
  return best;
}

bool excludes_0(const Explanation& e) {
  constexpr double kShare = 0.35;
  const double sign = e.size > 0 ? 1 : -1;
  return std::min(sign * e.low, sign * e.high) > kShare * std::abs(e.size);
}

// Applies the rule of each cause: the least size that matters, and the position of the quartiles.
bool holds(const Explanation& e) {
  constexpr double kCertain = 3;  // standard errors
  if (!excludes_0(e) || std::abs(e.size) < kCertain * e.standard_error) return false;
  switch (e.cause) {
    case Cause::cosine: {
      const double sign = e.size > 0 ? 1 : -1, near = 0.2, widest = 0.7;
      return std::abs(e.size - sign) < near && e.high - e.low < widest && e.low < sign + near &&
             e.high > sign - near && e.share > 0.2;
    }
    case Cause::gain:
      return std::abs(e.size) > 0.06 && e.share > 2 * (1 - e.share) * e.others;
    case Cause::drift:
      return std::abs(e.size) > 0.1 && e.share > 0.05;
    case Cause::dark_level:
      return std::abs(e.size) > 0.02 && e.share > 0.3;
  }
  return false;
}

}  // namespace

Causes causes_of(const View& view, const std::vector<Pair>& pairs) {
  Causes out;
  out.pairs = pairs.size();
  if (pairs.size() < kFewestPairs) return out;
  const Search search(view, pairs);
  out.difference = search.difference();
  const auto add = [&](const std::optional<Explanation>& e) {
    if (e) out.tried.push_back(*e);
  };
  add(search.explain(Cause::cosine, search.cosine_levers()));
  add(search.explain(Cause::drift, search.drift_levers()));
  add(search.explain(Cause::dark_level, search.dark_levers()));
  if (!view.scans().empty()) add(one_light(search, pairs));
  std::ranges::stable_sort(out.tried, std::greater(), &Explanation::share);
  // A dark level acts like a weak cosine: it must explain clearly more than a cause that is more common.
  constexpr double kClearly = 0.8;
  if (out.tried.size() > 1 && out.tried[0].cause == Cause::dark_level &&
      1 - out.tried[0].share > kClearly * (1 - out.tried[1].share))
    std::swap(out.tried[0], out.tried[1]);
  if (out.tried.empty() || !holds(out.tried.front())) return out;
  const Explanation& best = out.tried.front();
  out.found = best;
  const double rival = out.tried.size() > 1 ? out.tried[1].share : 0;
  out.is_certain =
      best.share > 0.25 && best.share > 1.1 * rival && std::abs(best.size) > 5 * best.standard_error;
  return out;
}

}  // namespace brdf::sheet
