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

March Surface::march() const {
  return {heights.data(), tops.data(), turns.data(), nx, ny, columns_per_frame, dx, dy, z_max};
}

Facet Surface::facet(int i, int j, int half) const {
  const int i0 = wrap(i, nx), j0 = wrap(j, ny);
  Facet f = march().facet_of(i0, j0, half);
  f.x0 = i * dx;
  f.y0 = j * dy;
  return f;
}

Facet Surface::facet_at(double x, double y) const {
  const int i = int(std::floor(x / dx)), j = int(std::floor(y / dy));
  const int i0 = wrap(i, nx), j0 = wrap(j, ny);
  const double side = march().side_of(i0, j0, x - (i - i0) * dx, y - (j - j0) * dy);
  return facet(i, j, side > 0 ? 1 : 0);
}

void Surface::find_tops() {
  constexpr int kSide = March::block_cells;
  tops.clear();
  for (int low_j = 0; low_j < ny; low_j += kSide) {
    for (int low_i = 0; low_i < nx; low_i += kSide) {
      float top = vertex(low_i, low_j);
      for (int j = low_j; j <= std::min(low_j + kSide, ny); ++j)
        for (int i = low_i; i <= std::min(low_i + kSide, nx); ++i)
          top = std::max(top, vertex(i % nx, j % ny));
      tops.push_back(top);
    }
  }
  z_max = *std::ranges::max_element(tops);
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
