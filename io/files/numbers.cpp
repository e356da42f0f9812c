#include "io/files/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::io {

std::string short_number(double x, int digits) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, x, std::chars_format::general, digits).ptr;
  return {text, end};
}

std::string percent(double share, int digits) {
  const double value = 100 * share;
  const std::string text = short_number(value, digits);
  // Without an exponent: "130 %", not "1.3e+02 %".
  const bool has_exponent = text.find('e') != text.npos && std::abs(value) >= 1 && std::abs(value) < 1e6;
  return (has_exponent ? std::to_string(std::llround(value)) : text) + " %";
}

std::string percent_to_tenths(double share) {
  return to_text(std::round(1000 * share) / 10) + " %";
}

std::string plural(std::size_t n, const std::string& word) {
  const std::string many = word.ends_with('y') ? word.substr(0, word.size() - 1) + "ies" : word + "s";
  return std::to_string(n) + " " + (n == 1 ? word : many);
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) (text += text.empty() ? "" : separator) += word;
  return text;
}

std::string joined_numbers(const std::vector<double>& numbers, const std::string& separator) {
  std::vector<std::string> words;
  for (const double number : numbers) words.push_back(to_text(number));
  return joined(words, separator);
}

void require_between(const std::string& option, double value, double low, double high,
                     const std::string& unit) {
  if (!(value >= low && value <= high))
    throw InputError(option + " " + to_text(value) + ": must be between " + to_text(low) + " and " +
                     to_text(high) + unit);
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return NAN;
  const auto place =
      values.begin() + std::ptrdiff_t(std::min(share * double(values.size()), double(values.size() - 1)));
  std::ranges::nth_element(values, place);
  return *place;
}

double median(std::vector<double> values) {
  return quantile(std::move(values), 0.5);
}

}  // namespace brdf::io
