// What a reflectance spectrum looks like.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace brdf::io {

// CIE X, Y, Z, or linear red, green, blue.
using Tristimulus = std::array<double, 3>;

// Correlated colour temperatures of the CIE's illuminants D65 and D50, in kelvin: their nominal ones on the
// temperature scale of 1931.
inline constexpr double kD65 = 6500 * 1.4388 / 1.438, kD50 = 5000 * 1.4388 / 1.438;

// The weights by which the values of a spectrum at these wavelengths (nm, ascending, at least one) add up to
// its tristimulus values under daylight of this temperature (4000 to 25000 kelvin), Y of a perfect white
// being 1. Between the wavelengths the spectrum is taken to be linear, beyond them constant. CIE 15:2004: the
// observer of 1931, sums every 5 nm from 380 to 780 nm, daylight by its eq. 3.3 to 3.5. Of the 24 spectra of
// a ColorChecker, every 10 nm and to three decimals, x and y are within 9.2e-4 and Y within 6.5e-4 of the
// published ones.
std::vector<Tristimulus> xyz_weights(std::span<const double> wavelengths, double kelvin);

// The same as linear sRGB (IEC 61966-2-1) under D65; a perfect white is (1, 1, 1) to rounding. A saturated
// spectrum may have a negative component.
std::vector<Tristimulus> srgb_weights(std::span<const double> wavelengths);

}  // namespace brdf::io
