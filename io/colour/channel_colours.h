// Determines which channels are red, green and blue, from the names of the channels only.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/columns/wavelengths.h"

namespace brdf::io {

struct ChannelColours {
  enum class By { grey, name, wavelength, spectrum, position };
  // Indices of the channels that are red, green and blue; all three are equal for one channel. For a
  // spectrum they are the bands nearest to these colours, although a picture of the spectrum sums all bands
  // (in_colour.h).
  std::array<std::size_t, 3> of;
  By by;
  // One clause for the user on how the colours were determined. Empty for one channel, and for three
  // channels that are named by their colours.
  std::string note;
};

// Determines the colours of channels by these rules, in this order. One channel is grey. Channels named r,
// g, b or red, green, blue, in any order and case, are these colours. Among channels that are named by a
// wavelength, three are ordered by wavelength; of more (a spectrum if is_spectrum), the channels nearest to
// the dominant wavelengths of sRGB's primaries under D65 are taken (611, 549 and 464 nm; IEC 61966-2-1).
// Any other three channels are taken by position. Returns std::nullopt if no rule applies.
std::optional<ChannelColours> channel_colours(const std::vector<std::string>& channels);

// Throws InputError if a form mixes channels and the first channel is not red. Such a form takes the
// weights of the first channel for red.
void require_red_first(const Term& term, const ChannelColours& colours);

}  // namespace brdf::io
