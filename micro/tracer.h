// Ray tracing on a periodic surface (Embree).
#pragma once

#include <cstdint>
#include <memory>

#include "brdf/vec3.h"
#include "micro/surface.h"

namespace brdf::micro {

using Vec = Vec3<double>;

// Result of tracing a ray. `lost`: the ray slipped through the mesh, met a facet from below, or exceeded
// the step limit. These cases do not exist in exact arithmetic and are therefore counted.
enum class Fate { hit, escaped, lost };

// Intersects rays with one surface that is continued periodically without end: a ray that leaves the period
// reenters on the opposite side. Use one tracer per thread.
class Tracer {
 public:
  // Builds the acceleration structure on the calling thread alone. The result is therefore the same for any
  // number of threads. Throws EnvironmentError if Embree supports no processor of this machine or memory is
  // insufficient.
  explicit Tracer(const Surface& surface);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  // Returns a point of the plane through the highest vertex, at the share (u, v) in [0, 1)^2 of the period.
  Vec entry(double u, double v) const;
  // Follows the ray from `origin` along the unit vector `direction`. On a hit, `origin` becomes the
  // intersection (raised by a few roundings, which permits a new ray to start there) and `facet` the
  // triangle.
  Fate next(Vec& origin, const Vec& direction, Facet& facet);
  // Returns true if the ray leaves the surface without a hit.
  bool escapes(const Vec& origin, const Vec& direction);
  // Returns the point of the surface over (x, y), raised in the same way.
  Vec on_surface(double x, double y) const;
  const Surface& surface() const { return surface_; }
  // Returns the number of rays followed (a ray that is continued in the next period counts once).
  std::uint64_t rays() const { return rays_; }

 private:
  struct Embree;
  struct Segment {
    double end;
    enum class Limit { x, y, z } limit;
  };
  Segment segment(const Vec& origin, const Vec& direction) const;
  void continue_past(Vec& origin, const Vec& direction, const Segment& s) const;
  Facet facet_of(std::uint32_t primitive) const;
  double clearance(const Facet& facet) const;
  void raise(Vec& point, const Facet& facet) const;

  const Surface& surface_;
  std::unique_ptr<Embree> embree_;
  double lift_;
  std::uint64_t rays_ = 0;
};

}  // namespace brdf::micro
