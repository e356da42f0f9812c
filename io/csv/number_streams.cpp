#include "io/csv/number_streams.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

constexpr std::size_t kMostLooked = 1 << 20;  // most numbers that are read

// Returns all numbers of a text without its comments. Empty if the text contains anything else.
std::vector<double> numbers_of(const Content& content) {
  std::vector<double> numbers;
  LineReader reader(content);
  std::vector<std::string_view> words;
  for (std::string_view line; reader.next(line);) {
    split_blanks(line.substr(0, line.find('#')), words);
    for (const std::string_view word : words) {
      double number;
      if (!parse_number(word, number)) return {};
      numbers.push_back(number);
    }
    if (numbers.size() > kMostLooked) break;
  }
  return numbers;
}

// Recognises a count n, n wavelengths, then records of four angles and n values.
std::optional<std::string> spectral_text(const std::vector<double>& numbers) {
  constexpr double kMost = 1000, kShortest = 200, kLongest = 3e4;
  if (numbers.size() < 6 || !(numbers[0] >= 1 && numbers[0] <= kMost) || numbers[0] != std::floor(numbers[0]))
    return std::nullopt;
  const auto count = std::size_t(numbers[0]);
  if (numbers.size() < 2 * count + 5) return std::nullopt;
  for (std::size_t k = 1; k <= count; ++k)
    if (!(numbers[k] >= kShortest && numbers[k] <= kLongest) || (k > 1 && !(numbers[k] > numbers[k - 1])))
      return std::nullopt;
  const bool is_whole = numbers.size() > kMostLooked || (numbers.size() - 1 - count) % (4 + count) == 0;
  if (!is_whole) return std::nullopt;
  return "the numbers look like spectral text of the Cornell laboratory (" + std::to_string(count) +
         " wavelengths, then records of theta_i, phi_i, theta_s, phi_s in radians and " +
         std::to_string(count) + (count == 1 ? " value" : " values") +
         "), which is not read: write the header row 'theta_i (rad),phi_i (rad),theta_o (rad),phi_o (rad)," +
         to_text(numbers[1]) + "nm,...' and one record in each line";
}

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
  if (const auto known = spectral_text(numbers_of(content))) return *known;
  const std::string generic = "write one above the numbers: theta_i,phi_i,theta_o,phi_o,<channel>...";
  if (first_row.size() < 3 || first_row.size() > 40) return generic;
  const std::size_t at = content.bytes.find_first_of(",;\t");
  const char separator = at == std::string::npos ? ' ' : content.bytes[at];
  const std::vector<std::string> names = guessed_names(largest_of(content, first_row.size(), separator));
  return "write one above the numbers: " + joined(names, std::string(1, separator)) +
         " (guessed from the numbers; please check)";
}

}  // namespace brdf::io
