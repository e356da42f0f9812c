#include "sheet/integral.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/files/evenly.h"
#include "io/files/numbers.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

constexpr int kRings = 20, kSectors = 36;

struct Sample {
  Vec3<double> d;
  Row row;
};

struct Neighbour {
  double distance = HUGE_VAL;  // squared
  Row row = 0;
  bool exists() const { return std::isfinite(distance); }
};

// The nearest sample in each quadrant around a direction. The quadrants are divided first towards the
// horizon or the normal, then to either side.
struct Around {
  std::array<Neighbour, 4> quadrants;
  double nearest = HUGE_VAL;      // squared
  std::vector<Row> in_cell = {};  // all within `cell` of the direction

  bool is_between_sides() const {
    return (quadrants[0].exists() || quadrants[1].exists()) &&
           (quadrants[2].exists() || quadrants[3].exists());
  }
  bool is_enclosed() const {
    return std::ranges::all_of(quadrants, [](const Neighbour& n) { return n.exists(); });
  }
};

// Finds the samples around a direction. `reach`: the square of the distance beyond which samples are
// ignored. `cell`: the square of the radius that the direction represents.
Around around(const std::vector<Sample>& samples, const Vec3<double>& d, double reach, double cell) {
  const double s = std::hypot(d.x, d.y);
  const Vec3<double> along{d.z * d.x / s, d.z * d.y / s, -s}, across{-d.y / s, d.x / s, 0};
  Around out;
  for (const Sample& sample : samples) {
    const double distance = 2 - 2 * dot(d, sample.d);
    if (distance >= reach) continue;
    const std::size_t quadrant = (dot(along, sample.d) < 0 ? 1u : 0u) + (dot(across, sample.d) < 0 ? 2u : 0u);
    if (distance < out.quadrants[quadrant].distance) out.quadrants[quadrant] = {distance, sample.row};
    out.nearest = std::min(out.nearest, distance);
    if (distance < cell) out.in_cell.push_back(sample.row);
  }
  return out;
}

struct Samples {
  std::vector<Sample> all;
  // True if only one side of the plane of incidence was measured; it is then used for the other side too.
  bool are_mirrored = false;
};

Samples samples_of(const View& view, const Scan& scan) {
  Samples out;
  std::vector<Sample>& samples = out.all;
  double low = 360, high = -360;
  // Very many samples are thinned by the golden ratio, since grids have periods.
  constexpr double kMost = 8000, kGolden = 0.6180339887498949;
  const double share = kMost / double(scan.rows.size());
  for (std::size_t j = 0; j < scan.rows.size(); ++j) {
    if (share < 1 && std::fmod(double(j) * kGolden, 1.0) >= share) continue;
    const Row k = scan.rows[j];
    const double theta = view.table().theta_o[k], phi = view.turn(k);
    if (theta > 0) {
      low = std::min(low, phi);
      high = std::max(high, phi);
    }
    samples.push_back({direction(degrees(theta), degrees(phi)), k});
  }
  // If only one side of the plane of incidence was measured, the other side is its mirror image.
  out.are_mirrored = low >= 0 || high <= 0;
  if (out.are_mirrored) {
    const std::size_t n = samples.size();
    for (std::size_t j = 0; j < n; ++j)
      if (samples[j].d.y != 0)
        samples.push_back({{samples[j].d.x, -samples[j].d.y, samples[j].d.z}, samples[j].row});
  }
  return out;
}

// Returns the squared distance between neighbouring samples of the grid: nine of ten samples have a
// neighbour within it.
double squared_step(const View& view, const Scan& scan) {
  const io::SampleTable& t = view.table();
  std::vector<double> steps;
  constexpr std::size_t kLooked = 500;
  for (std::size_t j = 0; j < scan.rows.size(); j += scan.rows.size() / kLooked + 1) {
    const Row k = scan.rows[j];
    const Vec3<double> d = direction(degrees(t.theta_o[k]), degrees(view.turn(k)));
    for (const Row n : view.near(k)) {
      const double distance = 2 - 2 * dot(d, direction(degrees(t.theta_o[n]), degrees(view.turn(n))));
      if (distance < 1e-12) continue;
      steps.push_back(distance);
      break;
    }
  }
  return steps.empty() ? 0 : io::quantile(std::move(steps), 0.9);
}

