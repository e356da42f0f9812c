#include "prove/scalar/facet_albedo.h"

#include <queue>
#include <vector>

namespace brdf::prove {
namespace {

struct Cell {
  FacetRange at;
  FacetPart part;
  bool operator<(const Cell& other) const { return part.width < other.part.width; }
};

}  // namespace

Bounds integrate_cells(const std::function<FacetPart(const FacetRange&)>& part, Bounds turn,
                       double accuracy) {
  const std::size_t most = std::size_t(6 / accuracy);
  std::priority_queue<Cell> cells;
  double width = 0;
  const auto add = [&](Bounds z, Bounds phi, bool second) {
    const FacetRange at{z, phi, second};
    const FacetPart found = part(at);
    width += found.width;
    cells.push({at, found});
  };
  for (const bool second : {false, true}) add({0, 1}, {0, kPiBounds.hi / 2}, second);
  while (!(width <= accuracy) && cells.size() < most) {
    const Cell widest = cells.top();
    cells.pop();
    width -= widest.part.width;
    const Bounds z = widest.at.z, phi = widest.at.phi;
    const double low = 0.5 * (z.lo + z.hi), first = 0.5 * (phi.lo + phi.hi);
    for (const Bounds part_z : {Bounds{z.lo, low}, Bounds{low, z.hi}})
      for (const Bounds part_phi : {Bounds{phi.lo, first}, Bounds{first, phi.hi}})
        add(part_z, part_phi, widest.at.second);
  }
  Exactly base, slope;
  for (; !cells.empty(); cells.pop()) {
    base = base + cells.top().part.base;
    slope = slope + cells.top().part.slope;
  }
  const double half = 0.5 * (turn.hi - turn.lo) * (1 + 1e-12);
  const Exactly all = base + slope * Exactly::of(-half, half);
  return {all.lo, all.hi};
}

}  // namespace brdf::prove
