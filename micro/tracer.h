// Rays on a periodic surface (Embree).
#pragma once

#include <cstdint>
#include <memory>

#include "brdf/vec3.h"
#include "micro/surface.h"

namespace brdf::micro {

using Vec = Vec3<double>;

// What a ray meets. `lost`: it slipped through the mesh, met a facet from below, or ran past the step limit;
// none of these exist in exact arithmetic, so they are counted.
enum class Fate { hit, escaped, lost };

// Intersects rays with one surface, continued periodically without end: a ray that leaves the period
// reenters on the opposite side. One tracer serves one thread.
class Tracer {
 public:
  // Builds the acceleration structure on the calling thread alone, so that it is the same for any number of
  // threads.
  explicit Tracer(const Surface& surface);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  // A point of the plane that touches the highest vertex, over the share (u, v) in [0, 1)^2 of the period.
  Vec entry(double u, double v) const;
  // Follows the ray from `origin` along the unit vector `direction`. On a hit, `origin` becomes the point
  // (raised by some roundings, so that a ray may start there) and `facet` the triangle.
  Fate next(Vec& origin, const Vec& direction, Facet& facet);
  // Does the ray leave the surface without a hit?
  bool escapes(const Vec& origin, const Vec& direction);
  // The surface's point over (x, y), raised in the same way.
  Vec on_surface(double x, double y) const;
  const Surface& surface() const { return surface_; }
  // Rays followed so far (a ray that is continued in the next period counts once).
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
