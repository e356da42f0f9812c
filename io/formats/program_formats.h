// Names the text formats of optical and lighting programs that have no reader.
#pragma once

#include <string>
#include <string_view>

namespace brdf::io {

// The end of a sentence about the format of a luminaire.
inline constexpr std::string_view kLuminaire =
    ", which describes the light of a luminaire, not a surface: `brdf` reads samples of surfaces";

// Returns the name of the format that a text is in, with advice, as the end of a sentence about the file; an
// empty string for other texts. `text` begins with its first character that is not a blank.
std::string program_format(std::string_view text);

// Returns advice on a text that cannot be read as a table of columns: coefficients of the models of ABg and
// of Harvey and Shack, weights of MODIS' kernels, YAML, TOML, reports after ASTM E2387; as the end of a
// sentence about the file. Returns an empty string for other texts. Some of these texts are readable tables,
// with a layout or without one, so that the advice is for a table that has been refused.
std::string advice_on_text(std::string_view text);

}  // namespace brdf::io
