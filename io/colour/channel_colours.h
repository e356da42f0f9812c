// Which channels are red, green and blue, decided by their names and nowhere else.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "io/columns/wavelengths.h"

namespace brdf::io {

struct ChannelColours {
  enum class By { grey, name, wavelength, spectrum, position };
  // The channels that are red, green and blue; all the same for one channel. Of a spectrum those next to
  // them: a picture of it adds up all bands (in_colour.h).
  std::array<std::size_t, 3> of;
  By by;
  // How that was decided where no name is a colour's, one clause for people; empty otherwise.
  std::string note;
};

// One channel is grey. Of several, those named r, g, b or red, green, blue in any order and case; else those
// named by a wavelength: three by its order, of more (a spectrum where they are is_spectrum) those nearest to
// the dominant wavelengths of sRGB's primaries under D65 (611, 549 and 464 nm; IEC 61966-2-1); else three by
// their position. None where no three channels can be told.
std::optional<ChannelColours> channel_colours(const std::vector<std::string>& channels);

// Throws InputError for a form that mixes channels, which takes the first channel's weights for red's, unless
// the first channel is red.
void require_red_first(const Term& term, const ChannelColours& colours);

}  // namespace brdf::io