// Integrates a scan with the inverse squares of the distances as weights. The bound adds up the values in
// parts without a sample nearby, half of the differences between the samples around a direction, and half
// of the noise. The lower bound counts only directions that samples enclose, with the least of these
// samples: a highlight on a line of samples gives no information on the directions next to that line.
MeasuredAlbedo integrate(const View& view, const Scan& scan, double scatter) {
  const io::SampleTable& t = view.table();
  const double near = 2 - 2 * std::cos(degrees(8).radians()),
               widest = 2 - 2 * std::cos(degrees(25).radians());
  const auto [samples, are_mirrored] = samples_of(view, scan);
  const int sectors = are_mirrored ? kSectors / 2 : kSectors;
  // Three steps of the grid exceed twice its diagonal. A coarse grid does not cover a hemisphere.
  const double reach = std::min(std::max(near, 9 * squared_step(view, scan)), widest);
  const std::size_t channels = t.channels.size();
  const std::vector<double> zero(channels);
  MeasuredAlbedo m{scan.theta_i, 0, 0, zero, zero, zero, {}};
  const double weight = kPi / (kRings * sectors);
  for (int ring = 0; ring < kRings; ++ring)
    for (int sector = 0; sector < sectors; ++sector) {
      const double s = std::sqrt((ring + 0.5) / kRings), phi = 2 * kPi * (sector + 0.5) / kSectors;
      const Vec3<double> d{s * std::cos(phi), s * std::sin(phi), std::sqrt(1 - s * s)};
      // The square of a distance beyond the corner of an equal share of the disc onto which the hemisphere
      // projects.
      const double cell = 2.0 / (kRings * kSectors * d.z);
      Around found = around(samples, d, reach, cell);
      const bool covered = found.nearest < near && found.is_between_sides();
      const bool enclosed = covered && found.is_enclosed();
      if (!covered) found = around(samples, d, HUGE_VAL, 0);
      m.coverage += covered ? 1.0 / (kRings * sectors) : 0;
      for (std::size_t c = 0; c < channels; ++c) {
        double sum = 0, weights = 0, low = HUGE_VAL, high = -HUGE_VAL;
        for (const Neighbour& n : found.quadrants) {
          if (!n.exists()) continue;
          const double w = 1 / (std::max(n.distance, 0.0) + 1e-6), v = t.values[c][n.row];
          sum += w * v;
          weights += w;
          low = std::min(low, v);
          high = std::max(high, v);
        }
        m.value[c] += weight * sum / weights;
        double least = low;
        for (const Row k : found.in_cell) least = std::min(least, t.values[c][k]);
        m.least[c] += enclosed ? weight * std::max(least, 0.0) : 0;
        m.bound[c] += weight * (covered ? 0.5 * (high - low) : std::max(std::abs(low), std::abs(high)));
      }
    }
  for (std::size_t c = 0; c < channels; ++c) {
    m.least[c] *= 1 - 0.5 * scatter;
    m.bound[c] += 0.5 * scatter * std::abs(m.value[c]);
  }
  return m;
}

// Integrates the plane of incidence alone, as if all azimuths were like it. Each row counts with cos sin of
// its angle. The value below which half of that weight lies excludes a highlight; pi times this value is
// the reflected fraction of the rest.
void add_plane(const View& view, const Scan& scan, MeasuredAlbedo& m) {
  // In degrees. Under light steeper than kSteepest even the plane of a rough metal is bright everywhere.
  constexpr double kReach = 8, kSteepest = 60;
  m.in_plane.assign(view.table().channels.size(), 0);
  if (scan.theta_i > kSteepest) return;
  std::vector<InPlane> line = in_plane(view, scan);
  const io::SampleTable& t = view.table();
  if (line.empty()) return;
  double covered = 0, all = 0;
  std::vector<double> weights(line.size());
  for (double angle = -89.5; angle < 90; angle += 1) {
    const double weight = std::cos(degrees(angle).radians()) * std::sin(degrees(std::abs(angle)).radians());
    const auto above = std::ranges::lower_bound(line, angle, {}, &InPlane::angle);
    const auto k = std::size_t(above - line.begin());
    const std::size_t nearest =
        k == line.size() || (k > 0 && angle - line[k - 1].angle < line[k].angle - angle) ? k - 1 : k;
    all += weight;
    if (std::abs(line[nearest].angle - angle) > kReach) continue;
    covered += weight;
    weights[nearest] += weight;
  }
  m.plane_coverage = covered / all;
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    std::vector<std::pair<double, double>> by_value;
    for (std::size_t k = 0; k < line.size(); ++k) by_value.emplace_back(t.values[c][line[k].row], weights[k]);
    std::ranges::sort(by_value);
    double sum = 0;
    for (const auto& [value, weight] : by_value)
      if ((sum += weight) >= 0.5 * covered) {
        m.in_plane[c] = kPi * value;
        break;
      }
  }
}

// The extreme value over many angles of the light: "reflects at most 0.8 +- 0.1 (light at 60 degrees,
// channel r)".
struct Worst {
  const MeasuredAlbedo* albedo = nullptr;
  std::size_t channel = 0;
  double most() const { return albedo->value[channel] + albedo->bound[channel]; }
};

}  // namespace

std::vector<MeasuredAlbedo> albedos(const View& view, std::optional<double> scatter) {
  constexpr std::size_t kMost = 60;
  constexpr double kUnknownScatter = 0.1;
  std::vector<std::size_t> chosen(view.scans().size());
  for (std::size_t k = 0; k < chosen.size(); ++k) chosen[k] = k;
  std::vector<MeasuredAlbedo> found;
  for (const std::size_t k : io::evenly(std::move(chosen), kMost)) {
    found.push_back(integrate(view, view.scans()[k], scatter.value_or(kUnknownScatter)));
    add_plane(view, view.scans()[k], found.back());
  }
  return found;
}

