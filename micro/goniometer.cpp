#include "micro/goniometer.h"

#include <array>
#include <cmath>

#include "brdf/directions.h"
#include "micro/strata.h"

namespace brdf::micro {
namespace {

void add_scaled(Account& sum, const Account& part, double scale) {
  sum.escaped.resize(part.escaped.size());
  for (std::size_t k = 0; k < part.escaped.size(); ++k) sum.escaped[k] += scale * part.escaped[k];
  sum.absorbed += scale * part.absorbed;
  sum.beyond += scale * part.beyond;
  sum.leaked += scale * part.leaked;
}

Account empty_account(const Simulation& s) {
  return {.escaped = std::vector<double>(s.max_bounces)};
}

using Energies = std::array<std::vector<double>, kOrderClasses>;

struct SurfaceScatter {
  std::vector<Energies> energies;  // [incidence], power shares per order class and cell
  std::vector<Account> accounts;
};

SurfaceScatter scatter_on(const Surface& surface, Random& random, const Simulation& s,
                          const std::vector<Incidence>& incidences, const Cells& cells) {
  SurfaceScatter result;
  March march = surface.march();
  const double share = 1.0 / strata_count(s.rays);
  for (const Incidence& from : incidences) {
    Energies energies;
    energies.fill(std::vector<double>(cells.size()));
    Account account = empty_account(s), shares;
    const Vec wi = direction(from.theta, from.phi);
    const auto leave = [&](int order, const Vec& wo, double weight) {
      energies[order_class(order)][cells.find(wo, from.phi)] += weight * share;
    };
    if (s.device && s.facets.reflection == Reflection::mirror) {
      std::vector<Start> starts;
      for_each_stratum(s.rays, random, [&](double u, double v) { starts.push_back({u, v}); });
      s.device->follow(surface, wi, s.facets.eta, s.max_bounces, starts,
                       [&](const Path& path) { settle(path, account, leave); });
    } else {
      for_each_stratum(s.rays, random,
                       [&](double u, double v) { walk(march, s.facets, wi, u, v, random, account, leave); });
    }
    add_scaled(shares, account, share);
    result.energies.push_back(std::move(energies));
    result.accounts.push_back(std::move(shares));
  }
  return result;
}

struct ScatterCollector {
  std::array<std::vector<Collector>, kOrderClasses> f;
  std::vector<Collector> total;
  Collector albedo;
  Account account;

