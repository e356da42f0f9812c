#include "sheet/checks.h"

#include <algorithm>

namespace brdf::sheet {
namespace {

constexpr std::string_view kFixed = "the format's cells fix the directions";

constexpr Check kChecks[] = {
    {"negative",
     "Whether no measured value is below 0 by more than the noise of dark measurements.",
     negative,
     negative,
     {}},
    {"missing", "Whether every row has all its values.", missing, missing, {}},
    {"fill", "Whether a fill value marks directions that were not measured.", fill, nullptr,
     "the format marks the cells without a value"},
    {"duplicates", "Whether no pair of directions is listed twice.", duplicates, nullptr, kFixed},
    {"stuck", "Whether the detector's reading changes from row to row.", stuck, nullptr,
     "the format's cells are not in the order of the measurement"},
    {"invented", "Whether all rows were measured, instead of interpolated or copied by software.", invented,
     nullptr, kFixed},
    {"angle_unit", "Whether angles are in degrees, not in radians.", angle_unit, nullptr, kFixed},
    {"polar_angle", "Whether polar angles are measured from the normal, not from the surface.", polar_angle,
     nullptr, kFixed},
    {"azimuth", "Whether the highlight is opposite the incident direction (convention of the azimuths).",
     azimuth, nullptr, kFixed},
    {"directions", "Whether polar angle and azimuth of the viewing direction are not exchanged.", directions,
     nullptr, kFixed},
    {"mirror",
     "Whether highlights are at the mirror direction (zero errors of the arms, wrong labels of incidences).",
     mirror, nullptr, kFixed},
    {"outliers", "Whether every value agrees with its neighbours.", outliers, outliers, {}},
    {"saturation",
     "Whether the detector is not saturated (few rows share the largest value).",
     saturation,
     saturation,
     {}},
    {"reciprocity",
     "Whether exchanging the two directions leaves the value unchanged (Helmholtz reciprocity).", reciprocity,
     nullptr, "the format holds one value for both directions of a pair"},
    {"cosine_factor", "Whether values are f_r itself, not f_r times the cosine of an angle.", cosine_factor,
     nullptr, "the format holds one value for both directions of a pair"},
    {"light_gain", "Whether all incidences were measured on the same scale.", light_gain, nullptr,
     "the format holds one value for both directions of a pair"},
    {"drift", "Whether the scale is constant from the first row of the file to the last.", drift, nullptr,
     "the format's cells are not in the order of the measurement"},
    {"dark_level", "Whether the dark level was subtracted from the readings.", dark_level, nullptr,
     "the format holds one value for both directions of a pair"},
    {"noise_floor",
     "The measurement noise, estimated from neighbours and from rows that are equal by symmetry.",
     noise_floor, nullptr, "the format's cells are means of many pixels"},
    {"quantity",
     "Whether the values are in the range of f_r, rather than counts or percentages.",
     quantity,
     quantity,
     {}},
    {"isotropy", "Whether rotating the sample leaves the values unchanged.", isotropy, nullptr,
     "the format is isotropic"},
    {"coverage",
     "The share of the hemisphere that lies between measured directions (angular coverage).",
     coverage,
     coverage,
     {}},
    {"energy",
     "Whether the directional albedo is at most 1 at every angle of incidence (energy conservation).",
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
