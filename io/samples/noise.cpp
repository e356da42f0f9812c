#include "io/samples/noise.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "io/files/parallel.h"
#include "io/samples/contrasts.h"

namespace brdf::io {
namespace {

constexpr std::size_t kLeast = 24;  // fewest contrasts that give a scale
// Values with a relative scatter below this were copied, not measured twice.
constexpr double kCopies = 1e-5;

// A standard deviation and the number of contrasts from which it was estimated.
struct Spread {
  double value;
  double count;
};

// Estimates a standard deviation from the mean square of the smallest 70 %, assuming a normal distribution.
// Outliers and a highlight do not matter, and the estimate is twice as efficient as one from the median.
Spread robust_scale(std::vector<double>& sizes) {
  // The mean square of a standard normal variable x, given |x| < 1.0364334.
  constexpr double kShare = 0.7, kMeanSquare = 0.3095613;
  const auto end = sizes.begin() + std::ptrdiff_t(kShare * double(sizes.size()));
  std::ranges::nth_element(sizes, end);
  const double sum = std::inner_product(sizes.begin(), end, sizes.begin(), 0.0);
  return {std::sqrt(sum / double(end - sizes.begin()) / kMeanSquare), double(sizes.size())};
}

// Returns the geometric mean of the lowest scales that agree with one another within the uncertainty of so
// few contrasts. There must be at least `least` of them, with this share of all contrasts; otherwise
// returns std::nullopt. If `share` is 0, the lowest scale must be among them. Sorts `scales`.
std::optional<Spread> lowest_agreeing(std::vector<Spread>& scales, std::size_t least, double share) {
  std::ranges::sort(scales, {}, &Spread::value);
  double all = 0;
  for (const Spread& s : scales) all += s.count;
  for (auto first = scales.begin(); first != scales.end(); ++first) {
    double sum = 0, counts = 0, largest = 0;
    auto last = first;
    for (; last != scales.end(); ++last) {
      const double allowed = 1.2 + 2 / std::sqrt(std::min(first->count, last->count));
      if (last->value > allowed * first->value) break;
      sum += last->count * std::log(last->value);
      counts += last->count;
      largest = std::max(largest, last->count);
    }
    if (std::size_t(last - first) >= least && counts >= share * all)
      return Spread{std::exp(sum / counts), largest};
    if (share == 0) break;  // no scale may be skipped
  }
  return std::nullopt;
}

// Scales of the contrasts of each channel, and of all channels together, in each band: [channel or
// all][band][way].
using Ways = std::vector<std::vector<std::vector<Spread>>>;
// Returns the band of a contrast in a channel. `mean`: the mean logarithm of its values.
using BandOf = std::function<std::size_t(const Contrast&, std::size_t channel, double mean)>;

// The largest number of rows that one kind of neighbours uses: enough to determine the scale of a band
// within a few per cent.
std::size_t most_rows(std::size_t channels) {
  return std::clamp<std::size_t>(40000 / channels, 3000, 12000);
}

class Gatherer {
 public:
  Gatherer(const SampleTable& table, std::span<const std::uint32_t> rows, std::size_t bands, BandOf band_of)
      : table_(table),
        bands_(bands),
        band_of_(std::move(band_of)),
        logs_(table.channels.size(), std::vector<double>(table.rows(), kNotYet)),
        contrasts_(table, rows) {}

  Ways ways() {
    const std::size_t channels = logs_.size();
    Ways found(channels + (channels > 1), std::vector<std::vector<Spread>>(bands_));
    for (const Neighbours n : kOfInstruments) add(n, found);
    const auto& all = found.back();
    const auto known = std::ranges::count_if(all, [](const auto& ways) { return ways.size() > 1; });
    if (2 * std::size_t(known) < bands_)
      for (const Neighbours n : kOfHalfVectors) add(n, found);
    return found;
  }

 private:
  static constexpr double kNotYet = HUGE_VAL;
  static constexpr std::size_t kWorthThreads = 10'000;  // values
  using Sizes = std::vector<std::vector<double>>;       // [channel * bands + band]

