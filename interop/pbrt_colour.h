// A conductor of coloured indices as pbrt shows it: the colours become spectra, Fresnel's equations are taken
// at each wavelength, and their result becomes a colour.
#pragma once

#include <array>

#include "brdf/material.h"

namespace brdf::interop {

// A spectrum that has this colour: scale times 1/2 + q/(2 sqrt(1 + q^2)), q a parabola over wavelength.
// Source: pbrt-v4 5f7a6068, src/pbrt/util/spectrum.h (RGBUnboundedSpectrum), color.h (RGBSigmoidPolynomial):
// scale is twice the largest of the three, so that colours of any size fit. The parabola's coefficients are
// the ones whose colour is the given one under D65 (Jakob and Hanika 2019), which pbrt has in a table of 64^3
// entries.
class ColourSpectrum {
 public:
  explicit ColourSpectrum(const std::array<double, 3>& rgb);
  double at(double wavelength) const;  // nm
  // What the coefficients leave open of the colour, relative to its largest component.
  double residual() const { return residual_; }

 private:
  std::array<double, 3> coefficients_{};
  double scale_ = 0, residual_ = 0;
};

// The material of pbrt_conductor terms as pbrt shows it under D65. Grey indices are as they are.
Material shown_by_pbrt(const Material& of_conductors);

}  // namespace brdf::interop
