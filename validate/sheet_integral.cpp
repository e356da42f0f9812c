#include <algorithm>
#include <array>
#include <cmath>

#include "io/numbers.h"
#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

struct Sample {
  Vec3<double> d;
  std::size_t row;
};

struct Neighbour {
  double distance;  // squared
  std::size_t row;
};

// The nearest sample in each quadrant about d: a table that
// is dense along one line only is no better known beside it.
std::vector<Neighbour> around(const std::vector<Sample>& samples, const Vec3<double>& d) {
  const double s = std::hypot(d.x, d.y);
  const Vec3<double> along{d.z * d.x / s, d.z * d.y / s, -s}, across{-d.y / s, d.x / s, 0};
  std::array<Neighbour, 4> near;
  near.fill({HUGE_VAL, 0});
  for (const Sample& sample : samples) {
    const double distance = 2 - 2 * dot(d, sample.d);
    const std::size_t quadrant = (dot(along, sample.d) < 0 ? 1u : 0u) + (dot(across, sample.d) < 0 ? 2u : 0u);
    if (distance < near[quadrant].distance) near[quadrant] = {distance, sample.row};
  }
  std::vector<Neighbour> found;
  for (const Neighbour& n : near)
    if (std::isfinite(n.distance)) found.push_back(n);
  return found;
}

}  // namespace

// The samples around each of many directions, weighted by the inverse square of their distance. The bound:
// what no sample is near to, half of what the samples around a direction differ by, and the noise floor.
MeasuredAlbedo integrate(const io::SampleTable& t, const std::vector<std::size_t>& rows, double noise) {
  constexpr int kRings = 20, kSectors = 36;
  constexpr double kReach = degrees(8).radians();
  std::vector<Sample> samples;
  double azimuth_low = 360, azimuth_high = -360;
  for (const std::size_t k : rows) {
    const double phi = std::remainder(t.phi_o[k] - t.phi_i[k], 360.0);
    if (t.theta_o[k] > 0) {
      azimuth_low = std::min(azimuth_low, phi);
      azimuth_high = std::max(azimuth_high, phi);
    }
    samples.push_back({direction(degrees(t.theta_o[k]), degrees(phi)), k});
  }
  // Measured on one side of the plane of incidence only: the other side is its mirror image.
  if (azimuth_low >= 0 || azimuth_high <= 0) {
    const std::size_t n = samples.size();
    for (std::size_t j = 0; j < n; ++j)
      samples.push_back({{samples[j].d.x, -samples[j].d.y, samples[j].d.z}, samples[j].row});
  }
  const std::size_t channels = t.channels.size();
  const std::vector<double> zero(channels);
  MeasuredAlbedo m{t.theta_i[rows.front()], 0, zero, zero, zero};
  const double weight = kPi / (kRings * kSectors);
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector) {
      const double s = std::sqrt((ring + 0.5) / kRings), phi = 2 * kPi * (sector + 0.5) / kSectors;
      const Vec3<double> d{s * std::cos(phi), s * std::sin(phi), std::sqrt(1 - s * s)};
      const std::vector<Neighbour> near = around(samples, d);
      const auto nearest = std::min_element(
          near.begin(), near.end(), [](const auto& x, const auto& y) { return x.distance < y.distance; });
      const bool covered = std::sqrt(std::max(nearest->distance, 0.0)) < kReach;
      m.coverage += covered ? 1.0 / (kRings * kSectors) : 0;
      for (std::size_t c = 0; c < channels; ++c) {
        double sum = 0, weights = 0, low = HUGE_VAL, high = -HUGE_VAL;
        for (const Neighbour& n : near) {
          const double w = 1 / (std::max(n.distance, 0.0) + 1e-6), v = t.values[c][n.row];
          sum += w * v;
          weights += w;
          low = std::min(low, v);
          high = std::max(high, v);
        }
        m.value[c] += weight * sum / weights;
        m.least[c] += covered ? weight * low : 0;
        m.bound[c] += weight * (covered ? 0.5 * (high - low) : std::max(std::abs(low), std::abs(high)));
      }
    }
  for (std::size_t c = 0; c < channels; ++c) {
    m.least[c] -= 0.5 * noise * std::abs(m.least[c]);
    m.bound[c] += 0.5 * noise * std::abs(m.value[c]);
  }
  return m;
}

double proven(const MeasuredAlbedo& a, std::size_t channel) {
  return std::max(a.value[channel] - a.bound[channel], a.least[channel]);
}

Finding coverage(const io::SampleTable& t, const std::vector<MeasuredAlbedo>& albedo) {
  double least = 1, sum = 0;
  for (const MeasuredAlbedo& a : albedo) {
    least = std::min(least, a.coverage);
    sum += a.coverage;
  }
  Finding f = start(t, "coverage");
  f.value = sum / double(albedo.size());
  f.bound = 1;
  f.outcome = f.value < kEnoughCoverage ? Outcome::undecided : Outcome::pass;
  f.statement =
      io::percent_to_tenths(f.value) +
      " of the projected hemisphere lies within 8 degrees of a sample (at the worst angle of the light " +
      io::percent_to_tenths(least) + ")";
  return f;
}

Finding energy(const io::SampleTable& t, const std::vector<MeasuredAlbedo>& albedo) {
  const MeasuredAlbedo* worst = nullptr;
  std::size_t channel = 0;
  bool fails = false;
  const auto most = [](const MeasuredAlbedo& a, std::size_t c) { return a.value[c] + a.bound[c]; };
  double covered = 0;
  for (const MeasuredAlbedo& a : albedo)
    for (std::size_t c = 0; c < a.value.size(); ++c) {
      const bool too_much = proven(a, c) > 1;
      covered = std::max(covered, a.least[c]);
      if (!too_much && (fails || a.coverage < kEnoughCoverage)) continue;
      const bool worse =
          !worst || (too_much && !fails) ||
          (fails ? proven(a, c) > proven(*worst, channel) : most(a, c) > most(*worst, channel));
      fails = fails || too_much;
      if (!worse) continue;
      worst = &a;
      channel = c;
    }
  Finding f = start(t, "energy");
  f.bound = 1;
  if (!worst) {
    f.outcome = Outcome::undecided;
    f.value = covered;
    f.statement =
        "too little of the hemisphere is covered for an integral: the covered part reflects at least " +
        io::short_number(covered, 2);
    return f;
  }
  f.value = worst->value[channel];
  f.outcome = fails ? Outcome::fail : most(*worst, channel) > 1 ? Outcome::undecided : Outcome::pass;
  f.statement = (fails ? "reflects at least " + io::short_number(proven(*worst, channel), 3) + ": "
                       : std::string("reflects at most ")) +
                io::short_number(f.value, 3) + " +- " + io::short_number(worst->bound[channel], 3) +
                " (light at " + io::short_number(worst->theta_i, 3) + " degrees, channel " +
                t.channels[channel] + ")";
  if (fails)
    f.statement += "; divided by pi, if it is a BRF, " + io::short_number(proven(*worst, channel) / kPi, 3);
  if (f.outcome == Outcome::undecided) f.statement += ", which does not say that it stays below 1";
  return f;
}

}  // namespace brdf::validate
