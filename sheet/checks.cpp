#include "sheet/checks.h"

#include <algorithm>

namespace brdf::sheet {
namespace {

constexpr std::string_view kFixed = "the format's cells fix the directions";

constexpr Check kChecks[] = {
    {"negative",
     "Whether no measured value lies below 0 by more than the noise of the dark ones.",
     negative,
     negative,
     {}},
    {"missing", "Whether every row has all its values.", missing, missing, {}},
    {"fill", "Whether a number stands for directions that were not measured.", fill, nullptr,
     "the format marks the cells without a value"},
    {"duplicates", "Whether no direction is listed twice.", duplicates, nullptr, kFixed},
    {"stuck", "Whether the detector's reading moved on from row to row.", stuck, nullptr,
     "the format's cells are not in the order of the measurement"},
    {"invented", "Whether rows were measured, and not interpolated or copied by software.", invented, nullptr,
     kFixed},
    {"angle_unit", "Whether angles are in degrees, not in radians.", angle_unit, nullptr, kFixed},
    {"polar_angle", "Whether polar angles count from the normal, not up from the surface.", polar_angle,
     nullptr, kFixed},
    {"azimuth", "Whether the highlight stands opposite the light: the azimuths' convention.", azimuth,
     nullptr, kFixed},
    {"directions", "Whether polar angle and azimuth of the viewer are not exchanged.", directions, nullptr,
     kFixed},
    {"mirror",
     "Whether highlights stand at the mirror direction: the zero of the arms, the labels of the lights.",
     mirror, nullptr, kFixed},
    {"outliers", "Whether every value fits in with its neighbours.", outliers, outliers, {}},
    {"saturation",
     "Whether the detector had room: not too many rows share the largest value.",
     saturation,
     saturation,
     {}},
    {"reciprocity", "Whether light and viewer may change places without changing the value (Helmholtz).",
     reciprocity, nullptr, "the format holds one value for both directions of a pair"},
    {"cosine_factor", "Whether values are f_r itself, not f_r times the cosine of an angle.", cosine_factor,
     nullptr, "the format holds one value for both directions of a pair"},
    {"light_gain", "Whether all lights are measured on one scale.", light_gain, nullptr,
     "the format holds one value for both directions of a pair"},
    {"drift", "Whether the scale stays from the first row of the file to the last.", drift, nullptr,
     "the format's cells are not in the order of the measurement"},
    {"dark_level", "Whether the dark level was taken off the readings.", dark_level, nullptr,
     "the format holds one value for both directions of a pair"},
    {"noise_floor", "How much the values scatter: by neighbours, and by rows that a symmetry makes equal.",
     noise_floor, nullptr, "the format's cells are means of many pixels"},
    {"quantity",
     "Whether values are as large as those of f_r can be: no counts, no percent.",
     quantity,
     quantity,
     {}},
    {"isotropy", "Whether a turn of the sample leaves the values as they are.", isotropy, nullptr,
     "the format is isotropic"},
    {"coverage", "How much of the hemisphere of directions lies between samples.", coverage, coverage, {}},
    {"energy",
     "Whether no light gives back more than it brings: the reflected fraction is at most 1 at every angle.",
     energy,
     energy,
     {}},
};

}  // namespace

std::span<const Check> checks() {
  return kChecks;
}

std::vector<std::string> data_sheet_names() {
  std::vector<std::string> names;
  for (const Check& check : kChecks) names.emplace_back(check.name);
  return names;
}

std::string_view check_meaning(std::string_view name) {
  const auto* const found = std::ranges::find(kChecks, name, &Check::name);
  return found == std::end(kChecks) ? "" : found->meaning;
}

}  // namespace brdf::sheet
