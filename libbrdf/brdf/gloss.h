// Readings of glossmeters, integrated over a material.
//
// A parallel beam from a rectangular source meets the surface, and a rectangular field stop receives the
// light about the specular direction. Both rectangles are given by their full angular widths in the plane of
// incidence and across it, in the plane of the stop. The beam is smaller than the sample: each direction of
// the source carries the same power for the same solid angle. The reading is 100 times the received power,
// divided by the power that a polished black glass of index 1.567 reflects according to Fresnel.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "brdf/material.h"

namespace brdf {

// Full widths of a rectangular aperture.
struct RectangularAperture {
  Angle in_plane, across;
};

// A glossmeter. The receptor's axis has the polar angle `incidence` + `offset` beyond the normal.
struct GlossGeometry {
  std::string_view name;
  Angle incidence;
  RectangularAperture source, receptor;
  Angle offset{};
};

// ISO 2813:2014 and ASTM D523, table of angles and relative dimensions: 20, 60 and 85 degrees.
inline constexpr std::array<GlossGeometry, 3> kGloss{
    {{"gloss_20", degrees(20), {degrees(0.75), degrees(2.5)}, {degrees(1.8), degrees(3.6)}},
     {"gloss_60", degrees(60), {degrees(0.75), degrees(2.5)}, {degrees(4.4), degrees(11.7)}},
     {"gloss_85", degrees(85), {degrees(0.75), degrees(2.5)}, {degrees(4), degrees(6)}}}};

// Distinctness of image, with the angles of ASTM E430: incidence 30 degrees, receptors at the specular
// direction and 0.3 degrees beside it. The widths of the apertures are a choice of this library: 0.14 degrees
// in the plane and 3 degrees across.
inline constexpr GlossGeometry kImageSpecular{
    "image_0", degrees(30), {degrees(0.14), degrees(3)}, {degrees(0.14), degrees(3)}};
constexpr GlossGeometry beside_image(double offset) {
  GlossGeometry geometry = kImageSpecular;
  geometry.offset = degrees(offset);
  return geometry;
}

inline constexpr double kGlossGlass = 1.567;  // index of the glass with the reading 100

struct GlossOptions {
  double tolerance = 1e-5;  // relative
  double floor = 0;         // an error of this size is accepted, too; in units of the reading
  long max_evaluations = 40'000'000;
};

struct GlossReading {
  double value = 0;        // 100 for black glass
  double error_bound = 0;  // absolute, of the integration
  long evaluations = 0;
  // False if the orders of the rule disagree, or if a lobe is too narrow for the rule to find it. The value
  // is then not a reading.
  bool converged = false;
};

// Returns the reading of a polished black glass of this index >= 1, from Fresnel's reflectance averaged over
// the source. The error bound is twice the difference of two orders of the rule, and rounding. For offset
// geometries of E430 the glass reflects into the specular receptor only; they are not permitted here.
GlossReading gloss_of_glass(const GlossGeometry& geometry, double index);

// Computes the reading of every channel, with the plane of incidence at azimuth phi.
// Example:
//     const brdf::Material material = brdf::make_material(*brdf::find_form("ward"), {"v"});
//     const brdf::GlossReading reading = gloss(material, brdf::kGloss[1], brdf::degrees(0)).front();
//     std::printf("%.2f gloss units at 60 degrees, within %.1e\n", reading.value, reading.error_bound);
std::vector<GlossReading> gloss(const Material& material, const GlossGeometry& geometry, Angle phi,
                                const GlossOptions& options = {});

}  // namespace brdf
