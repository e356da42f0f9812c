#include "micro/surface.h"

#include <algorithm>
#include <cmath>

namespace brdf::micro {
namespace {

int wrap(int index, int count) {
  const int rest = index % count;
  return rest < 0 ? rest + count : rest;
}

}  // namespace

Facet Surface::facet(int i, int j, int half) const {
  const int i0 = wrap(i, nx), j0 = wrap(j, ny), i1 = wrap(i + 1, nx), j1 = wrap(j + 1, ny);
  const double z00 = vertex(i0, j0), z10 = vertex(i1, j0), z01 = vertex(i0, j1), z11 = vertex(i1, j1);
  Facet f{i * dx, j * dy, z00, 0, 0};
  if (rising_diagonal(i0, j0)) {
    f.slope_x = (half == 0 ? z10 - z00 : z11 - z01) / dx;
    f.slope_y = (half == 0 ? z11 - z10 : z01 - z00) / dy;
    return f;
  }
  f.slope_x = (half == 0 ? z10 - z00 : z11 - z01) / dx;
  f.slope_y = (half == 0 ? z01 - z00 : z11 - z10) / dy;
  if (half == 1) f.z0 = z11 - f.slope_x * dx - f.slope_y * dy;
  return f;
}

Facet Surface::facet_at(double x, double y) const {
  const double u = x / dx, v = y / dy;
  const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
  const double fu = u - i, fv = v - j;
  const bool upper = rising_diagonal(wrap(i, nx), wrap(j, ny)) ? fv > fu : fu + fv > 1;
  return facet(i, j, upper ? 1 : 0);
}

double Surface::azimuth_at(double x) const {
  if (azimuths.empty()) return 0;
  const int column = static_cast<int>(std::floor(x / dx)) / columns_per_frame;
  return azimuths[wrap(column, static_cast<int>(azimuths.size()))];
}

void Surface::find_range() {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  z_min = *low;
  z_max = *high;
}

SlopeVariance slope_variance(const Surface& surface) {
  double x = 0, y = 0;
  for (int j = 0; j < surface.ny; ++j) {
    for (int i = 0; i < surface.nx; ++i) {
      for (int half = 0; half < 2; ++half) {
        const Facet f = surface.facet(i, j, half);
        x += f.slope_x * f.slope_x;
        y += f.slope_y * f.slope_y;
      }
    }
  }
  const double count = 2.0 * surface.nx * surface.ny;
  return {x / count, y / count};
}

}  // namespace brdf::micro
