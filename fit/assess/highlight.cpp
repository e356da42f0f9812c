#include "fit/assess/highlight.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/half_angles.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::fit {
namespace {

constexpr double kContrast = 1.75, kExcess = 1.25;
constexpr std::size_t kFewestSeen = 3;
constexpr double kChance = 1e-3;
constexpr double kMatt = 1.5;           // a highlight of the model itself, as a multiple of its median value
constexpr Angle kAround = degrees(30);  // from the mirror direction: the region of a highlight
constexpr double kBrightest = 0.98;     // quantile

// Returns the cosine of the angle between the viewer and the mirror direction of the light.
double mirror_cosine(const FitData& data, std::size_t k) {
  return data.wi_z[k] * data.wo_z[k] - data.wi_x[k] * data.wo_x[k] - data.wi_y[k] * data.wo_y[k];
}

bool is_matt(const std::vector<double>& model, const std::vector<double>& mirror) {
  std::vector<double> around;
  for (std::size_t k = 0; k < model.size(); ++k)
    if (mirror[k] > std::cos(kAround.radians())) around.push_back(model[k]);
  return around.empty() || io::quantile(std::move(around), kBrightest) <= kMatt * io::median(model);
}

struct Row {
  double mirror, excess;  // cosine; ln(measured/model); both times the side
  std::size_t row;
  bool counts;
};

// Returns an upper bound of the probability that random draws from all rows put this many of the `count`
// rows among the `first` ones. The hypergeometric tail is bounded by relative entropy (Chvatal 1979), from
// both sides; the smaller bound is used.
double chance_of(double found, double first, double count, double all) {
  const auto bound = [found](double draws, double share) {
    const double a = found / draws;
    if (a <= share) return 0.0;
    return draws * (a * std::log(a / share) + (a < 1 ? (1 - a) * std::log((1 - a) / (1 - share)) : 0.0));
  };
  return std::exp(-std::max(bound(first, count / all), bound(count, first / all)));
}

// Returns the rows nearest to the mirror direction in which the counting rows cluster. Empty if chance can
// explain the cluster.
std::vector<Row> gathered(std::vector<Row> rows) {
  const auto count = std::size_t(std::ranges::count_if(rows, [](const Row& r) { return r.counts; }));
  if (count < kFewestSeen) return {};
  std::ranges::sort(rows, [](const Row& a, const Row& b) {
    return a.mirror != b.mirror ? a.mirror > b.mirror : a.row < b.row;
  });
  double least = kChance / double(count);
  std::size_t best = 0, found = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!rows[k].counts || ++found < kFewestSeen) continue;
    const double p = chance_of(double(found), double(k + 1), double(count), double(rows.size()));
    if (p < least) {
      least = p;
      best = k + 1;
    }
  }
  rows.resize(best);
  std::erase_if(rows, [](const Row& r) { return !r.counts; });
  return rows;
}

// Returns whether enough values are so far above the model (side 1) or below it (-1) that they might count.
// This test saves logarithms and quantiles if the model fits.
bool some_excess(const std::vector<double>& measured, const std::vector<double>& model, double excess,
                 int side) {
  const double ratio = std::exp(excess) * (1 - 1e-9);  // the margin keeps rounding from losing a value
  std::size_t found = 0;
  for (std::size_t k = 0; k < model.size(); ++k) {
    const double f = std::max(model[k], 1e-300), g = measured[k];
    found += g > 0 && (side > 0 ? g >= ratio * f : f >= ratio * g);
  }
  return found >= kFewestSeen;
}

// Finds rows of a missing highlight. `side` 1: values above the model near the mirror direction. `side` -1:
// values below the model away from the mirror direction, if the fit took the level of the highlight for
// that of the surface.
std::vector<Row> missing_highlight(const std::vector<double>& measured, const std::vector<double>& model,
                                   const std::vector<double>& mirror, double noise, int side) {
  const double contrast = std::max(std::log(kContrast), 5 * noise),
               least = std::max(std::log(kExcess), 5 * noise);
  if (!some_excess(measured, model, least, side) || !is_matt(model, mirror)) return {};
  std::vector<Row> rows;
  std::vector<double> excess;
  for (std::size_t k = 0; k < model.size(); ++k) {
    if (!(measured[k] > 0)) continue;
    rows.push_back({side * mirror[k], side * std::log(measured[k] / std::max(model[k], 1e-300)), k, false});
    excess.push_back(rows.back().excess);
  }
  if (excess.empty()) return {};
  const double base = io::quantile(std::move(excess), 0.25), bright = kMatt * io::median(model);
  for (Row& r : rows) r.counts = r.excess - base > contrast && r.excess > least && model[r.row] <= bright;
  return gathered(std::move(rows));
}

std::string finding_of(const FitData& data, const std::vector<Row>& rows, int side) {
  HalfAngleRange range;
  std::vector<double> excess;
  for (const Row& r : rows) {
    range.add(half_angles(data, r.row));
    excess.push_back(side * r.excess);
  }
  return std::string(
             side > 0
                 ? "the measurements have a highlight around the mirror direction that this form cannot "
                   "produce"
                 : "away from the mirror direction this form cannot become as dark as the measurements") +
         ": in " + io::plural(rows.size(), "row") + " (" + to_text(range) +
         ") measured values are typically " + io::short_number(std::exp(io::median(std::move(excess))), 2) +
         " times the fitted ones";
}

}  // namespace

Misfit judge_highlight(const FitData& data, const std::vector<std::vector<double>>& model,
                       std::optional<double> noise) {
  std::vector<double> mirror(data.rows());
  for (std::size_t k = 0; k < data.rows(); ++k) mirror[k] = mirror_cosine(data, k);
  for (const int side : {1, -1}) {
    std::vector<Row> most;
    for (std::size_t c = 0; c < model.size(); ++c)
      if (auto rows = missing_highlight(data.values[c], model[c], mirror, noise.value_or(0), side);
          rows.size() > most.size())
        most = std::move(rows);
    if (!most.empty()) return {true, finding_of(data, most, side)};
  }
  return {};
}

}  // namespace brdf::fit
