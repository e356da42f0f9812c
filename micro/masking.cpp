#include "micro/masking.h"

#include <cmath>

#include "brdf/directions.h"
#include "micro/strata.h"

namespace brdf::micro {
namespace {

struct SurfaceSlopes {
  SlopeVariance variance;
  std::vector<double> outside;
};

SurfaceSlopes slopes_of(const Surface& surface, const HeightField& field, const std::vector<double>& q) {
  SurfaceSlopes result{slope_variance(surface), std::vector<double>(q.size())};
  const double share = 1 / (2.0 * surface.nx * surface.ny);
  for (int j = 0; j < surface.ny; ++j) {
    for (int i = 0; i < surface.nx; ++i) {
      for (int half = 0; half < 2; ++half) {
        const Facet f = surface.facet(i, j, half);
        const double distance = square(f.slope_x / field.alpha_x) + square(f.slope_y / field.alpha_y);
        for (std::size_t k = 0; k < q.size(); ++k) result.outside[k] += distance > q[k] ? share : 0;
      }
    }
  }
  return result;
}

struct Counts {
  double towards = 0, away = 0, towards_seen = 0, away_seen = 0;  // points
  double facing_area = 0, seen_area = 0;
};

Counts look(const Surface& surface, const Vec& w, std::int64_t points, Random& random) {
  Counts counts;
  March march = surface.march();
  const double share = 1.0 / strata_count(points);
  for_each_stratum(points, random, [&](double u, double v) {
    Place place = march.entry(u, v);
    const Facet f = march.facet_of(place.i, place.j, place.upper);
    const double tilt = -f.slope_x * w.x - f.slope_y * w.y;
    const double area = w.z + tilt;  // area along w, per macroscopic area
    if (area <= 0) return;
    (tilt > 0 ? counts.towards : counts.away) += share;
    counts.facing_area += share * area;
    place.at.z = f.height(place.at.x, place.at.y);
    if (march.march(place, w).fate != March::escaped) return;
    (tilt > 0 ? counts.towards_seen : counts.away_seen) += share;
    counts.seen_area += share * area;
  });
  return counts;
}

struct MaskingCollector {
  Collector points, towards, away, projected, facing;

  void add(const Counts& c) {
    points.add((c.towards_seen + c.away_seen) / (c.towards + c.away));
    towards.add(c.towards_seen / c.towards);
    away.add(c.away_seen / c.away);
    projected.add(c.seen_area);
    facing.add(c.facing_area);
  }
};

}  // namespace

Slopes measure_slopes(const Simulation& s, const std::vector<double>& q, const Progress& progress) {
  const HeightField& field = std::get<HeightField>(s.geometry);
  Collector alpha_x, alpha_y;
  std::vector<Collector> outside(q.size());
  io::parallel_in_order(
      s.surfaces, s.threads, progress, [&](int index) { return slopes_of(make_surface(s, index), field, q); },
      [&](const SurfaceSlopes& one) {
        alpha_x.add(std::sqrt(2 * one.variance.x));
        alpha_y.add(std::sqrt(2 * one.variance.y));
        for (std::size_t k = 0; k < q.size(); ++k) outside[k].add(one.outside[k]);
      });
  Slopes result{alpha_x.estimate(), alpha_y.estimate(), {}};
  for (const Collector& c : outside) result.outside.push_back(c.estimate());
  return result;
}

std::vector<Masking> measure_masking(const Simulation& s, const std::vector<Angle>& thetas,
                                     const Progress& progress) {
  std::vector<MaskingCollector> collectors(thetas.size());
  on_each_surface(
      s, Purpose::masking, progress,
      [&](const Surface& surface, Random& random) {
        std::vector<Counts> counts;
        for (const Angle theta : thetas)
          counts.push_back(look(surface, direction(theta, {}), s.rays, random));
        return counts;
      },
      [&](const std::vector<Counts>& counts) {
        for (std::size_t k = 0; k < thetas.size(); ++k) collectors[k].add(counts[k]);
      });
  std::vector<Masking> result;
  for (std::size_t k = 0; k < thetas.size(); ++k) {
    const MaskingCollector& c = collectors[k];
    result.push_back({thetas[k], c.points.estimate(), c.towards.estimate(), c.away.estimate(),
                      c.projected.estimate(), c.facing.estimate()});
  }
  return result;
}

double smith_lambda(double alpha, Angle theta) {
  const double a = 1 / (alpha * std::tan(theta.radians()));
  return (std::exp(-a * a) / (a * std::sqrt(kPi)) - std::erfc(a)) / 2;
}

}  // namespace brdf::micro
