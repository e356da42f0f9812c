// Pairs of directions that see a material's lobes: around each at its own widths, and evenly over the
// hemisphere.
#pragma once

#include <span>

#include "interop/wanted.h"
#include "io/samples/samples.h"

namespace brdf::interop {

// Two sets that share no direction: what is fitted to and what the loss is measured on.
enum class Pairs { fitted, judged };

inline constexpr double kMostTheta = 80;  // degrees from the normal: no pair goes beyond

// A lobe's widths along and across its axis, and that axis's azimuth.
struct LobePlace {
  Widths widths{};
  double tangent = 0;  // degrees
};

// Whether values may change as the sample is turned: of two widths, and of code that is not in the catalogue.
bool may_turn(const Material& material);

// Of a material's terms; one of the usual widths where no term has a lobe.
std::vector<LobePlace> lobe_places(const Material& material);

// Rows of directions, without values.
io::SampleTable pairs_about(const Material& material, Pairs which);

// Rows from which a search for the largest difference from a material begins: theta in steps of 4 degrees to
// 80, azimuths close together at the mirror direction, its lobes at their own widths.
io::SampleTable net_about(const Material& material);

// The light of theta_i, phi_i mirrored at a half vector: its slopes along and across the lobe's axis, in
// widths. False where that lies beyond kMostTheta.
bool add_mirrored(io::SampleTable& table, const LobePlace& lobe, double theta_i, double phi_i, double along,
                  double across);

}  // namespace brdf::interop
