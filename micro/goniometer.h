// The BRDF of an explicit microsurface, measured with rays.
#pragma once

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "io/files/parallel.h"
#include "micro/cells.h"
#include "micro/device_paths.h"
#include "micro/estimate.h"
#include "micro/facets.h"
#include "micro/grooves.h"
#include "micro/height_field.h"
#include "micro/walk.h"

namespace brdf::micro {

using io::Progress;

// Orders of reflection are counted separately as 1, 2, and 3 or more.
constexpr int kOrderClasses = 3;
inline int order_class(int order) {
  return order < kOrderClasses ? order - 1 : kOrderClasses - 1;
}

struct Incidence {
  Angle theta, phi;
};

struct Simulation {
  std::variant<HeightField, Grooves> geometry;
  FacetOptics facets;
  int surfaces = 8;           // independent surfaces; at least 8 for a meaningful standard error
  std::int64_t rays = 65536;  // per surface and direction of incidence (or view)
  int max_bounces = 64;
  std::uint64_t seed = 1;
  int threads = int(io::all_processors());
  // Follows the paths over mirrors from one direction; null: this processor, with the same results as a
  // device that rounds correctly.
  std::shared_ptr<DevicePaths> device;
};

// Returns the surface with this index among the independent surfaces of the simulation.
Surface make_surface(const Simulation& simulation, int index);

// Runs job(surface, random) on every surface and passes the results to `consume` in order.
template <class Job, class Consume>
void on_each_surface(const Simulation& s, Purpose purpose, const Progress& progress, const Job& job,
                     const Consume& consume) {
  io::parallel_in_order(
      s.surfaces, s.threads, progress,
      [&](int index) {
        const Surface surface = make_surface(s, index);
        Random random = random_for(s.seed, index, purpose);
        return job(surface, random);
      },
      consume);
}

// Mean f_r (1/sr) over each cell of the outgoing hemisphere, with light from one direction.
struct Scatter {
  Incidence incidence;
  std::vector<Estimate> f[kOrderClasses];  // [order class][cell]
  std::vector<Estimate> total;             // all orders together, per cell
  Account account;                         // mean over surfaces
  Estimate albedo;
};

// Measures the power of the rays that leave through a cell, divided by the incident power and by the cell's
// integral of cos theta. The result is exactly the mean of f_r over the cell, weighted by cos theta.
// Azimuths of cells are measured from the phi of the incidence.
std::vector<Scatter> measure_scatter(const Simulation& simulation, const std::vector<Incidence>& incidences,
                                     const Cells& cells, const Progress& progress = {});

// f_r (1/sr) between exact directions, for Lambertian facets only. Rays start at the viewer; each facet on
// their path adds the light that arrives directly from every source.
struct Radiance {
  Estimate f[kOrderClasses];
  Estimate total;
};
// Returns the results as [incidence][view].
std::vector<std::vector<Radiance>> measure_radiance(const Simulation& simulation,
                                                    const std::vector<Incidence>& incidences,
                                                    const std::vector<Incidence>& views,
                                                    const Progress& progress = {});

// Mean f_r between two cells, in one direction and in the other. Both are equal if reciprocity holds.
struct Exchange {
  Estimate forward, backward;
};
Exchange measure_exchange(const Simulation& simulation, const Cell& a, const Cell& b,
                          const Progress& progress = {});

}  // namespace brdf::micro
