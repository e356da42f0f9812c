#include "measured/residual_map.h"

#include <algorithm>
#include <cmath>

#include "brdf/geometry.h"
#include "io/files/evenly.h"
#include "measured/counterparts.h"

namespace brdf::measured {
namespace {

constexpr std::size_t kAll = ResidualMap::kCells * ResidualMap::kCells;
constexpr double kWide = 90.0 / double(ResidualMap::kCells);  // degrees

std::size_t along(double angle) {
  return std::min(std::size_t(radians(angle).degrees() / kWide), ResidualMap::kCells - 1);
}

std::size_t cell_of(const Vec3<double>& wi, const Vec3<double>& wo) {
  const Geometry<double> g = geometry(wi, wo);
  return along(std::acos(std::min(g.cos_d, 1.0))) * ResidualMap::kCells +
         along(std::atan2(std::hypot(g.h.x, g.h.y), g.h.z));
}

// Returns the largest number of rows per cell with which all cells together keep no more than `most` rows;
// at least one.
std::size_t most_of_a_cell(const std::vector<std::vector<std::size_t>>& rows, std::size_t most) {
  std::size_t low = 1, high = 1;
  for (const auto& cell : rows) high = std::max(high, cell.size());
  while (low < high) {
    const std::size_t middle = low + (high - low + 1) / 2;
    std::size_t sum = 0;
    for (const auto& cell : rows) sum += std::min(cell.size(), middle);
    if (sum <= most)
      low = middle;
    else
      high = middle - 1;
  }
  return low;
}

}  // namespace

ResidualMap::ResidualMap(const io::SampleTable& table, std::size_t most_rows)
    : channels_(table.channels), directions_(0), values_(table.channels.size()) {
  const DirectionArrays<double> all = io::unit_directions(table);
  std::vector<std::vector<std::size_t>> rows(kAll);
  for (std::size_t k = 0; k < table.rows(); ++k)
    rows[cell_of(all.view().wi(k), all.view().wo(k))].push_back(k);
  const std::size_t most = most_of_a_cell(rows, most_rows);
  std::vector<std::size_t> kept;
  for (std::size_t cell = 0; cell < rows.size(); ++cell)
    for (const std::size_t row : io::evenly(std::move(rows[cell]), most)) {
      kept.push_back(row);
      cell_.push_back(cell);
    }
  directions_ = DirectionArrays<double>(kept.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    directions_.set(k, all.view().wi(kept[k]), all.view().wo(kept[k]));
    for (std::size_t c = 0; c < values_.size(); ++c) values_[c].push_back(table.values[c][kept[k]]);
  }
}

std::vector<double> ResidualMap::cells(const std::vector<std::vector<double>>& model) const {
  std::vector<double> sum(kAll, 0), count(kAll, 0);
  for (std::size_t c = 0; c < model.size(); ++c)
    for (std::size_t k = 0; k < model[c].size(); ++k)
      if (values_[c][k] > 0 && model[c][k] > 0) {
        sum[cell_[k]] += std::log(model[c][k] / values_[c][k]);
        count[cell_[k]] += 1;
      }
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] /= count[k];  // 0/0: NaN
  return sum;
}

std::vector<double> ResidualMap::cells(const Material& material) const {
  const std::vector<int> counterpart = counterparts(channels_, material.channels);
  std::vector<std::vector<double>> model(channels_.size());
  std::vector<double> term_values(cell_.size());
  for (std::size_t c = 0; c < model.size(); ++c) {
    if (counterpart[c] < 0) continue;
    model[c].assign(cell_.size(), 0);
    for (const Term& term : material.terms) {
      eval_batch(term, std::size_t(counterpart[c]), directions(), term_values.data());
      for (std::size_t k = 0; k < term_values.size(); ++k) model[c][k] += term_values[k];
    }
  }
  return cells(model);
}

}  // namespace brdf::measured
