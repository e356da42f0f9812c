// Computes the colour of a reflectance spectrum.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace brdf::io {

// CIE X, Y, Z, or linear red, green, blue.
using Tristimulus = std::array<double, 3>;

// Correlated colour temperatures of the CIE illuminants D65 and D50, in kelvin. They are the nominal
// temperatures on the temperature scale of 1931, converted to today's scale.
inline constexpr double kD65 = 6500 * 1.4388 / 1.438, kD50 = 5000 * 1.4388 / 1.438;

// Returns the weights by which the values of a spectrum add up to its tristimulus values under daylight.
// `wavelengths` are in nm, ascending, at least one; `kelvin` is the temperature of daylight, 4000 to 25000.
// Y of a perfect white is 1. The spectrum is assumed to be linear between the wavelengths and constant
// beyond them. Method: CIE 15:2004, the observer of 1931, sums every 5 nm from 380 to 780 nm, daylight by
// its eq. 3.3 to 3.5. Accuracy: for the 24 spectra of a ColorChecker, given every 10 nm and to three
// decimals, x and y are within 9.2e-4 and Y is within 6.5e-4 of the published values.
std::vector<Tristimulus> xyz_weights(std::span<const double> wavelengths, double kelvin);

// Returns the weights for linear sRGB (IEC 61966-2-1) under D65. A perfect white is (1, 1, 1) to rounding.
// A saturated spectrum may have a negative component.
std::vector<Tristimulus> srgb_weights(std::span<const double> wavelengths);

}  // namespace brdf::io
