#include "fit/model/data.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "io/error.h"
#include "io/text.h"

namespace brdf::fit {
namespace {

// Tables with more rows are grids without common incidences: rows are grouped by degrees of theta_i.
constexpr std::size_t kManyIncidences = 100000;

// Whether a value has a residual under the metric.
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
  std::map<std::pair<double, double>, std::uint32_t> incidences;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (table.theta_i[k] > options.max_theta || table.theta_o[k] > options.max_theta) {
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
    if (data.grouped) {
      data.incidence.push_back(std::uint32_t(table.theta_i[k]));
      continue;
    }
    const auto [it, added] =
        incidences.try_emplace({table.theta_i[k], table.phi_i[k]}, std::uint32_t(incidences.size()));
    data.incidence.push_back(it->second);
  }
  if (data.rows() == 0 && data.outside_domain == 0)
    throw InputError(table.source + ": no row has both polar angles within --max-theta " +
                     io::to_text(options.max_theta) + " degrees");
  // Every model fits such a table, by reflecting nothing.
  const auto reflects = [](const std::vector<double>& column) {
    return std::any_of(column.begin(), column.end(), [](double value) { return value > 0; });
  };
  if (std::none_of(data.values.begin(), data.values.end(), reflects))
    throw InputError(table.source + ": no value to fit is above 0: nothing was measured");
  return data;
}

FitData subset(const FitData& data, const std::vector<bool>& keep) {
  FitData out = empty_like(data);
  for (std::size_t k = 0; k < data.rows(); ++k)
    if (keep[k]) append_row(data, k, out);
  return out;
}

FitData thinned(const FitData& data, std::size_t rows) {
  FitData out = empty_like(data);
  const std::size_t count = std::min(rows, data.rows());
  const double step = double(data.rows()) / double(std::max<std::size_t>(count, 1));
  for (std::size_t k = 0; k < count; ++k) {
    // Steps by the golden ratio's fraction keep the choice off the grid's own period.
    const double jitter = count == data.rows() ? 0 : std::fmod(double(k) * 0.6180339887498949, 1.0);
    append_row(data, std::min(std::size_t((double(k) + jitter) * step), data.rows() - 1), out);
  }
  return out;
}

}  // namespace brdf::fit
