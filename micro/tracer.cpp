#include "micro/tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "io/files/error.h"

namespace brdf::micro {
namespace {

// A ray at 0.01 degrees over the roughest surface crosses a few hundred periods.
constexpr int kMaxPeriods = 100000;
// The mesh extends one cell beyond the period. Rays are wrapped at this share of a cell beyond the period.
constexpr double kMarginCells = 0.5;
// Consecutive segments overlap by this share of a cell to avoid missed hits between them.
constexpr double kOverlap = 1e-3;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Fills the vertices and triangles of the period and of one more cell on every side. The mesh is centred
// because floats are most accurate near zero. Returns false if memory is insufficient.
bool fill_mesh(const Surface& s, RTCGeometry geometry) {
  const int columns = s.nx + 3, rows = s.ny + 3;
  auto* vertices =
      static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                  3 * sizeof(float), std::size_t(columns) * rows));
  if (!vertices) return false;
  for (int j = -1; j < rows - 1; ++j) {
    for (int i = -1; i < columns - 1; ++i) {
      *vertices++ = static_cast<float>(i * s.dx - s.period_x() / 2);
      *vertices++ = static_cast<float>(j * s.dy - s.period_y() / 2);
      *vertices++ = s.vertex((i + s.nx) % s.nx, (j + s.ny) % s.ny);
    }
  }
  auto* triangle = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                                                  RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
                                                                  2 * std::size_t(columns - 1) * (rows - 1)));
  if (!triangle) return false;
  for (int j = -1; j < rows - 2; ++j) {
    for (int i = -1; i < columns - 2; ++i) {
      const unsigned v00 = (j + 1) * columns + i + 1, v10 = v00 + 1, v01 = v00 + columns, v11 = v01 + 1;
      const bool rising = Surface::rising_diagonal((i + s.nx) % s.nx, (j + s.ny) % s.ny);
      for (const unsigned v : {v00, v10, rising ? v11 : v01}) *triangle++ = v;
      for (const unsigned v : {rising ? v00 : v10, v11, v01}) *triangle++ = v;
    }
  }
  return true;
}

RTCRay make_ray(const Surface& s, const Vec& origin, const Vec& direction, double end) {
  RTCRay ray;
  ray.org_x = static_cast<float>(origin.x - s.period_x() / 2);
  ray.org_y = static_cast<float>(origin.y - s.period_y() / 2);
  ray.org_z = static_cast<float>(origin.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tnear = 0;
  ray.tfar = static_cast<float>(end);
  ray.time = 0;
  ray.mask = ~0u;
  ray.id = ray.flags = 0;
  return ray;
}

}  // namespace

struct Tracer::Embree {
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  std::unique_ptr<RTCDeviceTy, Release> device;
  std::unique_ptr<RTCSceneTy, Release> scene;

  explicit Embree(const Surface& surface) : device(rtcNewDevice("threads=1")) {
    if (!device) throw EnvironmentError("Embree does not support this processor");
    scene.reset(rtcNewScene(device.get()));
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);  // watertight along shared edges
    const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    const bool filled = fill_mesh(surface, geometry);
    if (filled) rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    if (filled) rtcCommitScene(scene.get());
    if (!filled || rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
      throw EnvironmentError("Embree could not build the surface of " +
                             std::to_string(2LL * surface.nx * surface.ny) +
                             " triangles (not enough memory?)");
  }
};

Tracer::Tracer(const Surface& surface) : surface_(surface), embree_(std::make_unique<Embree>(surface)) {
  const double extent =
      std::max({surface.period_x() / 2, surface.period_y() / 2, surface.z_max, -surface.z_min});
  lift_ = 4 * std::numeric_limits<float>::epsilon() * extent;
}

Tracer::~Tracer() = default;

Vec Tracer::entry(double u, double v) const {
  return {u * surface_.period_x(), v * surface_.period_y(), surface_.z_max};
}

