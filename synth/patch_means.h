// Means of a material over the patches of a Klems basis.
#pragma once

#include "brdf/material.h"
#include "io/files/parallel.h"
#include "io/samples/samples.h"

namespace brdf::synth {

// The table of means, and the quality of the integration.
struct PatchMeans {
  io::SampleTable table;
  // The largest estimated error of a resolved value, relative to this value or to 1e-6 1/sr, whichever is
  // larger.
  double error = 0;
  // The number of values whose error is above kPatchTolerance, or is not known because the highlight is too
  // narrow for the number of cells.
  std::size_t unresolved = 0;
};

// The relative error of a value at which the integration ends.
inline constexpr double kPatchTolerance = 1e-3;

// Returns the means of f_r over all pairs of patches of LBNL/Klems Full (145 x 145). A mean is taken over
// both patches with projected solid angles as weights, so that a mean times the projected solid angle of the
// outgoing patch is the share of the light of the incident patch. The directions of the table are the centres
// of the patches, and light is incident from phi + 180 degrees of its patch (io/formats/klems_bases.h).
//
// Method: Gauss rules of three points in sin^2 of both polar angles and in azimuth, on cells that are halved
// until the changes by halving cells in every dimension meet kPatchTolerance. Cells near the mirror direction
// and near retroreflection are first halved to the widths of the lobe there, which are found by a search, so
// that no narrow lobe is missed. If f_r depends only on the difference of azimuths, three dimensions are
// integrated instead of four. Pairs of patches that exchange of light and viewer, or mirroring at the planes
// of x and y, turn into each other are integrated once, if f_r does not change by more than 1e-6 under this
// symmetry at 96 pairs of directions.
// Example:
//     const brdf::Material material = brdf::make_material(*brdf::find_form("ward"), {"fr"});
//     const brdf::synth::PatchMeans means = brdf::synth::patch_means(material);
//     std::printf("%zu values, error %.1e\n", means.table.rows(), means.error);
PatchMeans patch_means(const Material& material, const io::Progress& progress = {});

}  // namespace brdf::synth
