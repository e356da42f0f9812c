// Explicit microgeometry: a periodic height field over a regular grid, interpreted as a triangle mesh.
#pragma once

#include <cstddef>
#include <vector>

namespace brdf::micro {

// A plane triangle of the mesh: z = z0 + slope_x (x - x0) + slope_y (y - y0), in the unit of length of the
// surface.
struct Facet {
  double x0, y0, z0;
  double slope_x, slope_y;

  double height(double x, double y) const { return z0 + slope_x * (x - x0) + slope_y * (y - y0); }
};

// One period of the surface, [0, period_x) x [0, period_y), continued periodically. Vertex (i, j) lies at
// (i dx, j dy). Each grid cell has two triangles; the diagonal alternates from cell to cell, which avoids a
// preferred diagonal of the mesh. Heights have single precision, like the heights of the ray tracer; both
// therefore use the same mesh.
struct Surface {
  int nx = 0, ny = 0;
  double dx = 1, dy = 1;
  std::vector<float> heights;  // row by row, nx per row
  double z_min = 0, z_max = 0;
  // Azimuth (radians) of each group of `columns_per_frame` columns. Empty: no column is rotated.
  std::vector<double> azimuths;
  int columns_per_frame = 1;

  double period_x() const { return nx * dx; }
  double period_y() const { return ny * dy; }
  float vertex(int i, int j) const { return heights[static_cast<std::size_t>(j) * nx + i]; }
  // Returns triangle `half` (0 or 1) of cell (i, j). Indices are taken modulo the period; x0 and y0 are not.
  Facet facet(int i, int j, int half) const;
  // Returns the triangle over the point (x, y), for any real numbers.
  Facet facet_at(double x, double y) const;
  // Returns the azimuth of the part of the surface over x. x is continued periodically.
  double azimuth_at(double x) const;
  // Returns true if the diagonal of cell (i, j), 0 <= i < nx and 0 <= j < ny, runs from (i, j) to
  // (i+1, j+1), and false if it runs from (i+1, j) to (i, j+1).
  static bool rising_diagonal(int i, int j) { return ((i + j) & 1) == 0; }
  // Sets z_min and z_max from the heights.
  void find_range();
};

// Mean squares of the slopes of the mesh, weighted by projected area. A Beckmann surface has alpha^2 / 2.
struct SlopeVariance {
  double x, y;
};
SlopeVariance slope_variance(const Surface& surface);

}  // namespace brdf::micro
