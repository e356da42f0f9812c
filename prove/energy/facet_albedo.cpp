#include "prove/energy/facet_albedo.h"

#include <queue>

namespace brdf::prove {
namespace {

struct Cell {
  FacetRange at;
  FacetPart part;
  bool operator<(const Cell& other) const { return part.width < other.part.width; }
};

}  // namespace

AlbedoBounds integrate_cells(const std::function<FacetPart(const FacetRange&)>& part, const Views& views,
                             int quadrants, double accuracy) {
  const std::size_t most = std::size_t(6 / accuracy);
  std::priority_queue<Cell> cells;
  double width = 0;
  const auto add = [&](Bounds step, Bounds phi, int quadrant) {
    const FacetRange at{step, phi, quadrant};
    const FacetPart found = part(at);
    width += found.width;
    cells.push({at, found});
  };
  for (int q = 0; q < quadrants; ++q) add({0, 1}, {0, kPiBounds.hi / 2}, q);
  while (!(width <= accuracy) && cells.size() < most) {
    const Cell widest = cells.top();
    cells.pop();
    width -= widest.part.width;
    const Bounds step = widest.at.step, phi = widest.at.phi;
    const double low = 0.5 * (step.lo + step.hi), first = 0.5 * (phi.lo + phi.hi);
    for (const Bounds part_step : {Bounds{step.lo, low}, Bounds{low, step.hi}})
      for (const Bounds part_phi : {Bounds{phi.lo, first}, Bounds{first, phi.hi}})
        add(part_step, part_phi, widest.at.quadrant);
  }
  Exactly all, by_turn, by_azimuth;
  for (; !cells.empty(); cells.pop()) {
    const FacetPart& p = cells.top().part;
    all = all + p.base;
    by_turn = by_turn + p.slopes[0];
    by_azimuth = by_azimuth + p.slopes[1];
  }
  const auto within = [](Bounds b) {
    const double half = 0.5 * (b.hi - b.lo) * (1 + 1e-12);
    return Exactly::of(-half, half);
  };
  by_turn = by_turn * within(views.turn);
  by_azimuth = by_azimuth * within(views.azimuth);
  all = all + by_turn + by_azimuth;
  return {{all.lo, all.hi}, {by_turn.hi - by_turn.lo, by_azimuth.hi - by_azimuth.lo}};
}

}  // namespace brdf::prove
