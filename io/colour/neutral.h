// The tone map of every picture that shows a material: for numbers and for the scalar that generates
// shaders.
#pragma once

#include <array>

#include "brdf/math.h"
#include "io/colour/srgb.h"

namespace brdf::io {

// Returns a * (1 - share) + b * share.
template <class S>
S mixed(const S& a, const S& b, const S& share) {
  return a * (S(1) - share) + b * share;
}

// Keeps the hue exactly, and the colour itself up to a peak of 0.76; above, compresses towards 1 and mixes
// with white: the Khronos PBR Neutral Tone Mapper (Khronos Group 2024, specification 1.0; there F90 =
// 0.04). A grey is subtracted first, as the share that a dielectric reflects of white surroundings. `c` is
// linear, exposed and not negative. The result is linear, in [0, 1).
template <class S>
std::array<S, 3> neutral(const std::array<S, 3>& c) {
  const S least = at_most(at_most(c[0], c[1]), c[2]);
  const S grey = select(least < S(0.08), least - S(6.25) * least * least, S(0.04));
  const S knee = S(0.76), room = S(1) - knee;
  const S peak = at_least(at_least(at_least(c[0], c[1]), c[2]) - grey, knee);
  const S compressed = S(1) - room * room / (peak + room - knee);
  const S white = S(1) - S(1) / (S(0.15) * (peak - compressed) + S(1));
  std::array<S, 3> out;
  // Below the knee the factor is 1 and the share of white is 0.
  for (std::size_t k = 0; k < 3; ++k) out[k] = mixed((c[k] - grey) * (compressed / peak), compressed, white);
  return out;
}

// Returns the display value, in [0, 1], of a linear and exposed colour: neutral(), then sRGB.
template <class S>
std::array<S, 3> neutral_display(const std::array<S, 3>& linear) {
  std::array<S, 3> out =
      neutral<S>({at_least(linear[0], S(0)), at_least(linear[1], S(0)), at_least(linear[2], S(0))});
  for (S& c : out) c = srgb_encoded(at_most(c, S(1)));
  return out;
}

}  // namespace brdf::io
