#include "fit/assess/highlight.h"

#include <algorithm>
#include <boost/math/distributions/hypergeometric.hpp>
#include <cmath>
#include <numeric>

#include "fit/assess/half_angles.h"
#include "io/numbers.h"
#include "io/text.h"

namespace brdf::fit {
namespace {

constexpr double kContrast = 1.75, kExcess = 1.25;
constexpr std::size_t kFewest = 3;
constexpr double kChance = 1e-3;
constexpr double kMatt = 1.5;           // a model's own highlight, as a multiple of its middle value
constexpr Angle kAround = degrees(30);  // from the mirror direction: where a highlight would be
constexpr double kBrightest = 0.98;     // quantile

// Cosine between the viewer and the mirror direction of the light.
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
  double mirror, excess;  // ln(measured/model)
  std::size_t row;
  bool counts;
};

// The rows nearest to the mirror direction in which those that count gather; none where chance would do.
std::vector<Row> gathered(std::vector<Row> rows) {
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.mirror != b.mirror ? a.mirror > b.mirror : a.row < b.row;
  });
  const auto all = unsigned(rows.size());
  const auto count = unsigned(std::count_if(rows.begin(), rows.end(), [](const Row& r) { return r.counts; }));
  if (count < kFewest || count == all) return {};
  double least = kChance / double(count);
  std::size_t best = 0;
  unsigned found = 0;
  for (unsigned k = 0; k < all; ++k) {
    if (!rows[k].counts || ++found < kFewest) continue;
    const boost::math::hypergeometric_distribution<> chance(count, k + 1, all);
    const double p = boost::math::cdf(boost::math::complement(chance, found - 1));
    if (p < least) {
      least = p;
      best = k + 1;
    }
  }
  rows.resize(best);
  std::erase_if(rows, [](const Row& r) { return !r.counts; });
  return rows;
}

std::vector<Row> missing_highlight(const std::vector<double>& measured, const std::vector<double>& model,
                                   const std::vector<double>& mirror, double noise) {
  if (!is_matt(model, mirror)) return {};
  std::vector<Row> rows;
  std::vector<double> excess;
  for (std::size_t k = 0; k < model.size(); ++k) {
    if (!(measured[k] > 0)) continue;
    rows.push_back({mirror[k], std::log(measured[k] / std::max(model[k], 1e-300)), k, false});
    excess.push_back(rows.back().excess);
  }
  if (excess.empty()) return {};
  const double base = io::quantile(std::move(excess), 0.25);
  for (Row& r : rows)
    r.counts = r.excess - base > std::max(std::log(kContrast), 5 * noise) &&
               r.excess > std::max(std::log(kExcess), 5 * noise);
  return gathered(std::move(rows));
}

}  // namespace

Misfit judge_highlight(const FitData& data, const std::vector<std::vector<double>>& model,
                       std::optional<double> noise) {
  std::vector<double> mirror(data.rows());
  for (std::size_t k = 0; k < data.rows(); ++k) mirror[k] = mirror_cosine(data, k);
  std::vector<Row> most;
  for (std::size_t c = 0; c < model.size(); ++c)
    if (auto rows = missing_highlight(data.values[c], model[c], mirror, noise.value_or(0));
        rows.size() > most.size())
      most = std::move(rows);
  if (most.empty()) return {};
  HalfAngleRange range;
  std::vector<double> excess;
  for (const Row& r : most) {
    range.add(half_angles(data, r.row));
    excess.push_back(r.excess);
  }
  return {true, "a highlight that this form cannot make: in " + std::to_string(most.size()) +
                    " rows around the mirror direction (" + to_text(range) +
                    ") the values are in the middle " +
                    io::short_number(std::exp(io::median(std::move(excess))), 2) + " times the model's"};
}

}  // namespace brdf::fit
