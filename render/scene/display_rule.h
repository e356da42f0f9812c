// Colours with one definition for C++ and (traced) for the shaders: the sky, tone maps, false colours, the
// light of a floor.
#pragma once

#include <array>
#include <cmath>

#include "brdf/math.h"
#include "io/colour/neutral.h"
#include "io/colour/srgb.h"
#include "io/page/colour_scales.h"
#include "render/scene/scene.h"

namespace brdf::render {

// Functions that a scalar must provide in addition to its arithmetic; shaders/emit_shaders.cpp has the GLSL
// versions.
using io::to_power;
inline float log_10(float x) {
  return std::log10(x);
}

using io::mixed;

// Returns one channel of the sky; `up` is the y of the unit vector towards it.
template <class S>
S sky_color(const S& horizon, const S& zenith, const S& up) {
  return mixed(horizon, zenith, math::sqrt(at_least(up, S(0))));
}

// Returns one channel of a backdrop; `height` is the ray's ndc y, -1 at the lower edge of the picture and 1
// at the upper.
template <class S>
S backdrop_color(const S& bottom, const S& top, const S& height) {
  return mixed(bottom, top, at_most(at_least((height + S(1)) * S(0.5), S(0)), S(1)));
}

using io::srgb_encoded;

template <class S>
using Colour = std::array<S, 3>;

// Returns one channel, linear and exposed, mapped by a curve that is independent of the other channels.
template <class S>
S channel_curve(ToneMap tone_map, const S& linear) {
  const S c = at_least(linear, S(0));
  switch (tone_map) {
    case ToneMap::srgb:
      return srgb_encoded(at_most(c, S(1)));
    case ToneMap::reinhard:
      return srgb_encoded(c / (c + S(1)));
    case ToneMap::thesis:
      return to_power(c / (c + S(1)), S(1) / S(2.2));
    case ToneMap::none:
    case ToneMap::neutral:
      break;
  }
  return at_most(c, S(1));
}

// Returns the display value of a linear and exposed colour.
template <class S>
Colour<S> tone_curve(ToneMap tone_map, const Colour<S>& linear) {
  if (tone_map == ToneMap::neutral) return io::neutral_display(linear);
  Colour<S> out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = channel_curve(tone_map, linear[k]);
  return out;
}

// Returns the colour of a relative difference: blue 1e-6 through green and yellow to red 1; black if equal.
template <class S>
Colour<S> false_color_of(const S& relative) {
  constexpr std::array kStops{std::array{0.1, 0.2, 0.8}, std::array{0.1, 0.7, 0.3},
                              std::array{0.95, 0.85, 0.1}, std::array{0.85, 0.1, 0.1}};
  const S t = at_most(at_least((log_10(relative) + S(6)) / S(6), S(0)), S(1)) * S(3);
  Colour<S> color;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto between = [&](std::size_t k) {
      return mixed(S(kStops[k][c]), S(kStops[k + 1][c]), t - S(double(k)));
    };
    const S upper = select(t < S(2), between(1), between(2));
    color[c] = select(S(0) < relative, select(t < S(1), between(0), upper), S(0));
  }
  return color;
}

// Returns the colour of a signed relative difference: blue at -50 % and below, white at 0, red at 50 % and
// above.
template <class S>
Colour<S> signed_color_of(const S& relative) {
  constexpr const io::ColourScale& kScale = io::kDivergingScale;
  const S t = (at_most(at_least(relative * S(2), S(-1)), S(1)) + S(1)) * S(2);
  Colour<S> color;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto between = [&](std::size_t k) {
      return mixed(S(kScale[k][c] / 255), S(kScale[k + 1][c] / 255), t - S(double(k)));
    };
    color[c] =
        select(t < S(2), select(t < S(1), between(0), between(1)), select(t < S(3), between(2), between(3)));
  }
  return color;
}

}  // namespace brdf::render
