// The angular width of the detector that a file states.
#pragma once

#include <optional>

#include "io/samples/samples.h"

namespace brdf::io {

// The key of the metadata that hold the full angular width of the detector, in degrees.
inline constexpr std::string_view kApertureKey = "detector_aperture";

// Returns the full angular width, in degrees, of a round detector with this solid angle in sr, which must be
// above 0 and at most 2 pi: 2 acos(1 - solid_angle / (2 pi)).
double aperture_of_solid_angle(double solid_angle);

// Adds the width of a detector with this solid angle to the metadata and to the warnings. A solid angle
// outside (0, 2 pi] becomes a warning only.
void state_solid_angle(SampleTable& table, double solid_angle);

// Returns the full angular width of the detector, in degrees, that the metadata state: `detector_aperture:
// 4`, `aperture: 4 degrees`, or `solid_angle: 0.0038 sr`, in any case and also as keywords of ASTM E1392.
// Returns std::nullopt if the metadata state no width above 0 and up to 90.
std::optional<double> stated_aperture(const SampleTable& table);

}  // namespace brdf::io
