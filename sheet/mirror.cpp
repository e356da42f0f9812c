// Checks whether highlights lie at the mirror direction. A zero error of an arm shifts them under every
// light, a wrong label under one light.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>

#include "io/files/numbers.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

struct Peak {
  const Scan* scan;
  double theta_i, offset;  // degrees: offset beyond the mirror direction
  double contrast;         // logarithm of the largest value over the median
  double noise;            // standard error due to the noise of the values, degrees
  // The error due to a highlight that is not a parabola, degrees; the same for all lights of a grid.
  double bias;
  bool is_one_row;  // no other row reaches half of the largest value
};

// Fits a parabola through (x, y) by least squares. Returns the place of its top and the curvature there;
// std::nullopt if the parabola has no top.
struct Top {
  double place, curvature;
};
std::optional<Top> top_of(std::span<const std::pair<double, double>> dots) {
  const double x0 = dots[dots.size() / 2].first;
  Eigen::MatrixX3d powers(dots.size(), 3);
  Eigen::VectorXd levels(dots.size());
  for (Eigen::Index k = 0; k < levels.size(); ++k) {
    const auto& [x, y] = dots[std::size_t(k)];
    powers.row(k) << 1, x - x0, (x - x0) * (x - x0);
    levels[k] = y;
  }
  const Eigen::Vector3d p = powers.colPivHouseholderQr().solve(levels);
  if (!(p[2] < 0)) return std::nullopt;
  return Top{x0 - p[1] / (2 * p[2]), 2 * p[2]};
}

// Finds the highlight of a scan in the darkest channel, in which a highlight has the most contrast. Fits a
// parabola to the logarithms of the dots above half of the largest value. Returns std::nullopt if the
// contrast is too small, or if the largest value is the last of the curve.
std::optional<Peak> peak_of(const View& view, const Scan& scan, double scatter) {
  constexpr double kStandsOut = 2, kHalf = 0.5;
  constexpr std::size_t kFewest = 5;
  const std::vector<double>& values = view.table().values[view.darkest()];
  std::vector<std::pair<double, double>> dots;
  std::vector<double> all;
  for (const Row k : scan.rows) all.push_back(values[k]);
  for (const InPlane& p : in_plane(view, scan))
    if (values[p.row] > 0 && (dots.empty() || p.angle > dots.back().first + 1e-6))
      dots.emplace_back(p.angle, std::log(values[p.row]));
  if (dots.size() < kFewest) return std::nullopt;
  const auto largest = std::ranges::max_element(dots, [](const auto& a, const auto& b) {
    return (a.first > 0 ? a.second : -HUGE_VAL) < (b.first > 0 ? b.second : -HUGE_VAL);
  });
  auto at = std::size_t(largest - dots.begin());
  const double middle = io::median(std::move(all));
  if (at == 0 || at + 1 >= dots.size() || dots[at].first <= 0) return std::nullopt;
  if (!(middle > 0) || dots[at].second < std::log(kStandsOut * middle)) return std::nullopt;
  std::size_t first = at - 1, last = at + 1;
  const double half = dots[at].second + std::log(kHalf);
  while (first > 0 && dots[first - 1].second > half) --first;
  while (last + 1 < dots.size() && dots[last + 1].second > half) ++last;
  const std::span<const std::pair<double, double>> near(dots.data() + first, last - first + 1);
  const auto top = top_of(near);
  constexpr double kFarthest = 25;  // degrees: no highlight of the mirror direction is farther off
  if (!top || top->place < near.front().first || top->place > near.back().first ||
      std::abs(top->place - scan.theta_i) > kFarthest)
    return std::nullopt;
  const double step = (near.back().first - near.front().first) / double(near.size() - 1);
  // The error of the slope at the top, over the curvature.
  const double spread = step * std::sqrt(std::pow(double(near.size()), 3) / 12);
  const double noise = scatter / (std::abs(top->curvature) * spread);
  // A top on a row is well located; between rows its place depends on the shape of the highlight.
  double between = HUGE_VAL;
  for (const auto& [angle, level] : near) between = std::min(between, std::abs(angle - top->place));
  return Peak{&scan,
              scan.theta_i,
              top->place - scan.theta_i,
              dots[at].second - std::log(middle),
              noise,
              (near.size() < 5 ? 0.25 : 0.12) * between + 0.02 * step,
              last - first == 2 && dots[first].second < half && dots[last].second < half};
}

// Keeps the peaks under the rotation of the sample that has the most peaks: the peaks of an anisotropic
// sample move differently under each rotation.
std::vector<Peak> of_one_turn(std::vector<Peak> peaks) {
  std::map<double, std::size_t> count;
  for (const Peak& p : peaks) ++count[p.scan->phi_i];
  const auto most =
      std::ranges::max_element(count, [](const auto& a, const auto& b) { return a.second < b.second; });
  std::erase_if(peaks, [&](const Peak& p) { return p.scan->phi_i != most->first; });
  return peaks;
}

