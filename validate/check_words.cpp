#include "validate/check_words.h"

#include <algorithm>
#include <iterator>

#include "sheet/data_sheet.h"

namespace brdf::validate {
namespace {

struct Meaning {
  std::string_view check, text;
};

constexpr Meaning kMeanings[] = {
    {"finite", "Whether every value is a number, whatever the directions."},
    {"undefined", "Whether a shader's value depends on what its language leaves undefined."},
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
};

}  // namespace

std::string_view check_meaning(std::string_view check) {
  const auto* const found = std::ranges::find(kMeanings, check, &Meaning::check);
  return found == std::end(kMeanings) ? sheet::check_meaning(check) : found->text;
}

}  // namespace brdf::validate
