// Pairs of directions that sample a material's lobes: around each lobe at its own widths, and evenly over
// the hemisphere.
#pragma once

#include "interop/wanted.h"
#include "io/samples/samples.h"

namespace brdf::interop {

// Two sets of pairs without common directions: one for the fit, the other to measure the loss.
enum class Pairs { fitted, judged };

inline constexpr double kMostTheta = 80;  // degrees from the normal; limit of all pairs

// A lobe's widths along and across its axis, and the azimuth of this axis.
struct LobePlace {
  Widths widths{};
  double tangent = 0;  // degrees
};

// Returns true if values may change as the sample is turned: for anisotropic materials, and for code outside
// the catalogue.
bool may_turn(const Material& material);

// Returns the lobes of a material's terms. If no term has a lobe, returns one lobe with the default widths.
std::vector<LobePlace> lobe_places(const Material& material);

// Returns rows of directions without values.
io::SampleTable pairs_about(const Material& material, Pairs which);
// Returns the same rows with the values of the material.
io::SampleTable values_about(const Material& material, Pairs which);

// Returns starting rows for a search of the largest difference from a material: theta in steps of 4 degrees
// up to 80 degrees, azimuths dense near the mirror direction, and the lobes sampled at their own widths.
io::SampleTable net_about(const Material& material);

// Adds the row of incidence theta_i, phi_i (degrees) mirrored at a half vector. The half vector is given by
// its slopes along and across the lobe's axis, in widths. Returns false, without a new row, if theta_o
// exceeds kMostTheta.
bool add_mirrored(io::SampleTable& table, const LobePlace& lobe, double theta_i, double phi_i, double along,
                  double across);

}  // namespace brdf::interop