Finding coverage(const Evidence& e) {
  const io::SampleTable& t = e.view.table();
  if (e.albedo.empty())
    return undecided(t, "coverage", "the directions are irregular: no incidence covers a hemisphere");
  double least = 1, sum = 0;
  for (const MeasuredAlbedo& a : e.albedo) {
    least = std::min(least, a.coverage);
    sum += a.coverage;
  }
  Finding f = start(t, "coverage");
  f.value = sum / double(e.albedo.size());
  f.bound = 1;
  f.outcome = f.value < kEnoughCoverage ? Outcome::undecided : Outcome::pass;
  f.statement =
      io::percent_to_tenths(f.value) +
      " of the projected hemisphere lies between measured directions (at the worst angle of incidence " +
      io::percent_to_tenths(least) + ")";
  return f;
}

Plane plane_of(const std::vector<MeasuredAlbedo>& albedo) {
  // Least coverage of the plane of incidence: for the side of the highlight, and for both sides.
  constexpr double kEnough = 0.45, kWhole = 0.75;
  std::vector<const MeasuredAlbedo*> planes;
  double coverage = 0;
  for (const MeasuredAlbedo& a : albedo)
    if (a.plane_coverage >= kEnough) {
      planes.push_back(&a);
      coverage = std::max(coverage, a.plane_coverage);
    }
  Plane plane{0, coverage < kWhole};
  for (std::size_t c = 0; !planes.empty() && c < planes.front()->in_plane.size(); ++c) {
    std::vector<double> of_lights;
    for (const MeasuredAlbedo* a : planes) of_lights.push_back(a->in_plane[c]);
    plane.reflected = std::max(plane.reflected, plane.is_half ? *std::ranges::min_element(of_lights)
                                                              : io::median(std::move(of_lights)));
  }
  return plane;
}

// Judges the energy without a hemisphere: from the fraction that the plane of incidence would reflect if
// all azimuths were like it.
Finding energy_in_plane(const io::SampleTable& t, const std::vector<MeasuredAlbedo>& albedo) {
  constexpr double kMargin = 1.03;
  Finding f = undecided(t, "energy", "the angular coverage is too small for an integral");
  f.bound = 1;
  double least = 0;
  for (const MeasuredAlbedo& a : albedo)
    for (const double x : a.least) least = std::max(least, x);
  const double most = plane_of(albedo).reflected;
  f.value = least;
  if (most == 0) return f;
  f.value = most;
  f.is_suspicion = most > kMargin;
  f.statement +=
      ": if the plane of incidence represented all azimuths, the directional albedo without the highlight "
      "would be " +
      io::short_number(most, 3) + (f.is_suspicion ? ", which violates energy conservation" : "");
  return f;
}

Finding energy_of(const io::SampleTable& t, const std::vector<MeasuredAlbedo>& albedo) {
  if (!has_light(t)) return not_applicable(t.source, "energy", "no value is above 0");
  Worst proven, likely;
  for (const MeasuredAlbedo& a : albedo)
    for (std::size_t c = 0; c < a.value.size(); ++c) {
      if (!proven.albedo || a.least[c] > proven.albedo->least[proven.channel]) proven = {&a, c};
      if (a.coverage >= kEnoughCoverage && (!likely.albedo || a.value[c] + a.bound[c] > likely.most()))
        likely = {&a, c};
    }
  const bool fails = proven.albedo && proven.albedo->least[proven.channel] > 1;
  if (!fails && !likely.albedo) return energy_in_plane(t, albedo);
  const Worst& w = fails ? proven : likely;
  Finding f = start(t, "energy");
  f.bound = 1;
  f.value = w.albedo->value[w.channel];
  const double bound = w.albedo->bound[w.channel];
  const std::string size = io::short_number(f.value, 3) + " +- " + io::short_number(bound, 3) +
                           " (incidence " + io::short_number(w.albedo->theta_i, 3) + " degrees, channel " +
                           t.channels[w.channel] + ")";
  if (fails) {
    const double least = proven.albedo->least[proven.channel];
    f.outcome = Outcome::fail;
    f.statement = "energy conservation is violated: the directional albedo is at least " +
                  io::short_number(least, 3) + "; estimate " + size;
  } else if (w.most() <= 1) {
    f.statement = "the directional albedo is at most " + size;
  } else {
    f.outcome = Outcome::undecided;
    f.is_suspicion = f.value - 0.5 * bound > 1;
    f.statement = "the directional albedo is " + size +
                  (f.is_suspicion ? ", which probably violates energy conservation" : ", which may exceed 1");
  }
  return f;
}

Finding energy(const Evidence& e) {
  return energy_of(e.view.table(), e.albedo);
}

}  // namespace brdf::sheet
