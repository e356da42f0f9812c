// The loss of one texel.
#pragma once

#include "brdf/material.h"
#include "brdf/vec3.h"

namespace brdf::maps {

// Compares materials with the material of a texel over the pairs of directions that no fit has used.
class TexelComparison {
 public:
  explicit TexelComparison(const Material& wanted);

  struct Figures {
    double rms, largest;
  };
  // Returns the figures of a material on a surface with the unit normal `normal` in the frame of the texel's
  // own normal.
  Figures figures_of(const Material& carried, const Vec3<double>& normal) const;

 private:
  DirectionArrays<double> pairs_;
  std::vector<std::vector<double>> values_;
};

}  // namespace brdf::maps
