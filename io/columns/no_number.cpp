#include "io/columns/no_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "io/files/text.h"

namespace brdf::io {
namespace {

constexpr std::array<std::string_view, 18> kNothing{"",      "-",    "--",      "?",       "nan",   "na",
                                                    "n/a",   "null", "none",    "inf",     "-inf",  "+inf",
                                                    "#num!", "#n/a", "#value!", "#div/0!", "#ref!", "#name?"};
// No-break, narrow no-break and thin space, apostrophes.
constexpr std::array<std::string_view, 5> kGroups{"\u00a0", "\u202f", "\u2009", "'", "\u2019"};
constexpr std::array<std::string_view, 3> kTypographicMinus{"\u2212", "\u2013", "\u2010"};

template <std::size_t n>
bool holds_any(std::string_view text, const std::array<std::string_view, n>& parts) {
  return std::ranges::any_of(parts, [&](std::string_view part) { return text.find(part) != text.npos; });
}

bool is_beyond_range(std::string_view text) {
  double value;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc::result_out_of_range && stop == text.data() + text.size();
}

// 1.25D-01
bool has_fortran_exponent(std::string_view text) {
  std::string plain = lower_case(text);
  std::ranges::replace(plain, 'd', 'e');
  double value;
  return plain != lower_case(text) && parse_number(plain, value);
}

}  // namespace

std::string advice_on(std::string_view field) {
  if (std::ranges::find(kNothing, lower_case(field)) != kNothing.end())
    return "; omit the rows of directions that were not measured";
  if (is_beyond_range(field))
    return std::abs(std::strtod(std::string(field).c_str(), nullptr)) < 1
               ? "; the value is below the smallest number above 0, 4.9e-324: write 0"
               : "; the value exceeds the largest number, 1.8e308";
  if (field.find("°") != field.npos || field.find("º") != field.npos)
    return "; write the unit in the column's name, as in 'theta_i (deg)'";
  if (field.back() == '%') return "; values are f_r in 1/sr, not percent";
  if (holds_any(field, kTypographicMinus)) return "; use '-' as the minus sign";
  if (field.find('#') != field.npos) return "; write a comment as a separate line that begins with '#'";
  if (has_fortran_exponent(field)) return "; write the exponent with e";
  if (holds_any(field, kGroups) || (field.find('.') != field.npos && field.find(',') != field.npos))
    return "; do not group thousands";
  return "";
}

bool is_summary_word(std::string_view field) {
  constexpr std::array<std::string_view, 12> kWords{"mean", "average", "avg",     "total",
                                                    "sum",  "median",  "stdev",   "std",
                                                    "std.", "minimum", "maximum", "mittelwert"};
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (field.empty() || !is_letter(field.front())) return false;  // most cells are numbers
  std::string word = lower_case(trimmed(field));
  while (word.ends_with(':') || word.ends_with('.')) word.pop_back();
  return std::ranges::find(kWords, word) != kWords.end();
}

}  // namespace brdf::io