  void add(Neighbours neighbours, Ways& found) {
    std::array<Sizes, kMostOrder + 1> sizes;
    sizes.fill(Sizes(logs_.size() * bands_));
    contrasts_.for_each(neighbours, most_rows(logs_.size()), [&](std::size_t order, const Contrast& c) {
      for (std::size_t channel = 0; channel < logs_.size(); ++channel) {
        double sum = 0, mean = 0;
        for (std::size_t j = 0; j < c.count; ++j) {
          const double y = logarithm(channel, c.rows[j]);
          sum += c.weights[j] * y;
          mean += y / double(c.count);
        }
        if (std::isfinite(sum))
          sizes[order][channel * bands_ + band_of_(c, channel, mean)].push_back(std::abs(sum));
      }
    });
    const unsigned threads = table_.rows() * logs_.size() > kWorthThreads ? all_processors() : 1;
    parallel_for(
        found.size(), [&](std::size_t c) { put(sizes, c, found[c]); }, threads);
  }

  // Returns NaN for values that are not above 0.
  double logarithm(std::size_t channel, std::uint32_t row) {
    double& y = logs_[channel][row];
    if (y == kNotYet) y = table_.values[channel][row] > 0 ? std::log(table_.values[channel][row]) : NAN;
    return y;
  }

  // Adds the scales of a channel, or of all channels together if `channel` is their number.
  void put(const std::array<Sizes, kMostOrder + 1>& sizes, std::size_t channel,
           std::vector<std::vector<Spread>>& found) const {
    for (const Sizes& of_order : sizes)
      for (std::size_t band = 0; band < bands_; ++band) {
        std::vector<double> wanted;
        for (std::size_t c = 0; c < logs_.size(); ++c) {
          const std::vector<double>& own = of_order[c * bands_ + band];
          if (c == channel || channel == logs_.size()) wanted.insert(wanted.end(), own.begin(), own.end());
        }
        put_scale(wanted, found[band]);
      }
  }

  static void put_scale(std::vector<double>& sizes, std::vector<Spread>& scales) {
    if (sizes.size() < kLeast) return;
    const Spread s = robust_scale(sizes);
    if (s.value > kCopies) scales.push_back(s);
  }

