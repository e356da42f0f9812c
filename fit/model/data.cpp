#include "fit/model/data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "io/files/error.h"
#include "io/files/text.h"
#include "io/samples/degrees.h"

namespace brdf::fit {
namespace {

// Tables with more rows are grids without common incidences. Their rows are grouped by degrees of theta_i.
constexpr std::size_t kManyIncidences = 100000;

// Returns whether a value has a residual under the metric.
bool in_domain(Metric metric, double value, double cos_i, double cos_o) {
  constexpr double margin = 1e-6;
  switch (metric) {
    case Metric::log:
      return value * cos_i > -1 + margin;
    case Metric::log_relative:
      return value * cos_i * cos_o > -kLogRelativeFloor * (1 - margin);
    default:
      return true;
  }
}

void append_row(const FitData& from, std::size_t k, FitData& to) {
  to.add_directions(from.directions(k, 1).wi(0), from.directions(k, 1).wo(0));
  for (std::size_t c = 0; c < from.values.size(); ++c) to.values[c].push_back(from.values[c][k]);
  for (std::size_t c = 0; c < from.sigma.size(); ++c) to.sigma[c].push_back(from.sigma[c][k]);
  if (!from.weight.empty()) to.weight.push_back(from.weight[k]);
  to.row.push_back(from.row[k]);
  to.incidence.push_back(from.incidence[k]);
}

FitData empty_like(const FitData& data) {
  FitData out;
  out.channels = data.channels;
  out.grouped = data.grouped;
  out.values.resize(data.values.size());
  out.sigma.resize(data.sigma.size());
  return out;
}

Weighting chosen_weighting(const io::SampleTable& table, const FitOptions& options) {
  bool sigma = !table.channels.empty();
  for (std::size_t c = 0; c < table.channels.size(); ++c) sigma = sigma && table.has_sigma(c);
  if (options.weighting == Weighting::sigma && !sigma)
    throw InputError(table.source + ": --weights sigma needs a sigma column for every channel");
  if (options.weighting != Weighting::automatic) return options.weighting;
  return sigma ? Weighting::sigma : Weighting::uniform;
}

// Sorts by groups, then directions, then values. Rows that are equal in all of them are the same
// measurement.
void sort_rows(FitData& data) {
  data.groups = group_rows(data.directions(0, data.rows()), data.rows());
  std::vector<const std::vector<double>*> keys{&data.wi_z, &data.wi_x, &data.wi_y,
                                               &data.wo_z, &data.wo_x, &data.wo_y};
  for (const auto* columns : {&data.values, &data.sigma})
    for (const auto& column : *columns) keys.push_back(&column);
  std::vector<std::uint32_t> order(data.rows());
  std::iota(order.begin(), order.end(), 0u);
  const std::vector<std::uint32_t>& group = data.groups.group_of;
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    if (group[a] != group[b]) return group[a] < group[b];
    for (const auto* key : keys)
      if ((*key)[a] != (*key)[b]) return (*key)[a] < (*key)[b];
    return a < b;
  });
  const auto arrange = [&order](auto& column) {
    if (column.empty()) return;
    auto sorted = column;
    for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = column[order[k]];
    column = std::move(sorted);
  };
  for (auto* column : {&data.wi_x, &data.wi_y, &data.wi_z, &data.wo_x, &data.wo_y, &data.wo_z, &data.weight})
    arrange(*column);
  for (auto* columns : {&data.values, &data.sigma})
    for (auto& column : *columns) arrange(column);
  arrange(data.row);
  arrange(data.groups.group_of);
}

void add_budget(const io::SampleTable& table, const FitOptions& options, FitData& data) {
  data.budget = options.budget;
  if (!data.budget) return;
  for (const std::uint32_t k : data.row) {
    data.phi_i.push_back(degrees(table.phi_i[k]).radians());
    data.phi_o.push_back(degrees(table.phi_o[k]).radians());
  }
}

// Numbers directions of incidence. Directions that differ by the jitter of a motor are one.
class Incidences {
 public:
  std::uint32_t number(double theta, double phi) {
    const auto [known, is_new] = exact_.try_emplace({theta, phi}, 0);
    if (is_new) known->second = near(direction(degrees(theta), degrees(phi)));
    return known->second;
  }

 private:
  static constexpr double kSame = 0.02 * kPi / 180;  // radians
  using Cell = std::array<int, 3>;

  // Returns the number of the direction within kSame of `w`, or a new number.
  std::uint32_t near(const Vec3<double>& w) {
    const auto cell = [](double x) { return int(std::floor(x / kSame)); };
    const Cell own{cell(w.x), cell(w.y), cell(w.z)};
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const auto [first, last] = cells_.equal_range({own[0] + dx, own[1] + dy, own[2] + dz});
          for (auto at = first; at != last; ++at) {
            const Vec3<double> apart = w - found_[at->second];
            if (dot(apart, apart) < kSame * kSame) return at->second;
          }
        }
    cells_.emplace(own, std::uint32_t(found_.size()));
    found_.push_back(w);
    return std::uint32_t(found_.size() - 1);
  }

  std::map<std::pair<double, double>, std::uint32_t> exact_;
  std::multimap<Cell, std::uint32_t> cells_;
  std::vector<Vec3<double>> found_;
};

