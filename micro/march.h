// Ray tracing on a periodic height field, in double. The same source is compiled for Vulkan devices.
#pragma once

#include <algorithm>
#include <cmath>

#include "brdf/fresnel.h"
#include "brdf/vec3.h"

namespace brdf::micro {

using Vec = Vec3<double>;

// A plane triangle of the mesh: z = z0 + slope_x (x - x0) + slope_y (y - y0), in the unit of length of the
// surface.
struct Facet {
  double x0, y0, z0;
  double slope_x, slope_y;

  double height(double x, double y) const { return z0 + slope_x * (x - x0) + slope_y * (y - y0); }
};

// A turn about the macroscopic normal.
struct Turn {
  double cosine, sine;
};

// The functions of march.glsl for one surface. Distances have the surface's unit of length. All functions
// are exact up to rounding; the same bits result on every processor.
struct March {
  const float* heights;
  const float* tops;
  const Turn* turns;
  int nx, ny, columns_per_frame;
  double dx, dy, z_max;

  using dvec3 = Vec;
  static double max(double a, double b) { return a < b ? b : a; }
  static float max(float a, float b) { return a < b ? b : a; }
  static int max(int a, int b) { return a < b ? b : a; }
  static int min(int a, int b) { return b < a ? b : a; }
  static double sqrt(double x) { return std::sqrt(x); }
#define precise  // GLSL's word for results that no compiler may contract
#define CONSTANT static constexpr int
#include "render/shaders/march.glsl"
#undef CONSTANT
#undef precise
};
using Path = March::Path;
using Place = March::Place;

}  // namespace brdf::micro