std::vector<Peak> peaks_of(const View& view, double scatter) {
  constexpr double kLeast = 8, kSteepest = 75;  // degrees
  std::vector<Peak> peaks;
  for (const Scan& scan : view.scans())
    if (scan.theta_i >= kLeast && scan.theta_i <= kSteepest)
      if (const auto peak = peak_of(view, scan, scatter)) peaks.push_back(*peak);
  peaks = of_one_turn(std::move(peaks));
  // Among wide highlights a peak of a single row is an outlier.
  const auto narrow = std::size_t(std::ranges::count_if(peaks, [](const Peak& p) { return p.is_one_row; }));
  if (2 * narrow < peaks.size()) std::erase_if(peaks, [](const Peak& p) { return p.is_one_row; });
  return peaks;
}

// offset = zero + slope * lever. The peaks of rough surfaces move off the mirror direction as the light
// becomes steeper, from 0 along the normal. A zero error remains at the normal.
enum class Lever { angle, tangent };  // of theta_i

double lever_of(const Peak& p, Lever lever) {
  const double angle = degrees(p.theta_i).radians();
  return lever == Lever::angle ? angle : std::tan(angle);
}

struct Trend {
  Lever lever;
  double zero, slope, error;  // error: of the zero
  double spread;              // of the offsets about the line, robust
};

// Estimates the slope by the median of the slopes of all pairs (Theil 1950, Sen 1968), and the zero by the
// median of the residuals.
std::optional<Trend> trend_of(const std::vector<Peak>& peaks, Lever lever) {
  constexpr double kLeastLever = 0.02;
  std::vector<double> slopes, zeros, left, noises, biases;
  for (std::size_t a = 0; a < peaks.size(); ++a)
    for (std::size_t b = a + 1; b < peaks.size(); ++b)
      if (const double apart = lever_of(peaks[b], lever) - lever_of(peaks[a], lever);
          std::abs(apart) > kLeastLever)
        slopes.push_back((peaks[b].offset - peaks[a].offset) / apart);
  if (slopes.empty()) return std::nullopt;
  Trend t{lever, 0, io::median(slopes), 0, 0};
  double sum = 0, squares = 0;
  for (const Peak& p : peaks) {
    zeros.push_back(p.offset - t.slope * lever_of(p, lever));
    noises.push_back(p.noise);
    biases.push_back(p.bias);
    const double x = lever_of(p, lever);
    sum += x;
    squares += x * x;
  }
  t.zero = io::median(zeros);
  for (const double z : zeros) left.push_back(std::abs(z - t.zero));
  t.spread = 1.4826 * io::median(std::move(left));
  const double n = double(peaks.size()), mean = sum / n, width = squares / n - mean * mean;
  const double noise = std::max(t.spread, io::median(std::move(noises)));
  // The peaks do not follow this line exactly.
  constexpr double kBent = 0.25;
  t.error = std::hypot(noise * std::sqrt(1 / n + mean * mean / (n * width)), io::median(std::move(biases)),
                       kBent * t.slope * mean);
  return t;
}

// Returns the peaks except one.
std::vector<Peak> without(std::vector<Peak> peaks, std::size_t k) {
  peaks.erase(peaks.begin() + std::ptrdiff_t(k));
  return peaks;
}

// Returns whether a scan has a peak at the expected angle, about as high as the peaks of the other lights.
// In that case another peak is an outlier and no sign of a wrong label.
bool has_highlight_at(const View& view, const Scan& scan, double angle, double contrast) {
  constexpr double kNear = 3, kAsHigh = 0.5;  // degrees; of the logarithm
  const std::vector<double>& values = view.table().values[view.darkest()];
  std::vector<double> all;
  for (const Row k : scan.rows) all.push_back(values[k]);
  const double middle = io::median(std::move(all));
  const std::vector<InPlane> line = in_plane(view, scan);
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    const double before = values[line[k - 1].row], value = values[line[k].row],
                 after = values[line[k + 1].row];
    if (std::abs(line[k].angle - angle) < kNear && value > before && value > after && middle > 0 &&
        std::log(value / middle) > kAsHigh * contrast)
      return true;
  }
  return false;
}

