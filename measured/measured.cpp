#include "measured/measured.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "io/channel_colours.h"
#include "io/error.h"
#include "io/noise.h"

namespace brdf::measured {
namespace {

constexpr double kHorizon = 1e-3;  // cosines below are not interpolated from
constexpr double kSame = 1e-3;     // of the coordinates: places nearer are one
constexpr double kLeastRatio = 1e-3;
constexpr std::size_t kLearntFrom = 200;
constexpr double kCores[] = {0.03, 0.1, 0.3};  // of lobes, radians
// So far at most the ratio is taken to vary slowly, whatever the samples say: radians (of theta_h at 40 degrees).
constexpr struct {
  double theta_h, theta_d, sines;
} kLongest{0.35, 0.4, 0.2};

// The channel of the material that stands for each of the table's.
std::vector<int> counterparts(const std::vector<std::string>& channels, const Material* fitted) {
  std::vector<int> out(channels.size(), -1);
  if (!fitted) return out;
  const auto of_table = io::channel_colours(channels), of_material = io::channel_colours(fitted->channels);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto same = std::find(fitted->channels.begin(), fitted->channels.end(), channels[c]);
    if (same != fitted->channels.end()) {
      out[c] = int(same - fitted->channels.begin());
    } else if (fitted->channels.size() == 1) {
      out[c] = 0;
    } else if (of_table && of_material) {
      for (std::size_t k = 0; k < 3; ++k)
        if (of_table->of[k] == c) out[c] = int(of_material->of[k]);
    }
  }
  return out;
}

double logarithm(double ratio) {
  return std::log(std::max(ratio, kLeastRatio));
}

}  // namespace

MeasuredReflectance::MeasuredReflectance(const io::SampleTable& table, const Material* fitted)
    : channels_(table.channels), counterpart_(counterparts(table.channels, fitted)) {
  if (fitted) fitted_ = *fitted;
  const std::size_t channels = channels_.size();
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const Directions<double> d = arrays.view();
  level_.assign(channels, 1);
  for (std::size_t c = 0; c < channels; ++c) {
    double sum = 0, count = 0;
    for (const double f : table.values[c]) {
      if (f > 0) sum += std::log(f), ++count;
    }
    if (count > 0) level_[c] = std::exp(sum / count);
  }
  std::vector<std::size_t> rows;
  std::vector<std::vector<double>> ratios(channels);
  std::vector<double> f(channels);
  std::set<double> azimuths;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (d.wi_z[k] < kHorizon || d.wo_z[k] < kHorizon) continue;
    fitted_values(d.wi(k), d.wo(k), f);
    if (!std::all_of(f.begin(), f.end(), [](double v) { return v > 0; })) continue;
    rows.push_back(k);
    azimuths.insert(table.phi_i[k]);
    for (std::size_t c = 0; c < channels; ++c) ratios[c].push_back(table.values[c][k] / f[c]);
    const auto [low, high] = std::minmax(table.theta_i[k], table.theta_o[k]);
    range_.inner = std::max(range_.inner, low);
    range_.outer = std::max(range_.outer, high);
  }
  if (rows.empty()) throw InputError(table.name() + ": has no rows above the horizon");

  const double noise = io::relative_noise(table).value.value_or(0.0);
  choose_variation(d, rows, ratios, azimuths.size() > 1, noise);
  // Rows at one place become their mean: repeated ones, and those that the symmetries make equal.
  Scattered merged;
  merged.values.resize(channels);
  ratios_.resize(channels);
  std::map<std::array<long, kDimensions>, std::size_t> cells;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Place place = place_of(d.wi(rows[k]), d.wo(rows[k]), turning_, core_);
    std::array<long, kDimensions> cell;
    for (std::size_t j = 0; j < kDimensions; ++j) cell[j] = std::lround(place[j] / kSame);
    const auto [found, fresh] = cells.try_emplace(cell, merged.places.size());
    const std::size_t at = found->second;
    if (fresh) {
      merged.places.push_back(place);
      merged.count.push_back(0);
      for (std::size_t c = 0; c < channels; ++c) ratios_[c].push_back(0);
    }
    const double n = ++merged.count[at];
    for (std::size_t c = 0; c < channels; ++c) ratios_[c][at] += (ratios[c][k] - ratios_[c][at]) / n;
  }
  for (const std::vector<double>& of_channel : ratios_) {
    logs_.emplace_back();
    for (const double ratio : of_channel) logs_.back().push_back(logarithm(ratio));
  }
  field_ = std::make_unique<const Field>(merged.places, merged.count, variation_);
  info_.name = info_.family = "measured";
  info_.channels = channels_;
}

