#include "sheet/pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "io/files/evenly.h"

namespace brdf::sheet {
namespace {

constexpr double kSameAngle = 0.02;  // degrees: angles nearer than this are equal
constexpr double kWidestGap = 12;    // degrees: the widest gap for interpolation
constexpr double kWorst = 0.3;       // uncertainty of a logarithm
constexpr std::size_t kMostScans = 60, kMostPairs = 6000;

struct Point {
  double theta, level;
  Row row;
};
using Line = std::vector<Point>;  // by theta

struct Read {
  double level, uncertainty;
  Row row;
};

// Evaluates Lagrange's polynomial through some points.
double polynomial(std::span<const Point> points, double theta) {
  double sum = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    double term = points[k].level;
    for (std::size_t j = 0; j < points.size(); ++j)
      if (j != k) term *= (theta - points[j].theta) / (points[k].theta - points[j].theta);
    sum += term;
  }
  return sum;
}

std::optional<Read> read(const Line& line, double theta) {
  const auto above = std::ranges::lower_bound(line, theta - kSameAngle, {}, &Point::theta);
  if (above == line.end()) return std::nullopt;
  if (std::abs(above->theta - theta) <= kSameAngle) return Read{above->level, 0, above->row};
  if (above == line.begin()) return std::nullopt;
  const auto k = std::size_t(above - line.begin());
  if (line[k].theta - line[k - 1].theta > kWidestGap) return std::nullopt;
  const std::size_t first = k >= 2 ? k - 2 : 0, end = std::min(k + 2, line.size());
  if (end - first < 3) return std::nullopt;
  const std::span<const Point> points(line.data() + first, end - first), bracket(line.data() + k - 1, 2);
  const double value = polynomial(points, theta), linear = polynomial(bracket, theta);
  const Row nearest = theta - line[k - 1].theta < line[k].theta - theta ? line[k - 1].row : line[k].row;
  return Read{value, std::max(0.5 * std::abs(value - linear), 1e-6), nearest};
}

// Returns the lines of a scan by their signed azimuth in units of 1e-4 degrees. The normal belongs to every
// line.
std::map<std::int64_t, Line> lines_of(const View& view, const Scan& scan) {
  std::map<std::int64_t, Line> lines;
  std::optional<Point> normal;
  for (const Row k : scan.rows) {
    const double level = view.level(k), theta = view.table().theta_o[k];
    if (std::isnan(level)) continue;
    if (theta == 0)
      normal = Point{0, level, k};
    else
      lines[std::llround(view.turn(k) * 1e4)].push_back({theta, level, k});
  }
  for (auto& [azimuth, line] : lines) {
    if (normal) line.push_back(*normal);
    std::ranges::sort(line, {}, &Point::theta);
  }
  return lines;
}

// Returns the line of the exchanged pair, which lies at the opposite azimuth. A scan of one side contains
// its mirror image instead.
const Line* exchanged(const std::map<std::int64_t, Line>& lines, std::int64_t azimuth) {
  constexpr std::int64_t kHalfTurn = 1800000;
  for (const std::int64_t key : {-azimuth, azimuth, azimuth == kHalfTurn ? -kHalfTurn : azimuth})
    if (const auto found = lines.find(key); found != lines.end()) return &found->second;
  return nullptr;
}

std::vector<Pair> scanned_pairs(const View& view) {
  std::vector<std::size_t> chosen(view.scans().size());
  for (std::size_t k = 0; k < chosen.size(); ++k) chosen[k] = k;
  chosen = io::evenly(std::move(chosen), kMostScans);
  std::vector<std::map<std::int64_t, Line>> lines;
  for (const std::size_t k : chosen) lines.push_back(lines_of(view, view.scans()[k]));
  const double rows = double(view.table().rows());
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    for (std::size_t j = i + 1; j < chosen.size(); ++j) {
      const Scan &a = view.scans()[chosen[i]], &b = view.scans()[chosen[j]];
      if (a.phi_i != b.phi_i || std::abs(a.theta_i - b.theta_i) < 1) continue;
      for (const auto& [azimuth, line] : lines[i]) {
        const Line* const other = exchanged(lines[j], azimuth);
        if (!other) continue;
        const auto forward = read(line, b.theta_i), backward = read(*other, a.theta_i);
        if (!forward || !backward) continue;
        const double uncertainty = std::hypot(forward->uncertainty, backward->uncertainty);
        if (uncertainty > kWorst) continue;
        pairs.push_back({chosen[i], chosen[j], a.theta_i, b.theta_i, std::abs(double(azimuth)) * 1e-4,
                         forward->level - backward->level, uncertainty,
                         (double(forward->row) - double(backward->row)) / rows, forward->row, backward->row});
      }
    }
  return pairs;
}

// Angles in thousandths of a degree.
using Place = std::tuple<std::int32_t, std::int32_t, std::int32_t>;

std::vector<Pair> scattered_pairs(const View& view) {
  const io::SampleTable& t = view.table();
  const auto unit = [](double angle) { return std::int32_t(std::lround(angle * 1e3)); };
  std::vector<std::pair<Place, Row>> places;
  // Very many rows are thinned; a pair keeps both partners or loses both.
  constexpr double kMostScattered = 100'000, kGolden = 0.6180339887498949;
  const double share = kMostScattered / double(t.rows());
  for (std::size_t k = 0; k < t.rows(); ++k) {
    if (std::isnan(view.level(k))) continue;
    const Place at{unit(t.theta_i[k]), unit(t.theta_o[k]), unit(std::abs(view.turn(k)))};
    const auto& [i, o, turn] = at;
    const double lot = kGolden * (double(i) + o) + 0.7071 * std::abs(double(i) - o) + 0.4142 * turn;
    if (share >= 1 || lot - std::floor(lot) < share) places.emplace_back(at, Row(k));
  }
  std::ranges::sort(places);
  std::vector<Pair> pairs;
  for (const auto& [place, k] : places) {
    const auto& [i, o, turn] = place;
    if (i >= o) continue;
    const auto partner = std::ranges::lower_bound(places, std::pair(Place{o, i, turn}, Row(0)));
    if (partner == places.end() || partner->first != Place{o, i, turn}) continue;
    const Row j = partner->second;
    pairs.push_back({0, 0, t.theta_i[k], t.theta_o[k], std::abs(view.turn(k)), view.level(k) - view.level(j),
                     0, (double(k) - double(j)) / double(t.rows()), k, j});
  }
  return pairs;
}

}  // namespace

std::vector<Pair> reciprocal_pairs(const View& view) {
  return io::evenly(view.scans().empty() ? scattered_pairs(view) : scanned_pairs(view), kMostPairs);
}

}  // namespace brdf::sheet