// Finds the one light with its highlight at the place of another light's highlight, according to the other
// lights.
struct Misplaced {
  std::size_t peak;
  double apart, spread;
};
std::optional<Misplaced> one_misplaced(const View& view, const std::vector<Peak>& peaks) {
  constexpr double kLeast = 4, kBeyond = 4;  // degrees; times the spread of the others
  constexpr std::size_t kFewest = 3;
  std::optional<Misplaced> found;
  if (peaks.size() < kFewest) return found;
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    const std::vector<Peak> others = without(peaks, k);
    std::vector<double> offsets, apart, contrasts;
    for (const Peak& p : others) {
      offsets.push_back(p.offset);
      contrasts.push_back(p.contrast);
    }
    Trend trend{Lever::angle, io::median(offsets), 0, 0, HUGE_VAL};
    for (const Lever lever : {Lever::angle, Lever::tangent})
      if (const auto t = others.size() >= kFewest ? trend_of(others, lever) : std::nullopt;
          t && t->spread < trend.spread)
        trend = *t;
    const auto expected = [&](const Peak& p) { return trend.zero + trend.slope * lever_of(p, trend.lever); };
    const auto off_by = [&](const Peak& p) { return p.offset - expected(p); };
    for (const Peak& p : others) apart.push_back(std::abs(off_by(p)));
    // Up to three other lights must all agree; of more lights, most must agree.
    const double spread = std::max(
        others.size() > kFewest ? 1.4826 * io::median(apart) : *std::ranges::max_element(apart), 0.3);
    const double off = off_by(peaks[k]), label = peaks[k].theta_i + off;
    // The steep highlights of a rough surface run ahead of the others by themselves.
    const bool runs_ahead = off > 0 && std::ranges::all_of(others, [&](const Peak& p) {
                              return p.theta_i <= peaks[k].theta_i || off_by(p) > 0.5 * off;
                            });
    if (label < 0 || label > 90 || runs_ahead) continue;
    if (peaks[k].is_one_row &&
        has_highlight_at(view, *peaks[k].scan, peaks[k].theta_i + expected(peaks[k]), io::median(contrasts)))
      continue;
    if (std::abs(off) > kLeast && std::abs(off) > kBeyond * spread &&
        (!found || std::abs(off) > std::abs(found->apart)))
      found = Misplaced{k, off, spread};
  }
  return found;
}

}  // namespace

Finding mirror(const Evidence& e) {
  constexpr double kWorthSeeing = 1, kSure = 3, kNear = 55;  // degrees; standard errors; degrees
  constexpr std::size_t kFewest = 3;
  const io::SampleTable& t = e.view.table();
  if (e.view.scans().empty())
    return not_applicable(t.source, "mirror",
                          "the directions are irregular: no curve has a distinct highlight");
  const std::vector<Peak> peaks = peaks_of(e.view, e.scatter.value().value_or(0.05));
  if (peaks.size() < kFewest)
    return not_applicable(t.source, "mirror",
                          "fewer than three incidences have a distinct highlight in the plane of incidence");
  Finding f = start(t, "mirror");
  f.bound = kWorthSeeing;
  if (const auto one = one_misplaced(e.view, peaks)) {
    const Peak& p = peaks[one->peak];
    f.outcome = Outcome::fail;
    f.value = one->apart;
    f.statement = "the highlight at incidence " + io::short_number(p.theta_i, 4) +
                  " degrees is at the position that the other incidences predict for " +
                  io::short_number(p.theta_i + one->apart, 3) + " (+- " + io::short_number(one->spread, 2) +
                  ") degrees: its label seems wrong";
    return f;
  }
  std::vector<Peak> near = peaks;
  std::erase_if(near, [](const Peak& p) { return p.theta_i > kNear; });
  const auto trend = trend_of(near, Lever::tangent);
  if (!trend)
    return not_applicable(t.source, "mirror",
                          "fewer than two incidences within 55 degrees of the normal have a highlight");
  f.value = trend->zero;
  const std::string size =
      io::short_number(std::abs(trend->zero), 2) + " +- " + io::short_number(trend->error, 1) + " degrees";
  if (std::abs(trend->zero) > kWorthSeeing && std::abs(trend->zero) > 2 * trend->error) {
    const bool sure = std::abs(trend->zero) > kSure * trend->error && near.size() >= kFewest;
    f.outcome = sure ? Outcome::fail : Outcome::undecided;
    f.is_suspicion = !sure;
    f.statement = "highlights are " + size + (trend->zero > 0 ? " beyond" : " short of") +
                  " the mirror direction (" + plural(near.size(), "incidence") +
                  ", extrapolated to normal incidence): a zero error of theta_o or of theta_i";
  } else if (kSure * trend->error > 2 * kWorthSeeing) {
    f.outcome = Outcome::undecided;
    f.statement = "the highlights of " + plural(peaks.size(), "incidence") +
                  " locate the mirror direction only within " + io::short_number(kSure * trend->error, 2) +
                  " degrees";
  } else {
    f.statement = "the highlights of " + plural(peaks.size(), "incidence") +
                  " are at the mirror direction, within " + size;
  }
  return f;
}

}  // namespace brdf::sheet
