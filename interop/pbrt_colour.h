// A conductor with coloured indices as pbrt renders it: the colours become spectra, Fresnel's equations are
// evaluated at each wavelength, and the result becomes a colour.
#pragma once

#include <array>

#include "brdf/material.h"

namespace brdf::interop {

// A spectrum with a given colour: scale times 1/2 + q/(2 sqrt(1 + q^2)), with q a parabola over wavelength.
// Source: pbrt-v4 5f7a6068, src/pbrt/util/spectrum.h (RGBUnboundedSpectrum), color.h (RGBSigmoidPolynomial).
// The scale is twice the largest of the three components, which admits colours of any size. The coefficients
// of the parabola reproduce the given colour under D65 (Jakob and Hanika 2019); pbrt reads them from a table
// of 64^3 entries.
class ColourSpectrum {
 public:
  explicit ColourSpectrum(const std::array<double, 3>& rgb);
  double at(double wavelength) const;  // wavelength in nm
  // Returns the colour error that the coefficients leave, relative to the colour's largest component.
  double residual() const { return residual_; }

 private:
  std::array<double, 3> coefficients_{};
  double scale_ = 0, residual_ = 0;
};

// Returns a material of pbrt_conductor terms as pbrt renders it under D65. Grey indices are unchanged.
Material shown_by_pbrt(const Material& of_conductors);

}  // namespace brdf::interop
