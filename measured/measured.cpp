#include "measured/measured.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "io/files/error.h"
#include "io/samples/noise.h"
#include "measured/counterparts.h"

namespace brdf::measured {
namespace {

constexpr double kHorizon = 1e-3;  // rows with smaller cosines are not used
constexpr double kTilted =
    0.1;  // a half vector (of length 2) farther than this from the normal has an azimuth
constexpr double kSame = 1e-3;  // in the coordinates: closer places are merged
constexpr double kLeastRatio = 1e-3;
const std::vector<std::string> kNoChannels;  // channels of no material
constexpr std::size_t kLearntFrom = 200;
constexpr double kCores[] = {0.03, 0.1, 0.3};  // widths of lobes' cores, radians
// Azimuths of the sample are distinguished only if the log-likelihood per channel increases by this much.
// Several azimuths of incidence alone do not mean that the sample was rotated: in MERL's files all half
// vectors have the same azimuth.
constexpr double kForAzimuths = 5;
// Upper bounds of the lengths over which the ratio varies, whatever the samples suggest. Radians; for
// theta_h at 40 degrees.
constexpr struct {
  double theta_h, theta_d, sines;
} kLongest{0.35, 0.4, 0.2};

// Returns the geometric mean of the positive values; 1 if no value is positive.
double geometric_mean(const std::vector<double>& values) {
  double sum = 0, count = 0;
  for (const double value : values) {
    if (!(value > 0)) continue;
    sum += std::log(value);
    ++count;
  }
  return count > 0 ? std::exp(sum / count) : 1;
}

double logarithm(double ratio) {
  return std::log(std::max(ratio, kLeastRatio));
}

}  // namespace

MeasuredReflectance::MeasuredReflectance(const io::SampleTable& table, const Material* fitted, Beside beside)
    : channels_(table.channels),
      counterpart_(counterparts(table.channels, fitted ? fitted->channels : kNoChannels)) {
  if (fitted) fitted_ = *fitted;
  info_.name = info_.family = "measured";
  info_.channels = channels_;
  for (const std::vector<double>& values : table.values) level_.push_back(geometric_mean(values));
  Rows rows = usable_rows(table);
  if (rows.wi.empty()) throw InputError(table.name() + ": has no rows above the horizon");
  scatter_ = io::relative_noise(table).value;
  const double noise = scatter_.value_or(0.0);
  chosen_ = likeliest(rows, noise);
  if (fitted && beside == Beside::likeliest) {
    const std::vector<int> counterpart = std::exchange(counterpart_, std::vector<int>(channels_.size(), -1));
    Rows plain = usable_rows(table);
    const Choice other = likeliest(plain, noise);
    if (other.variation.likelihood > chosen_.variation.likelihood) {
      chosen_ = other;
      rows = std::move(plain);
    } else {
      counterpart_ = counterpart;
    }
  }
  keep(rows);
}

// Removes the counterpart of channels for which the fit is black, because there is no ratio to a black fit.
void MeasuredReflectance::leave_black_channels(const Directions<double>& d) {
  std::vector<bool> black(channels_.size(), true);
  std::vector<double> f(channels_.size());
  for (std::size_t k = 0; k < d.count && std::ranges::find(black, true) != black.end(); ++k) {
    fitted_values(d.wi(k), d.wo(k), f);
    for (std::size_t c = 0; c < f.size(); ++c) black[c] = black[c] && !(f[c] > 0);
  }
  for (std::size_t c = 0; c < black.size(); ++c)
    if (black[c]) counterpart_[c] = -1;
}

MeasuredReflectance::Rows MeasuredReflectance::usable_rows(const io::SampleTable& table) {
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const Directions<double> d = arrays.view();
  leave_black_channels(d);
  Rows rows;
  rows.ratios.resize(channels_.size());
  std::vector<double> f(channels_.size());
  bool light_turns = false, half_turns = false;
  double along_x = 0, along_y = 0;  // the azimuth of the first tilted half vector
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (d.wi_z[k] < kHorizon || d.wo_z[k] < kHorizon) continue;
    fitted_values(d.wi(k), d.wo(k), f);
    if (!std::ranges::all_of(f, [](double v) { return v > 0; })) continue;
    rows.wi.push_back(d.wi(k));
    rows.wo.push_back(d.wo(k));
    for (std::size_t c = 0; c < f.size(); ++c) rows.ratios[c].push_back(table.values[c][k] / f[c]);
    light_turns = light_turns || (table.theta_i[k] > 0 && table.phi_i[k] != table.phi_i.back());
    const auto [low, high] = std::minmax(table.theta_i[k], table.theta_o[k]);
    range_.inner = std::max(range_.inner, low);
    range_.outer = std::max(range_.outer, high);
    const double x = d.wi_x[k] + d.wo_x[k], y = d.wi_y[k] + d.wo_y[k], length = std::hypot(x, y);
    if (length < kTilted) continue;
    if (along_x == 0 && along_y == 0) along_x = x / length, along_y = y / length;
    half_turns = half_turns || std::abs(along_x * y - along_y * x) > 0.05 * length;
  }
  rows.turned = light_turns && half_turns;
  return rows;
}