  void add(const Energies& energies, const Account& part, const Cells& cells, double share) {
    total.resize(cells.size());
    for (auto& order : f) order.resize(cells.size());
    for (int c = 0; c < cells.size(); ++c) {
      const double scale = 1 / cells[c].projected_solid_angle();
      double sum = 0;
      for (int k = 0; k < kOrderClasses; ++k) {
        f[k][c].add(energies[k][c] * scale);
        sum += energies[k][c] * scale;
      }
      total[c].add(sum);
    }
    albedo.add(part.albedo());
    add_scaled(account, part, share);
  }
};

std::vector<Estimate> estimates(const std::vector<Collector>& collectors) {
  std::vector<Estimate> result;
  for (const Collector& c : collectors) result.push_back(c.estimate());
  return result;
}

// Radiance towards `view` of the path that starts with `wo`, for light from each source in turn:
// [source][order class].
using Shares = std::vector<std::array<double, kOrderClasses>>;

void view_path(March& march, const Simulation& s, const Vec& wo, const std::vector<Vec>& sources, double u,
               double v, Random& random, Shares& shares) {
  Place place = march.entry(u, v);
  const Turn turn = march.turns[place.i / march.columns_per_frame];
  Vec travel = march.turned_by(wo * -1.0, turn.cosine, -turn.sine);
  double weight = 1;
  for (int order = 1; order <= s.max_bounces; ++order) {
    const March::Meeting met = march.march(place, travel);
    if (met.fate != March::hit) return;
    place = met.place;
    weight *= s.facets.rho;
    const Vec n = normal(met.facet);
    for (std::size_t k = 0; k < sources.size(); ++k) {
      const Vec wi = march.turned_by(sources[k], turn.cosine, -turn.sine);
      const double cosine = dot(n, wi);
      if (cosine <= 0 || march.march(place, wi).fate != March::escaped) continue;
      shares[k][order_class(order)] += weight * cosine / (kPi * sources[k].z);
    }
    travel = cosine_direction(met.facet, random);
  }
}

}  // namespace

Surface make_surface(const Simulation& simulation, int index) {
  Random random = random_for(simulation.seed, index, Purpose::geometry);
  if (const auto* field = std::get_if<HeightField>(&simulation.geometry))
    return make_height_field(*field, random);
  return make_grooves(std::get<Grooves>(simulation.geometry), random);
}

std::vector<Scatter> measure_scatter(const Simulation& s, const std::vector<Incidence>& incidences,
                                     const Cells& cells, const Progress& progress) {
  std::vector<ScatterCollector> collectors(incidences.size());
  on_each_surface(
      s, Purpose::scatter, progress,
      [&](const Surface& surface, Random& random) {
        return scatter_on(surface, random, s, incidences, cells);
      },
      [&](const SurfaceScatter& one) {
        for (std::size_t k = 0; k < incidences.size(); ++k)
          collectors[k].add(one.energies[k], one.accounts[k], cells, 1.0 / s.surfaces);
      });
  std::vector<Scatter> result;
  for (std::size_t k = 0; k < incidences.size(); ++k) {
    Scatter scatter;
    scatter.incidence = incidences[k];
    scatter.account = collectors[k].account;
    scatter.albedo = collectors[k].albedo.estimate();
    for (int order = 0; order < kOrderClasses; ++order) scatter.f[order] = estimates(collectors[k].f[order]);
    scatter.total = estimates(collectors[k].total);
    result.push_back(std::move(scatter));
  }
  return result;
}

std::vector<std::vector<Radiance>> measure_radiance(const Simulation& s,
                                                    const std::vector<Incidence>& incidences,
                                                    const std::vector<Incidence>& views,
                                                    const Progress& progress) {
  std::vector<Vec> sources;
  for (const Incidence& i : incidences) sources.push_back(direction(i.theta, i.phi));
  struct Collected {
    std::array<Collector, kOrderClasses> f;
    Collector total;
  };
  std::vector<std::vector<Collected>> collected(sources.size(), std::vector<Collected>(views.size()));
  const double share = 1.0 / strata_count(s.rays);
  const auto job = [&](const Surface& surface, Random& random) {
    March march = surface.march();
    std::vector<Shares> result;
    for (const Incidence& view : views) {
      const Vec wo = direction(view.theta, view.phi);
      Shares shares(sources.size());
      for_each_stratum(s.rays, random,
                       [&](double u, double v) { view_path(march, s, wo, sources, u, v, random, shares); });
      result.push_back(std::move(shares));
    }
    return result;
  };
  on_each_surface(s, Purpose::radiance, progress, job, [&](const std::vector<Shares>& one) {
    for (std::size_t v = 0; v < views.size(); ++v) {
      for (std::size_t k = 0; k < sources.size(); ++k) {
        double sum = 0;
        for (int order = 0; order < kOrderClasses; ++order) {
          const double f = one[v][k][order] * share;
          collected[k][v].f[order].add(f);
          sum += f;
        }
        collected[k][v].total.add(sum);
      }
    }
  });
  std::vector<std::vector<Radiance>> result(sources.size(), std::vector<Radiance>(views.size()));
  for (std::size_t k = 0; k < sources.size(); ++k) {
    for (std::size_t v = 0; v < views.size(); ++v) {
      for (int order = 0; order < kOrderClasses; ++order)
        result[k][v].f[order] = collected[k][v].f[order].estimate();
      result[k][v].total = collected[k][v].total.estimate();
    }
  }
  return result;
}

Exchange measure_exchange(const Simulation& s, const Cell& a, const Cell& b, const Progress& progress) {
  const auto inside = [](const Cell& cell, const Vec& w) {
    const double theta = std::acos(std::min(w.z, 1.0));
    double phi = std::atan2(w.y, w.x);
    while (phi < cell.phi_low) phi += 2 * kPi;
    return theta >= cell.theta_low && theta < cell.theta_high && phi < cell.phi_high;
  };
  const double share = 1.0 / strata_count(s.rays);
  const auto one_way = [&](March march, Random& random, const Cell& from, const Cell& to) {
    double power = 0;
    Account account = empty_account(s);
    for_each_stratum(s.rays, random, [&](double u, double v) {
      const double a1 = random.uniform(), a2 = random.uniform();
      walk(march, s.facets, from.point(a1, a2), u, v, random, account,
           [&](int, const Vec& wo, double weight) {
             if (inside(to, wo)) power += weight;
           });
    });
    return power * share / to.projected_solid_angle();
  };
  Collector forward, backward;
  on_each_surface(
      s, Purpose::exchange, progress,
      [&](const Surface& surface, Random& random) {
        const double there = one_way(surface.march(), random, a, b);
        return std::pair{there, one_way(surface.march(), random, b, a)};
      },
      [&](const std::pair<double, double>& one) {
        forward.add(one.first);
        backward.add(one.second);
      });
  return {forward.estimate(), backward.estimate()};
}

}  // namespace brdf::micro
