#include "io/samples/aperture.h"

#include <algorithm>
#include <cmath>

#include "brdf/angle.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {

namespace {

// Returns the key in small letters, with blanks in place of underscores and hyphens.
std::string words_of_key(std::string_view key) {
  std::string words = lower_case(key);
  std::replace_if(
      words.begin(), words.end(), [](char c) { return c == '_' || c == '-'; }, ' ');
  return words;
}

// Returns the width in degrees that a comment states. A bare aperture needs a unit of angles, because it may
// be a word or the number of a stop.
std::optional<double> aperture_in(std::string_view key, std::string_view value) {
  const std::string name = words_of_key(key);
  const bool is_own = name == words_of_key(kApertureKey);
  const bool is_aperture = is_own || name == "aperture" || name == "collection aperture";
  const bool is_solid_angle = name == "solid angle" || name == "detector solid angle" ||
                              name == "collection solid angle" || name == "receiver solid angle";
  if (!is_aperture && !is_solid_angle) return std::nullopt;
  std::vector<std::string_view> words;
  split_blanks(value, words);
  if (words.empty() || words.size() > 2) return std::nullopt;
  const std::string_view unit = words.size() == 2 ? words[1] : "";
  double number;
  if (!parse_number(words[0], number) || !(number > 0)) return std::nullopt;
  const bool is_degrees = unit == "degrees" || unit == "deg" || unit == "\u00b0";
  if (is_aperture && (is_degrees || (is_own && unit.empty())) && number <= 90) return number;
  const double solid_angle = unit == "msr" ? number / 1000 : number;
  const bool is_sr = unit.empty() || unit == "sr" || unit == "msr";
  if (!is_solid_angle || !is_sr || !(solid_angle <= 2 * kPi)) return std::nullopt;
  const double width = aperture_of_solid_angle(solid_angle);
  return width <= 90 ? std::optional(width) : std::nullopt;
}

}  // namespace

double aperture_of_solid_angle(double solid_angle) {
  return radians(2 * std::acos(1 - solid_angle / (2 * kPi))).degrees();
}

void state_solid_angle(SampleTable& table, double solid_angle) {
  const std::string stated = "the file states a detector of " + short_number(solid_angle, 6) + " sr";
  if (!(solid_angle > 0 && solid_angle <= 2 * kPi)) {
    table.warnings.push_back(stated + ", which is not a solid angle and is not used");
    return;
  }
  const std::string degrees = short_number(aperture_of_solid_angle(solid_angle), 4);
  table.add_comment(kApertureKey, degrees + " degrees");
  table.warnings.push_back(stated + ", a round field of " + degrees + " degrees");
}

std::optional<double> stated_aperture(const SampleTable& table) {
  for (const auto& [key, value] : table.metadata)
    if (const auto degrees = aperture_in(key, value)) return degrees;
  return std::nullopt;
}

}  // namespace brdf::io