// Replaces rows at the same place by their mean: repeats, and rows that the symmetries make equal.
void MeasuredReflectance::keep(const Rows& rows) {
  const auto hash = [](const std::array<long, kDimensions>& cell) {
    std::size_t sum = 0;
    for (const long number : cell) sum = sum * 1000003 + std::size_t(number);
    return sum;
  };
  std::unordered_map<std::array<long, kDimensions>, std::size_t, decltype(hash)> cells(rows.wi.size(), hash);
  std::vector<Place> places;
  std::vector<double> count;
  ratios_.resize(channels_.size());
  for (std::size_t k = 0; k < rows.wi.size(); ++k) {
    const Place at = place(rows.wi[k], rows.wo[k]);
    std::array<long, kDimensions> cell;
    for (std::size_t j = 0; j < kDimensions; ++j) cell[j] = std::lround(at[j] / kSame);
    const auto [found, fresh] = cells.try_emplace(cell, places.size());
    if (fresh) {
      places.push_back(at);
      count.push_back(0);
      for (std::vector<double>& of_channel : ratios_) of_channel.push_back(0);
    }
    const std::size_t sample = found->second;
    const double n = ++count[sample];
    for (std::size_t c = 0; c < ratios_.size(); ++c)
      ratios_[c][sample] += (rows.ratios[c][k] - ratios_[c][sample]) / n;
  }
  for (const std::vector<double>& of_channel : ratios_) {
    logs_.emplace_back();
    for (const double ratio : of_channel) logs_.back().push_back(logarithm(ratio));
  }
  field_ = std::make_unique<const Field>(places, std::move(count), chosen_.variation);
}

