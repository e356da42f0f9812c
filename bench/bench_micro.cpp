// Measures rays per second on a traced microsurface: 2 million triangles, light from 60 degrees, all
// bounces.
#include <benchmark/benchmark.h>

#include <cmath>

#include "brdf/material.h"
#include "micro/goniometer.h"
#include "micro/strata.h"

namespace {

using namespace brdf::micro;
using brdf::Random;

void RaysAt60Degrees(benchmark::State& state) {
  Simulation simulation;
  const double alpha = static_cast<double>(state.range(0)) / 100;
  simulation.geometry = HeightField{.alpha_x = alpha, .alpha_y = alpha, .size = 1000};
  const Surface surface = make_surface(simulation, state.thread_index());
  March march = surface.march();
  Random random = random_for(1, state.thread_index(), Purpose::scatter);
  Account account{.escaped = std::vector<double>(64)};
  const Vec wi = brdf::direction(brdf::degrees(60), {});
  double rays = 0;
  for (auto _ : state) {
    for_each_stratum(1 << 20, random, [&](double u, double v) {
      walk(march, simulation.facets, wi, u, v, random, account,
           [&](int order, const Vec&, double) { rays += order + 1; });
    });
  }
  state.counters["rays"] = benchmark::Counter(rays, benchmark::Counter::kIsRate);
  state.counters["triangles"] =
      benchmark::Counter(2.0 * surface.nx * surface.ny, benchmark::Counter::kAvgThreads);
}
BENCHMARK(RaysAt60Degrees)->ArgName("alpha_percent")->Arg(10)->Arg(30)->Arg(50)->UseRealTime();
BENCHMARK(RaysAt60Degrees)->ArgName("alpha_percent")->Arg(10)->Arg(30)->Arg(50)->Threads(2)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
