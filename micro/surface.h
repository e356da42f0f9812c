// Explicit microgeometry: a periodic height field over a regular grid, read as a triangle mesh.
#pragma once

#include <cstddef>
#include <vector>

namespace brdf::micro {

// A plane triangle of the mesh: z = z0 + slope_x (x - x0) + slope_y (y - y0), in the surface's own units of
// length.
struct Facet {
  double x0, y0, z0;
  double slope_x, slope_y;

  double height(double x, double y) const { return z0 + slope_x * (x - x0) + slope_y * (y - y0); }
};

// One period of the surface, [0, period_x) x [0, period_y), continued periodically. Vertex (i, j) lies at
// (i dx, j dy); each grid cell holds two triangles, and the diagonal alternates from cell to cell, so that
// the mesh has no preferred diagonal. Heights are single precision because the ray tracer's are: both see
// the same mesh.
struct Surface {
  int nx = 0, ny = 0;
  double dx = 1, dy = 1;
  std::vector<float> heights;  // row by row, nx per row
  double z_min = 0, z_max = 0;
  // Azimuth (radians) to which each group of `columns_per_frame` columns is turned; empty: nothing is
  // turned.
  std::vector<double> azimuths;
  int columns_per_frame = 1;

  double period_x() const { return nx * dx; }
  double period_y() const { return ny * dy; }
  float vertex(int i, int j) const { return heights[static_cast<std::size_t>(j) * nx + i]; }
  // Triangle `half` (0 or 1) of cell (i, j); indices are taken modulo the period, x0 and y0 are not.
  Facet facet(int i, int j, int half) const;
  // The triangle over the point (x, y), any real numbers.
  Facet facet_at(double x, double y) const;
  // Azimuth of the part of the surface over x in [0, period_x).
  double azimuth_at(double x) const;
  // The diagonal of cell (i, j), 0 <= i < nx and 0 <= j < ny: from (i, j) to (i+1, j+1), or from (i+1, j) to
  // (i, j+1).
  static bool rising_diagonal(int i, int j) { return ((i + j) & 1) == 0; }
  // Sets z_min and z_max from the heights.
  void find_range();
};

// Mean squares of the mesh's own slopes, weighted by projected area: what a Beckmann surface has as alpha^2
// / 2.
struct SlopeVariance {
  double x, y;
};
SlopeVariance slope_variance(const Surface& surface);

}  // namespace brdf::micro
