#include "micro/walk.h"

namespace brdf::micro {

Path path_over_lambert(March& march, const Vec& wi, double u, double v, double rho, int limit,
                       Random& random) {
  Place place = march.entry(u, v);
  const Turn turn = march.turns[place.i / march.columns_per_frame];
  Path path{march.turned_by(wi * -1.0, turn.cosine, -turn.sine), 1, 0, 0, March::hit};
  for (; path.order < limit; ++path.order) {
    const March::Meeting met = march.march(place, path.travel);
    path.fate = met.fate;
    if (path.fate != March::hit) break;
    place = met.place;
    path.absorbed += path.weight * (1 - rho);
    path.weight *= rho;
    path.travel = cosine_direction(met.facet, random);
  }
  if (path.order == limit) path.fate = march.march(place, path.travel).fate;
  path.travel = march.turned_by(path.travel, turn.cosine, turn.sine);
  return path;
}

}  // namespace brdf::micro