Vec Tracer::on_surface(double x, double y) const {
  const Facet facet = surface_.facet_at(x, y);
  return {x, y, facet.height(x, y) + clearance(facet)};
}

Tracer::Segment Tracer::segment(const Vec& o, const Vec& d) const {
  const double mx = kMarginCells * surface_.dx, my = kMarginCells * surface_.dy;
  const auto to_plane = [](double from, double direction, double low, double high) {
    if (direction == 0) return kInfinity;
    return std::max(((direction > 0 ? high : low) - from) / direction, 0.0);
  };
  const double tx = to_plane(o.x, d.x, -mx, surface_.period_x() + mx);
  const double ty = to_plane(o.y, d.y, -my, surface_.period_y() + my);
  const double tz = to_plane(o.z, d.z, surface_.z_min - 100 * lift_, surface_.z_max + lift_);
  if (tz <= tx && tz <= ty) return {tz, Segment::Limit::z};
  return tx < ty ? Segment{tx, Segment::Limit::x} : Segment{ty, Segment::Limit::y};
}

void Tracer::continue_past(Vec& o, const Vec& d, const Segment& s) const {
  o = o + d * std::max(s.end - kOverlap * std::min(surface_.dx, surface_.dy), 0.0);
  if (s.limit == Segment::Limit::x) o.x += d.x > 0 ? -surface_.period_x() : surface_.period_x();
  if (s.limit == Segment::Limit::y) o.y += d.y > 0 ? -surface_.period_y() : surface_.period_y();
}

Facet Tracer::facet_of(std::uint32_t primitive) const {
  const int columns = surface_.nx + 2;
  const int cell = static_cast<int>(primitive / 2);
  return surface_.facet(cell % columns - 1, cell / columns - 1, static_cast<int>(primitive % 2));
}

double Tracer::clearance(const Facet& facet) const {
  return lift_ * (1 + std::abs(facet.slope_x) + std::abs(facet.slope_y));
}

void Tracer::raise(Vec& point, const Facet& facet) const {
  // Rounding may place the point below the neighbouring facet of a concave edge. The height of the surface
  // itself decides.
  const Facet here = surface_.facet_at(point.x, point.y);
  point.z = std::max(facet.height(point.x, point.y) + clearance(facet),
                     here.height(point.x, point.y) + clearance(here));
}

Fate Tracer::next(Vec& origin, const Vec& direction, Facet& facet) {
  ++rays_;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (int period = 0; period < kMaxPeriods; ++period) {
    const Segment s = segment(origin, direction);
    if (s.end == kInfinity) return Fate::lost;
    RTCRayHit query;
    query.ray = make_ray(surface_, origin, direction, s.end);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(embree_->scene.get(), &context, &query);
    if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
      facet = facet_of(query.hit.primID);
      origin = origin + direction * query.ray.tfar;
      raise(origin, facet);
      // Speed at which the ray rises above the plane of the facet. A rising ray was below the plane.
      const double rise = direction.z - facet.slope_x * direction.x - facet.slope_y * direction.y;
      if (rise < 0) return Fate::hit;
      if (rise * query.ray.tfar > 4 * clearance(facet)) return Fate::lost;
      continue;  // below by rounding only (the ray started almost along the facet): continue from above
    }
    if (s.limit == Segment::Limit::z) return direction.z > 0 ? Fate::escaped : Fate::lost;
    continue_past(origin, direction, s);
  }
  return Fate::lost;
}

bool Tracer::escapes(const Vec& start, const Vec& direction) {
  ++rays_;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  Vec origin = start;
  for (int period = 0; period < kMaxPeriods; ++period) {
    const Segment s = segment(origin, direction);
    if (s.end == kInfinity) return false;
    RTCRay ray = make_ray(surface_, origin, direction, s.end);
    rtcOccluded1(embree_->scene.get(), &context, &ray);
    if (ray.tfar < 0) return false;
    if (s.limit == Segment::Limit::z) return direction.z > 0;
    continue_past(origin, direction, s);
  }
  return false;
}

}  // namespace brdf::micro
