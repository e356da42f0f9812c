// Paths over mirrors, one for each invocation.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;

struct Facet {
  double x0;
  double y0;
  double z0;
  double slope_x;
  double slope_y;
};
struct Turn {
  double cosine;
  double sine;
};
struct End {
  double x;
  double y;
  double z;
  double weight;
  double absorbed;
  int order;
  int fate;
};

layout(std430, binding = 0) readonly buffer Heights { float heights[]; };
layout(std430, binding = 1) readonly buffer Tops { float tops[]; };
layout(std430, binding = 2) readonly buffer Turns { Turn turns[]; };
layout(std430, binding = 3) readonly buffer Starts { dvec2 starts[]; };
layout(std430, binding = 4) writeonly buffer Ends { End ends[]; };
layout(push_constant) uniform Push {
  double dx;
  double dy;
  double z_max;
  double eta;
  double x;
  double y;
  double z;
  int nx;
  int ny;
  int columns_per_frame;
  int limit;
  uint count;
};

#define CONSTANT const int
#include "fresnel.glsl"
#include "march.glsl"

void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k >= count) return;
  Path path = path_over_mirrors(dvec3(x, y, z), starts[k].x, starts[k].y, eta, limit);
  ends[k] = End(path.travel.x, path.travel.y, path.travel.z, path.weight, path.absorbed, path.order, path.fate);
}
