// Recognises polarisations in the names of columns.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "brdf/names.h"

namespace brdf::io {

// The use of polarised channels. `keep`: all channels stay. `average`: f_r of the surface in unpolarised
// light. `s`, `p`: f_r in light that is polarised perpendicular (s) or parallel (p) to the plane of
// incidence. `ss` to `pp`: one pair of polarisers, the light's before the viewer's.
enum class Polarisation { keep, average, s, p, ss, sp, ps, pp };

// A channel's name without the words of its polarisation, and the polarisation: fr_s, 465nm (p), pp, "TE
// 650nm". Words are separated by blanks, underscores, hyphens or brackets and may have any case. te is s,
// tm is p. The words `pol`, `polarised`, `polarized`, `polarisation`, `polarization` next to a polarisation
// are removed. A name that consists of nothing else becomes `fr`. A name with two polarisations stays
// unchanged.
struct PolarisedName {
  std::string name;
  std::optional<Polarisation> of;  // s, p, ss, sp, ps or pp
};
// Separates the polarisation from a channel's name.
PolarisedName polarised_name(std::string_view channel);
// Returns the polarisation of a word: s, p, ss, ..., te, tm, s-pol, perpendicular, parallel. Returns
// std::nullopt for any other word.
std::optional<Polarisation> polarisation_named(std::string_view word);

// Returns whether a column of this name holds words for polarisations: `polarisation`, `polarization`.
bool is_polarisation_name(std::string_view name);

}  // namespace brdf::io

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 8> kNames<io::Polarisation>{"keep", "average", "s",  "p",
                                                                          "ss",   "sp",      "ps", "pp"};

}  // namespace brdf
