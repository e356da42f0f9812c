#include "io/csv/number_streams.h"

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// Returns the largest magnitude of each column in the first rows.
std::vector<double> largest_of(const Content& content, std::size_t width, char separator) {
  constexpr std::size_t kRows = 500;
  std::vector<double> largest(width, 0.0);
  LineReader reader(content);
  std::vector<std::string_view> fields;
  std::string_view line;
  for (std::size_t row = 0; row < kRows && reader.next(line);) {
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    separator == ' ' ? split_blanks(line, fields) : split(line, separator, fields);
    for (std::size_t k = 0; k < std::min(width, fields.size()); ++k) {
      double number;
      if (parse_number(fields[k], number)) largest[k] = std::max(largest[k], std::abs(number));
    }
    ++row;
  }
  return largest;
}

std::vector<std::string> guessed_names(const std::vector<double>& largest) {
  constexpr double kRightAngle = 1.5709, kTurn = 6.2833;
  const std::size_t width = largest.size();
  const bool has_azimuths = width >= 5;
  std::vector<std::string> names = has_azimuths
                                       ? std::vector<std::string>{"theta_i", "phi_i", "theta_o", "phi_o"}
                                   : width == 4 ? std::vector<std::string>{"theta_i", "theta_o", "phi_o"}
                                                : std::vector<std::string>{"theta_i", "theta_o"};
  bool is_radians = true;
  for (std::size_t k = 0; k < std::min(names.size(), width); ++k)
    is_radians = is_radians && largest[k] <= (names[k].starts_with("phi") ? kTurn : kRightAngle);
  if (is_radians)
    for (std::string& name : names) name += " (rad)";
  const std::size_t angles = names.size();
  if (width == angles + 2 && largest[angles] > 100) names.emplace_back("wavelength (nm)");
  for (std::size_t k = names.size(); k < width; ++k)
    names.push_back(width == names.size() + 1 && k == names.size() ? "fr"
                                                                   : "f" + std::to_string(k - angles + 1));
  return names;
}

}  // namespace

std::string header_for_numbers(const Content& content, const std::vector<std::string_view>& first_row) {
  const std::string generic = "write one above the numbers: theta_i,phi_i,theta_o,phi_o,<channel>...";
  if (first_row.size() < 3 || first_row.size() > 40) return generic;
  const std::size_t at = content.bytes.find_first_of(",;\t");
  const char separator = at == std::string::npos ? ' ' : content.bytes[at];
  const std::vector<std::string> names = guessed_names(largest_of(content, first_row.size(), separator));
  return "write one above the numbers: " + joined(names, std::string(1, separator)) +
         " (guessed from the numbers; please check)";
}

}  // namespace brdf::io
