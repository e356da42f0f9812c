#include "validate/check_words.h"

#include <algorithm>
#include <iterator>

namespace brdf::validate {
namespace {

struct Meaning {
  std::string_view check, text;
};

constexpr Meaning kMeanings[] = {
    {"finite", "Whether every value is a number, whatever the directions."},
    {"non_negative", "Whether no value is below 0."},
    {"reciprocity", "Whether light and viewer may change places without changing the value (Helmholtz)."},
    {"energy",
     "Whether no light gives back more than it brings: the reflected fraction is at most 1 at every angle."},
    {"albedo", "Whether the integrated reflected fraction agrees with its closed form, where there is one."},
    {"normalisation", "Whether the facets' projected areas add up to the surface's area."},
    {"white_furnace",
     "Whether the facets that one sees have just the area that the masking leaves (weak white furnace, Heitz "
     "2014)."},
    {"isotropy",
     "Whether turning the surface about its normal changes nothing, or does so along two axes only."},
    {"continuity", "Whether the reflected light fades out as the light sets, without a step."},
    {"sampling", "Whether random directions drawn for this form average to the reflected fraction."},
    {"float", "Whether a shader's values in single precision are those that its formula has in double."},
    {"derivatives", "Whether derivatives computed exactly agree with differences of values."},
    {"negative", "Whether no measured value is below 0."},
    {"missing", "Whether every row has all its values."},
    {"duplicates", "Whether no direction is listed twice."},
    {"angle_unit", "Whether angles are in degrees, not in radians."},
    {"polar_angle", "Whether polar angles count from the normal, not up from the surface."},
    {"azimuth", "Whether the highlight stands opposite the light: the azimuths' convention."},
    {"directions", "Whether polar angle and azimuth of the viewer are not exchanged."},
    {"outliers", "Whether every value fits in with its neighbours."},
    {"saturation", "Whether the detector had room: not too many rows share the largest value."},
    {"noise_floor", "How much the values scatter about a smooth law: what no fit can undercut."},
    {"cosine_factor", "Whether values are f_r itself, not f_r times the cosine of an angle."},
    {"quantity", "Whether values are as large as those of f_r can be: no counts, no percent."},
    {"coverage", "How much of the hemisphere of directions the samples reach."},
};

}  // namespace

std::string_view check_meaning(std::string_view check) {
  const auto* const found = std::ranges::find(kMeanings, check, &Meaning::check);
  return found == std::end(kMeanings) ? "" : found->text;
}

}  // namespace brdf::validate
