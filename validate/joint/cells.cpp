#include "validate/joint/cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "brdf/quadrature.h"

namespace brdf::validate {
namespace {

constexpr int kQuarters = 4, kGroupDepth = 2, kDeepest = 10;
constexpr int kOrder = 4;

double azimuth_of(const Vec3<double>& w) {
  const double phi = std::atan2(w.y, w.x);
  return phi < 0 ? phi + 2 * kPi : phi;
}
double height_of(const Vec3<double>& w) {
  return std::clamp(1 - w.z, 0.0, 1.0);
}
Vec3<double> at_place(double s, double phi) {
  const double rho = std::sqrt(std::max(s * (2 - s), 0.0));
  return {rho * std::cos(phi), rho * std::sin(phi), 1 - s};
}

}  // namespace

Cells::Cells(std::span<const Vec3<double>> directions) {
  std::array<std::vector<Vec3<double>>, kQuarters> quarters;
  for (const Vec3<double>& w : directions)
    if (w.z > 0) quarters[std::size_t(std::min(int(azimuth_of(w) / (kPi / 2)), 3))].push_back(w);
  const std::size_t least = std::max<std::size_t>(directions.size() / 256, 2);
  for (int q = 0; q < kQuarters; ++q) {
    std::vector<Vec3<double>>& points = quarters[std::size_t(q)];
    roots_.push_back(
        divide(points, 0, points.size(), {0, 1, q * kPi / 2, (q + 1) * kPi / 2}, 0, 4 * q, least));
  }
}

int Cells::divide(std::vector<Vec3<double>>& points, std::size_t begin, std::size_t end, Cell cell, int depth,
                  int group, std::size_t least) {
  const int number = int(nodes_.size());
  nodes_.emplace_back();
  const bool grid = points.empty();
  if (depth >= (grid ? 4 : kDeepest) || (!grid && depth >= kGroupDepth && end - begin < 2 * least)) {
    nodes_[std::size_t(number)].above = int(cells_.size());
    cells_.push_back(cell);
    groups_.push_back(group);
    return number;
  }
  const bool by_phi = depth % 2 == 1;
  const auto key = [&](const Vec3<double>& w) { return by_phi ? azimuth_of(w) : height_of(w); };
  const double low = by_phi ? cell.phi0 : cell.s0, high = by_phi ? cell.phi1 : cell.s1;
  double at = (low + high) / 2;
  std::size_t middle = begin + (end - begin) / 2;
  if (end - begin >= 2) {
    std::nth_element(points.begin() + long(begin), points.begin() + long(middle), points.begin() + long(end),
                     [&](const auto& a, const auto& b) { return key(a) < key(b); });
    const double median = key(points[middle]);
    if (median > low && median < high) at = median;
  }
  middle = std::size_t(std::partition(points.begin() + long(begin), points.begin() + long(end),
                                      [&](const auto& w) { return key(w) < at; }) -
                       points.begin());
  Cell lower = cell, upper = cell;
  (by_phi ? lower.phi1 : lower.s1) = at;
  (by_phi ? upper.phi0 : upper.s0) = at;
  const int bit = depth < kGroupDepth ? 1 << depth : 0;
  const int below = divide(points, begin, middle, lower, depth + 1, group, least);
  const int above = divide(points, middle, end, upper, depth + 1, group + bit, least);
  nodes_[std::size_t(number)] = {by_phi, at, below, above};
  return number;
}

std::size_t Cells::find(const Vec3<double>& wi) const {
  const double s = height_of(wi), phi = azimuth_of(wi);
  int node = roots_[std::size_t(std::min(int(phi / (kPi / 2)), kQuarters - 1))];
  for (;;) {
    const Node& n = nodes_[std::size_t(node)];
    if (n.below < 0) return std::size_t(n.above);
    node = (n.by_phi ? phi : s) < n.at ? n.below : n.above;
  }
}

namespace {

// The integrals over one rectangle: of the density, of f cos, and of f cos where the density is 0.
struct Piece {
  Cell cell;
  std::size_t of = 0;
  double density = 0, error = 0, f_error = 0;
  double peak = 0;  // the largest density at a point of the rule
  std::array<double, 3> f{}, lost{};

  double priority() const { return error + f_error; }
  friend bool operator<(const Piece& a, const Piece& b) { return a.priority() < b.priority(); }
};

class Integrator {
 public:
  Integrator(const Trio& trio, Integrals& out) : trio_(trio), out_(out) {}

  long evaluations() const { return out_.evaluations; }

