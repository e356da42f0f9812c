// A sample table in place of a material.
#pragma once

#include "brdf/material.h"
#include "io/samples.h"
#include "render/reference/reference.h"

namespace brdf::render {

// f_r cos_i of the table, interpolated (measured/measured.h) beside a fitted material or beside each channel's mean,
// whichever makes the samples likelier; known where the samples are near enough. Which channels are red, green and blue
// their names say (io/channel_colours.h). Throws InputError where the channels are no colours.
Measured interpolate(const io::SampleTable& table, const Material* fitted = nullptr);

// What a page shows of a fit: the default sphere (material_scene, without ambient light) of `size` pixels a side, fitted,
// measured (hatched where it is not) and their signed difference, without words. By the reference: no graphics device is
// needed. Throws InputError where the channels are no colours.
struct MeasuredSpheres {
  BytePicture fitted, measured, difference;
  Difference numbers;
};
MeasuredSpheres measured_spheres(const Material& fitted, const io::SampleTable& table, int size);

}  // namespace brdf::render