void MeasuredReflectance::choose_variation(const Directions<double>& d, const std::vector<std::size_t>& rows,
                                           const std::vector<std::vector<double>>& ratios, bool turned,
                                           double noise) {
  const auto longest = [](double core) {
    const double r = kLongest.theta_h / std::hypot(0.7, core);
    return Place{r, kLongest.theta_d, kLongest.sines, r};
  };
  const auto places = [&](const std::vector<std::size_t>& of, Turning turning, double core) {
    std::vector<Place> out;
    for (const std::size_t k : of) out.push_back(place_of(d.wi(rows[k]), d.wo(rows[k]), turning, core));
    return out;
  };
  std::vector<std::size_t> all(rows.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  // The same rows for all, so that likelihoods can be compared.
  const std::vector<std::size_t> chosen = spread_out(
      places(all, turned ? Turning::turned : Turning::isotropic, kCores[1]), longest(kCores[1]), kLearntFrom);
  Scattered samples;
  samples.count.assign(chosen.size(), 1);
  for (const std::vector<double>& of_channel : ratios) {
    samples.values.emplace_back();
    for (const std::size_t k : chosen) samples.values.back().push_back(logarithm(of_channel[k]));
  }
  variation_.likelihood = -HUGE_VAL;
  for (const Turning turning : {Turning::isotropic, Turning::turned}) {
    if (turning == Turning::turned && !turned) break;
    for (const double core : kCores) {
      samples.places = places(chosen, turning, core);
      const Variation v = learn_variation(samples, longest(core), noise);
      if (v.likelihood <= variation_.likelihood) continue;
      variation_ = v;
      turning_ = turning;
      core_ = core;
    }
  }
}

void MeasuredReflectance::fitted_values(const Vec3<double>& wi, const Vec3<double>& wo,
                                        std::vector<double>& out) const {
  std::vector<double> f(fitted_ ? fitted_->channels.size() : 0);
  if (fitted_) brdf::eval(*fitted_, wi, wo, f);
  for (std::size_t c = 0; c < out.size(); ++c)
    out[c] = counterpart_[c] < 0 ? level_[c] : f[std::size_t(counterpart_[c])];
}

Seen MeasuredReflectance::at(const Vec3<double>& wi, const Vec3<double>& wo) const {
  Seen out;
  out.f.assign(channels_.size(), 0);
  if (!(wi.z > 0 && wo.z > 0)) return out;
  const Field::Weights w = field_->weights_at(place_of(wi, wo, turning_, core_));
  fitted_values(wi, wo, out.f);
  for (std::size_t c = 0; c < out.f.size(); ++c) {
    double log = 0, plain = 0, least = HUGE_VAL;
    for (std::size_t k = 0; k < w.count; ++k) {
      log += w.weight[k] * logs_[c][w.sample[k]];
      plain += w.weight[k] * (ratios_[c][w.sample[k]] - 1);
      least = std::min(least, ratios_[c][w.sample[k]]);
    }
    out.f[c] *= least > kLeastRatio ? std::exp(log) : std::max(1 + plain, 0.0);
  }
  out.known = w.known;
  constexpr double kDegree = kPi / 180;
  const double inner = std::acos(std::max(wi.z, wo.z)) / kDegree,
               outer = std::acos(std::min(wi.z, wo.z)) / kDegree;
  constexpr double kBeyond = 2;
  out.measured =
      out.known >= kLeastKnown && inner <= range_.inner + kBeyond && outer <= range_.outer + kBeyond;
  return out;
}

void MeasuredReflectance::eval(const ParameterValues<double>& p, const Directions<double>& d,
                               double* out) const {
  for (std::size_t k = 0; k < d.count; ++k) out[k] = at(d.wi(k), d.wo(k)).f[p.channel];
}

std::shared_ptr<const MeasuredReflectance> likeliest(const io::SampleTable& table, const Material* fitted) {
  auto plain = std::make_shared<const MeasuredReflectance>(table);
  if (!fitted) return plain;
  auto beside = std::make_shared<const MeasuredReflectance>(table, fitted);
  return plain->variation().likelihood > beside->variation().likelihood ? plain : beside;
}

Material material_of(std::shared_ptr<const MeasuredReflectance> measured) {
  const std::vector<std::string> channels = measured->channels();
  return make_material(Reflectance(std::move(measured)), channels);
}

}  // namespace brdf::measured
