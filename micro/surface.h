// Explicit microgeometry: a periodic height field over a regular grid, interpreted as a triangle mesh.
#pragma once

#include <vector>

#include "micro/march.h"

namespace brdf::micro {

// One period of the surface, [0, period_x) x [0, period_y), continued periodically. Vertex (i, j) lies at
// (i dx, j dy). Each grid cell has two triangles; the diagonal alternates from cell to cell, which avoids a
// preferred diagonal of the mesh. Heights have single precision, as on a Vulkan device.
struct Surface {
  int nx = 0, ny = 0;
  double dx = 1, dy = 1;
  std::vector<float> heights;  // row by row, nx per row
  std::vector<float> tops;     // greatest height of each block of cells (march.glsl), row by row
  double z_max = 0;
  // Each group of `columns_per_frame` columns is turned about the macroscopic normal.
  std::vector<Turn> turns{{1, 0}};
  int columns_per_frame = 1 << 30;

  double period_x() const { return nx * dx; }
  double period_y() const { return ny * dy; }
  float vertex(int i, int j) const { return heights[std::size_t(j) * std::size_t(nx) + std::size_t(i)]; }
  // Returns the tracer of this surface, which refers to it.
  March march() const;
  // Returns triangle `half` (0 or 1) of cell (i, j). Indices are taken modulo the period; x0 and y0 are not.
  Facet facet(int i, int j, int half) const;
  // Returns the triangle over the point (x, y), for any real numbers.
  Facet facet_at(double x, double y) const;
  // Sets tops and z_max from the heights.
  void find_tops();
};

// Mean squares of the slopes of the mesh, weighted by projected area. A Beckmann surface has alpha^2 / 2.
struct SlopeVariance {
  double x, y;
};
SlopeVariance slope_variance(const Surface& surface);

}  // namespace brdf::micro