  // Integrates pieces together, because many directions at a time cost less.
  void integrate(std::span<Piece> pieces) {
    const quadrature::GaussRule& rule = quadrature::gauss_legendre(kOrder);
    std::vector<Vec3<double>> wi;
    for (const Piece& p : pieces)
      for (int i = 0; i < kOrder; ++i)
        for (int j = 0; j < kOrder; ++j)
          wi.push_back(at_place(p.cell.s0 + (p.cell.s1 - p.cell.s0) * rule.node[std::size_t(i)],
                                p.cell.phi0 + (p.cell.phi1 - p.cell.phi0) * rule.node[std::size_t(j)]));
    const std::vector<double> f = trio_.f(wi, true);
    const std::vector<double> p = trio_.density(wi);
    out_.evaluations += long(wi.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      Piece& piece = pieces[k];
      const double area = (piece.cell.s1 - piece.cell.s0) * (piece.cell.phi1 - piece.cell.phi0);
      for (std::size_t at = 0; at < std::size_t(kOrder * kOrder); ++at) {
        const std::size_t row = k * std::size_t(kOrder * kOrder) + at;
        const double weight = area * rule.weight[at / kOrder] * rule.weight[at % kOrder];
        if (std::isfinite(p[row]) && p[row] >= 0)
          piece.density += weight * p[row], piece.peak = std::max(piece.peak, p[row]);
        else if (out_.all_finite)
          out_.all_finite = false, out_.not_finite = wi[row];
        double brightest = 0;
        for (std::size_t c = 0; c < std::min<std::size_t>(trio_.channels(), 3); ++c) {
          const double value = f[c * wi.size() + row];
          if (!std::isfinite(value)) continue;
          piece.f[c] += weight * value;
          brightest = std::max(brightest, value);
          if (!(p[row] > 0)) piece.lost[c] += weight * value;
        }
        if (!(p[row] > 0) && brightest > out_.unreached_value)
          out_.unreached_value = brightest, out_.unreached = wi[row];
      }
    }
  }

