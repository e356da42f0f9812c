#include "io/columns/no_number.h"

#include <algorithm>
#include <array>
#include <charconv>

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
    return "; write no row where nothing was measured";
  if (is_beyond_range(field)) return "; it is beyond the range of numbers, 1.8e308";
  if (field.find("°") != field.npos || field.find("º") != field.npos)
    return "; a unit stands in the column's name, as in 'theta_i (deg)'";
  if (field.back() == '%') return "; values are f_r in 1/sr, not percent";
  if (holds_any(field, kTypographicMinus)) return "; the minus sign of numbers is '-'";
  if (field.find('#') != field.npos) return "; a comment is a line of its own, which begins with '#'";
  if (has_fortran_exponent(field)) return "; an exponent is written with e";
  if (holds_any(field, kGroups) || (field.find('.') != field.npos && field.find(',') != field.npos))
    return "; thousands are not grouped";
  return "";
}

}  // namespace brdf::io