MeasuredReflectance::Choice MeasuredReflectance::likeliest(const Rows& rows, double noise) const {
  const auto longest = [](double core) {
    const double r = kLongest.theta_h / std::hypot(0.7, core);
    return Place{r, kLongest.theta_d, kLongest.sines, r};
  };
  const auto places = [&](const std::vector<std::size_t>& of, Turning turning, double core) {
    std::vector<Place> out;
    for (const std::size_t k : of) out.push_back(place_of(rows.wi[k], rows.wo[k], turning, core));
    return out;
  };
  std::vector<std::size_t> all(rows.wi.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  // All alternatives use the same rows, which makes their likelihoods comparable.
  const Turning most = rows.turned ? Turning::turned : Turning::isotropic;
  const std::vector<std::size_t> chosen =
      spread_out(places(all, most, kCores[1]), longest(kCores[1]), kLearntFrom);
  Scattered samples;
  samples.count.assign(chosen.size(), 1);
  for (const std::vector<double>& of_channel : rows.ratios) {
    samples.values.emplace_back();
    for (const std::size_t k : chosen) samples.values.back().push_back(logarithm(of_channel[k]));
  }
  Choice best;
  best.variation.likelihood = -HUGE_VAL;
  for (const Turning turning : {Turning::isotropic, Turning::turned}) {
    for (const double core : kCores) {
      if (turning == Turning::turned && !rows.turned) break;
      samples.places = places(chosen, turning, core);
      const Variation v = learn_variation(samples, longest(core), noise);
      const double more = turning == Turning::turned ? kForAzimuths * double(channels_.size()) : 0;
      if (v.likelihood <= best.variation.likelihood + more) continue;
      best = {v, turning, core};
    }
  }
  return best;
}

void MeasuredReflectance::fitted_values(const Vec3<double>& wi, const Vec3<double>& wo,
                                        std::vector<double>& out) const {
  std::vector<double> f(fitted_ ? fitted_->channels.size() : 0);
  if (fitted_) brdf::eval(*fitted_, wi, wo, f);
  for (std::size_t c = 0; c < out.size(); ++c)
    out[c] = counterpart_[c] < 0 ? level_[c] : f[std::size_t(counterpart_[c])];
}

Seen MeasuredReflectance::at(const Vec3<double>& wi, const Vec3<double>& wo) const {
  if (wi.z > 0 && wo.z > 0) return seen(wi, wo, ratio_at(place(wi, wo)));
  Seen nothing;
  nothing.f.assign(channels_.size(), 0);
  return nothing;
}

std::optional<Seen> MeasuredReflectance::measured_at(const Vec3<double>& wi, const Vec3<double>& wo) const {
  if (!(wi.z > 0 && wo.z > 0 && scanned(wi, wo))) return std::nullopt;
  const Field::Weights weights = field_->weights_at(place(wi, wo), kLeastKnown);
  if (weights.known < kLeastKnown) return std::nullopt;
  return seen(wi, wo, ratio_of(weights));
}

Ratio MeasuredReflectance::ratio_at(const Place& place) const {
  return ratio_of(field_->weights_at(place));
}

Ratio MeasuredReflectance::ratio_of(const Field::Weights& w) const {
  Ratio out;
  out.known = w.known;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    double log = 0, plain = 1, least = HUGE_VAL;
    for (std::size_t k = 0; k < w.count; ++k) {
      const double ratio = ratios_[c][w.sample[k]];
      log += w.weight[k] * logs_[c][w.sample[k]];
      plain += w.weight[k] * (ratio - 1);
      least = std::min(least, ratio);
    }
    out.of.push_back(least > kLeastRatio ? std::exp(log) : std::max(plain, 0.0));
  }
  return out;
}

// Returns whether the polar angles are within the range of the samples.
bool MeasuredReflectance::scanned(const Vec3<double>& wi, const Vec3<double>& wo) const {
  constexpr double kBeyond = 2;  // degrees
  const auto polar = [](double cosine) { return radians(std::acos(std::min(cosine, 1.0))).degrees(); };
  return polar(std::max(wi.z, wo.z)) <= range_.inner + kBeyond &&
         polar(std::min(wi.z, wo.z)) <= range_.outer + kBeyond;
}

Seen MeasuredReflectance::seen(const Vec3<double>& wi, const Vec3<double>& wo, const Ratio& ratio) const {
  Seen out;
  out.f.resize(channels_.size());
  fitted_values(wi, wo, out.f);
  for (std::size_t c = 0; c < out.f.size(); ++c) out.f[c] *= ratio.of[c];
  out.known = ratio.known;
  out.measured = out.known >= kLeastKnown && scanned(wi, wo);
  return out;
}

void MeasuredReflectance::eval(const ParameterValues<double>& p, const Directions<double>& d,
                               double* out) const {
  for (std::size_t k = 0; k < d.count; ++k) out[k] = at(d.wi(k), d.wo(k)).f[p.channel];
}

Material material_of(std::shared_ptr<const MeasuredReflectance> measured) {
  const std::vector<std::string> channels = measured->channels();
  return make_material(Reflectance(std::move(measured)), channels);
}

}  // namespace brdf::measured