 private:
  const Trio& trio_;
  Integrals& out_;
};

// Divides a rectangle into four.
std::array<Piece, 4> quarters_of(const Piece& p) {
  const Cell& c = p.cell;
  const double s = (c.s0 + c.s1) / 2, phi = (c.phi0 + c.phi1) / 2;
  std::array<Piece, 4> out;
  const Cell cells[4] = {
      {c.s0, s, c.phi0, phi}, {s, c.s1, c.phi0, phi}, {c.s0, s, phi, c.phi1}, {s, c.s1, phi, c.phi1}};
  for (std::size_t k = 0; k < 4; ++k) out[k].cell = cells[k], out[k].of = p.of;
  return out;
}

// The rectangles of a cell, divided towards a direction that lies in the cell.
void add_divided(const Piece& whole, double s, double phi, int times, std::vector<Piece>& out) {
  if (times == 0) return void(out.push_back(whole));
  for (const Piece& part : quarters_of(whole)) {
    const bool holds =
        s >= part.cell.s0 && s <= part.cell.s1 && phi >= part.cell.phi0 && phi <= part.cell.phi1;
    add_divided(part, s, phi, holds ? times - 1 : 0, out);
  }
}

// A sampled direction and the density there.
struct Place {
  double s, phi, density;
};

bool holds(const Cell& c, const Place& place) {
  return place.s >= c.s0 && place.s <= c.s1 && place.phi >= c.phi0 && place.phi <= c.phi1;
}

// Returns whether the density at a sampled direction is much larger than at the points of the piece's rule.
// Then a narrow lobe, or the edge of one, may lie between the points without a trace in the difference
// between a piece and its quarters.
bool is_missed(const Piece& piece, const Place& place) {
  constexpr double kMuchLarger = 2;
  return place.density > kMuchLarger * piece.peak;
}

// Divides a piece until its rule misses no sampled direction, at most `times`, and within `most` evaluations.
void add_resolved(Integrator& integrator, const Piece& whole, std::vector<Place> places, int times, long most,
                  std::vector<Piece>& out) {
  const bool is_seen = std::ranges::none_of(places, [&](const Place& p) { return is_missed(whole, p); });
  if (times == 0 || is_seen || integrator.evaluations() >= most) return void(out.push_back(whole));
  std::array<Piece, 4> quarters = quarters_of(whole);
  integrator.integrate(quarters);
  for (const Piece& quarter : quarters) {
    std::vector<Place> own;
    for (const Place& place : places)
      if (holds(quarter.cell, place)) own.push_back(place);
    add_resolved(integrator, quarter, std::move(own), times - 1, most, out);
  }
}

// Returns the share of directions that the rules of their pieces miss. `places`: of each cell.
double missed_share(std::span<const Piece> pieces, const std::vector<std::vector<Place>>& places) {
  std::size_t missed = 0, all = 0;
  for (const auto& of_cell : places) all += of_cell.size();
  for (const Piece& piece : pieces)
    missed += std::size_t(std::ranges::count_if(places[piece.of], [&](const Place& place) {
      return holds(piece.cell, place) && is_missed(piece, place);
    }));
  return all > 0 ? double(missed) / double(all) : 0;
}

}  // namespace

Integrals integrals_of(const Trio& trio, const Cells& cells, std::span<const Vec3<double>> directions,
                       double tolerance, long most) {
  constexpr int kTowardsMirror = 7;
  Integrals out;
  out.density.assign(cells.all().size(), 0);
  out.albedo.assign(trio.channels(), 0);
  out.without_density.assign(trio.channels(), 0);
  Integrator integrator(trio, out);
  const Vec3<double> mirror{-trio.at().wo.x, -trio.at().wo.y, trio.at().wo.z};
  const std::size_t with_mirror = cells.find(mirror);
  std::vector<Piece> undivided;
  for (std::size_t k = 0; k < cells.all().size(); ++k) {
    Piece piece;
    piece.cell = cells.all()[k];
    piece.of = k;
    add_divided(piece, height_of(mirror), azimuth_of(mirror), k == with_mirror ? kTowardsMirror : 0,
                undivided);
  }
  integrator.integrate(undivided);
  const std::vector<double> densities = trio.density(directions);
  out.evaluations += long(directions.size());
  // The first half of the directions divides the cells, the other half tells how much is still missed.
  std::vector<std::vector<Place>> places(cells.all().size()), others(cells.all().size());
  for (std::size_t k = 0; k < directions.size(); ++k) {
    if (!std::isfinite(densities[k]) || densities[k] < 0) {
      if (out.all_finite) out.all_finite = false, out.not_finite = directions[k];
      continue;
    }
    (k < directions.size() / 2 ? places : others)[cells.find(directions[k])].push_back(
        {height_of(directions[k]), azimuth_of(directions[k]), densities[k]});
  }
  std::vector<Piece> first;
  for (const Piece& whole : undivided) {
    std::vector<Place> own;
    for (const Place& place : places[whole.of])
      if (holds(whole.cell, place)) own.push_back(place);
    constexpr int kMostTimes = 24;
    add_resolved(integrator, whole, std::move(own), kMostTimes, most, first);
  }
  double scale = 1e-300;
  for (const Piece& p : first) scale += p.f[0] + p.f[1] + p.f[2];
  // The error of a piece is its change when it is divided; each quarter keeps a quarter of the change.
  std::vector<Piece> open;  // a heap: the largest error first
  const auto divide = [&](std::span<const Piece> wholes) {
    std::vector<Piece> parts;
    for (const Piece& whole : wholes) {
      const auto four = quarters_of(whole);
      parts.insert(parts.end(), four.begin(), four.end());
    }
    integrator.integrate(parts);
    for (std::size_t k = 0; k < wholes.size(); ++k) {
      double density = -wholes[k].density, f = 0;
      for (std::size_t j = 0; j < 4; ++j) density += parts[4 * k + j].density;
      for (std::size_t c = 0; c < 3; ++c) {
        double change = -wholes[k].f[c], lost = -wholes[k].lost[c];
        for (std::size_t j = 0; j < 4; ++j) change += parts[4 * k + j].f[c], lost += parts[4 * k + j].lost[c];
        f = std::max({f, std::abs(change), std::abs(lost)});
      }
      for (std::size_t j = 0; j < 4; ++j) {
        parts[4 * k + j].error = std::abs(density) / 4;
        parts[4 * k + j].f_error = f / scale / 4;
        open.push_back(parts[4 * k + j]);
        std::push_heap(open.begin(), open.end());
      }
    }
  };
  divide(first);
  while (out.evaluations < most) {
    double error = 0;
    for (const Piece& p : open) error += p.priority();
    if (!(error > tolerance)) break;
    std::vector<Piece> worst;
    while (!open.empty() && worst.size() < 128 && open.front().priority() > 0) {
      std::pop_heap(open.begin(), open.end());
      worst.push_back(open.back());
      open.pop_back();
    }
    if (worst.empty()) break;
    divide(worst);
  }
  out.mass_error = missed_share(open, others);
  for (const Piece& p : open) {
    out.density[p.of] += p.density;
    out.mass += p.density;
    out.mass_error += p.error;
    out.albedo_error += p.f_error * scale;
    for (std::size_t c = 0; c < std::min<std::size_t>(trio.channels(), 3); ++c) {
      out.albedo[c] += p.f[c];
      out.without_density[c] += p.lost[c];
    }
  }
  return out;
}

}  // namespace brdf::validate
