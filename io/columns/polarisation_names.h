// How names of columns say with which polarisers their values were measured.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "brdf/names.h"

namespace brdf::io {

// What is made of them: all channels stay, the surface's f_r in unpolarised light, in light that is polarised
// perpendicular (s) or parallel (p) to the plane of incidence, or of one pair of polarisers, the light's
// before the viewer's.
enum class Polarisation { keep, average, s, p, ss, sp, ps, pp };

// A channel's name without the words of its polarisation, and what they say: fr_s, 465nm (p), pp, "TE 650nm".
// Words stand between blanks, underscores, hyphens or brackets, in any case; te is s, tm is p, and `pol`,
// `polarised`, `polarized` beside one are left out. A name of nothing else is `fr`'s.
struct PolarisedName {
  std::string name;
  std::optional<Polarisation> of;  // s, p, ss, sp, ps or pp
};
PolarisedName polarised_name(std::string_view channel);
// One word: s, p, ss, ..., te, tm, s-pol, perpendicular, parallel. None where it says no polarisation.
std::optional<Polarisation> polarisation_named(std::string_view word);

// Whether a column of this name holds words for polarisations: `polarisation`, `polarization`.
bool is_polarisation_name(std::string_view name);

}  // namespace brdf::io

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 8> kNames<io::Polarisation>{"keep", "average", "s",  "p",
                                                                          "ss",   "sp",      "ps", "pp"};

}  // namespace brdf