void number_incidences(const io::SampleTable& table, FitData& data) {
  Incidences incidences;
  for (const std::uint32_t k : data.row)
    data.incidence.push_back(data.grouped ? std::uint32_t(table.theta_i[k])
                                          : incidences.number(table.theta_i[k], table.phi_i[k]));
}

}  // namespace

Directions<double> FitData::directions(std::size_t first, std::size_t rows) const {
  return {&wi_x[first], &wi_y[first], &wi_z[first], &wo_x[first], &wo_y[first], &wo_z[first], rows};
}

void FitData::add_directions(const Vec3<double>& wi, const Vec3<double>& wo) {
  wi_x.push_back(wi.x);
  wi_y.push_back(wi.y);
  wi_z.push_back(wi.z);
  wo_x.push_back(wo.x);
  wo_y.push_back(wo.y);
  wo_z.push_back(wo.z);
}

FitData prepare(const io::SampleTable& table, const FitOptions& options) {
  if (table.rows() == 0) throw InputError(table.source + ": no rows to fit");
  const std::size_t channels = table.channels.size();
  const Weighting weighting = chosen_weighting(table, options);
  FitData data;
  data.channels = table.channels;
  data.values.resize(channels);
  data.grouped = table.rows() > kManyIncidences;
  if (weighting == Weighting::sigma) data.sigma.resize(channels);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (table.is_beyond(k, options.max_theta)) {
      ++data.beyond_max_theta;
      continue;
    }
    const Vec3<double> wi = io::unit_vector(table.theta_i[k], table.phi_i[k]),
                       wo = io::unit_vector(table.theta_o[k], table.phi_o[k]);
    bool defined = true;
    for (std::size_t c = 0; c < channels; ++c)
      defined = defined && in_domain(options.metric, table.values[c][k], wi.z, wo.z);
    if (!defined) {
      ++data.outside_domain;
      continue;
    }
    data.add_directions(wi, wo);
    for (std::size_t c = 0; c < channels; ++c) data.values[c].push_back(table.values[c][k]);
    for (std::size_t c = 0; c < data.sigma.size(); ++c) data.sigma[c].push_back(table.sigma[c][k]);
    if (weighting == Weighting::solid_angle)
      data.weight.push_back(std::hypot(wi.x, wi.y) * std::hypot(wo.x, wo.y));
    data.row.push_back(std::uint32_t(k));
  }
  if (data.rows() == 0 && data.outside_domain == 0)
    throw InputError(table.source + ": no row has both polar angles within --max-theta " +
                     io::to_text(options.max_theta) + " degrees");
  // Every model fits a table without positive values by reflecting nothing.
  const auto reflects = [](const std::vector<double>& column) {
    return std::ranges::any_of(column, [](double value) { return value > 0; });
  };
  if (std::ranges::none_of(data.values, reflects))
    throw InputError(table.source +
                     ": all values to fit are 0 or below: the table has no usable measurement");
  sort_rows(data);
  number_incidences(table, data);
  add_budget(table, options, data);
  return data;
}

FitData subset(const FitData& data, const std::vector<bool>& keep) {
  FitData out = empty_like(data);
  for (std::size_t k = 0; k < data.rows(); ++k)
    if (keep[k]) append_row(data, k, out);
  return out;
}

FitData within_domain(const FitData& data, Metric metric) {
  std::vector<bool> keep;  // empty means all rows
  if (metric != Metric::log && metric != Metric::log_relative) return empty_like(data);
  for (const auto& channel : data.values)
    for (std::size_t k = 0; k < data.rows(); ++k)
      if (!in_domain(metric, channel[k], data.wi_z[k], data.wo_z[k])) {
        keep.resize(data.rows(), true);
        keep[k] = false;
      }
  return keep.empty() ? empty_like(data) : subset(data, keep);
}

FitData thinned(const FitData& data, std::size_t rows) {
  FitData out = empty_like(data);
  const std::size_t count = std::min(rows, data.rows());
  const double step = double(data.rows()) / double(std::max<std::size_t>(count, 1));
  for (std::size_t k = 0; k < count; ++k) {
    // Steps by the fraction of the golden ratio keep the choice from aligning with the period of a grid.
    const double jitter = count == data.rows() ? 0 : std::fmod(double(k) * 0.6180339887498949, 1.0);
    append_row(data, std::min(std::size_t((double(k) + jitter) * step), data.rows() - 1), out);
  }
  return out;
}

}  // namespace brdf::fit
