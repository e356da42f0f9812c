// Symmetries of a material by which pairs of patches have the same mean.
#pragma once

#include <array>

#include "brdf/material.h"
#include "io/formats/klems_bases.h"

namespace brdf::synth {

// Changes of both directions that leave f_r unchanged.
struct PatchSymmetry {
  bool turn = false;      // about the normal, by any angle
  bool mirror_x = false;  // phi to -phi
  bool mirror_y = false;  // phi to 180 - phi
  bool exchange = false;  // of light and viewer

  // Pairs of patches of the same class have the same mean. A class is the first, in order, of the rings and
  // azimuths of all pairs into which the symmetries turn a pair.
  using Class = std::array<long, 4>;
  Class class_of(const io::klems::Patch& light, const io::klems::Patch& viewer) const;
};

// Returns the changes under which f_r differs by at most 1e-6 of itself at 96 pairs of directions, around the
// mirror direction and far from it.
PatchSymmetry symmetry_of(const Material& material);

}  // namespace brdf::synth
