#include "io/samples/aperture.h"

#include <cmath>

#include "brdf/angle.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {

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
  const std::optional<std::string> text = table.find_metadata(kApertureKey);
  if (!text) return std::nullopt;
  std::vector<std::string_view> words;
  split_blanks(*text, words);
  const bool is_degrees =
      words.size() == 1 || (words.size() == 2 && (words[1] == "degrees" || words[1] == "deg"));
  double degrees;
  if (!is_degrees || !parse_number(words[0], degrees) || !(degrees > 0 && degrees <= 90)) return std::nullopt;
  return degrees;
}

}  // namespace brdf::io