  const SampleTable& table_;
  std::size_t bands_;
  BandOf band_of_;
  std::vector<std::vector<double>> logs_;
  Contrasts contrasts_;
};

// Returns the cosine of the angle between half vector and normal. A lobe varies mainly within few bands of
// this cosine.
float half_cosine(const SampleTable& t, std::uint32_t k) {
  const Vec3<double> h = direction(degrees(t.theta_i[k]), degrees(t.phi_i[k])) +
                         direction(degrees(t.theta_o[k]), degrees(t.phi_o[k]));
  return float(h.z / std::sqrt(dot(h, h)));
}

// Returns these rows, or a subset of about kMost of them that is chosen by their angles.
std::vector<std::uint32_t> some(const SampleTable& t, std::span<const std::uint32_t> rows) {
  constexpr std::size_t kMost = 20000;
  std::vector<std::uint32_t> chosen;
  const double share = double(kMost) / double(rows.size());
  for (const std::uint32_t k : rows) {
    const double turns = t.theta_i[k] * 0.6180339887498949 + t.phi_i[k] * 0.4142135623730951 +
                         t.theta_o[k] * 0.7320508075688772 + t.phi_o[k] * 0.2360679774997897;
    if (share >= 1 || turns - std::floor(turns) < share) chosen.push_back(k);
  }
  return chosen;
}

// Returns the edges that divide these values into bands of equal count. Sorts its copy of the values.
template <class T>
std::vector<T> edges_of(std::vector<T> values, std::size_t bands) {
  std::ranges::sort(values);
  std::vector<T> edges;
  for (std::size_t b = 1; b < bands; ++b) edges.push_back(values[b * values.size() / bands]);
  return edges;
}

template <class T>
std::size_t band_in(const std::vector<T>& edges, T value) {
  return std::size_t(std::ranges::upper_bound(edges, value) - edges.begin());
}

// Small tables have two bands, so that one of them can be free of the highlight.
std::size_t bands_for(std::size_t rows) {
  return std::clamp<std::size_t>(rows / 80, rows < 96 ? 1 : 2, 12);
}

std::optional<double> over_bands(std::vector<std::vector<Spread>> bands) {
  constexpr double kShareOfBands = 0.45;
  std::vector<Spread> known;
  for (std::vector<Spread>& ways : bands)
    if (const auto scale = lowest_agreeing(ways, 2, 0)) known.push_back(*scale);
  if (4 * known.size() < bands.size()) return std::nullopt;
  if (const auto scale = lowest_agreeing(known, 1, kShareOfBands)) return scale->value;
  // Noise that is not proportional to the value differs from band to band. The median over the bands is
  // returned if the noise of at least three quarters of the bands is known.
  if (4 * known.size() < 3 * bands.size()) return std::nullopt;
  return known[known.size() / 2].value;
}

std::vector<std::uint32_t> every_row(const SampleTable& t) {
  std::vector<std::uint32_t> rows(t.rows());
  std::iota(rows.begin(), rows.end(), 0u);
  return rows;
}

}  // namespace

Noise relative_noise(const SampleTable& t, std::span<const std::uint32_t> rows) {
  Noise noise{std::nullopt, std::vector<std::optional<double>>(t.channels.size())};
  if (rows.size() < kLeast || t.channels.empty()) return noise;
  std::vector<float> cosines;
  for (const std::uint32_t k : some(t, rows)) cosines.push_back(half_cosine(t, k));
  if (cosines.empty()) return noise;
  const std::size_t bands = bands_for(rows.size());
  const std::vector<float> edges = edges_of(std::move(cosines), bands);
  std::vector<float> of_rows(t.rows(), NAN);
  const auto cosine_of = [&](std::uint32_t k) {
    if (std::isnan(of_rows[k])) of_rows[k] = half_cosine(t, k);
    return of_rows[k];
  };
  const Ways ways = Gatherer(t, rows, bands, [&](const Contrast& c, std::size_t, double) {
                      return band_in(edges, cosine_of(c.rows[c.count / 2]));
                    }).ways();
  noise.value = over_bands(ways.back());
  for (std::size_t c = 0; c < noise.channels.size(); ++c) noise.channels[c] = over_bands(ways[c]);
  return noise;
}

Noise relative_noise(const SampleTable& t) {
  return relative_noise(t, every_row(t));
}

std::vector<NoiseAtLevel> noise_by_level(const SampleTable& t, std::span<const std::uint32_t> rows) {
  constexpr std::size_t kRowsOfBand = 128, kMostBands = 8;
  std::vector<double> levels;
  for (const std::vector<double>& column : t.values)
    for (const std::uint32_t k : some(t, rows))
      if (column[k] > 0) levels.push_back(std::log(column[k]));
  if (levels.size() < kLeast) return {};
  const std::size_t bands =
      std::clamp<std::size_t>(levels.size() / t.channels.size() / kRowsOfBand, 1, kMostBands);
  const std::vector<double> edges = edges_of(std::move(levels), bands);
  // The mean of a contrast's values is independent of the contrast. Selecting by a single value would
  // prefer large ones.
  std::vector<double> sum(bands), count(bands);
  Ways ways = Gatherer(t, rows, bands, [&](const Contrast&, std::size_t, double mean) {
                const std::size_t band = band_in(edges, mean);
                sum[band] += mean;
                ++count[band];
                return band;
              }).ways();
  std::vector<NoiseAtLevel> found;
  for (std::size_t b = 0; b < bands; ++b)
    if (const auto scale = lowest_agreeing(ways.back()[b], 2, 0))
      found.push_back({std::exp(sum[b] / count[b]), scale->value});
  return found;
}

}  // namespace brdf::io
