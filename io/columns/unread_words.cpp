#include "io/columns/unread_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/columns/name_tokens.h"
#include "io/columns/polarisation_names.h"
#include "io/columns/units.h"
#include "io/columns/wavelengths.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

constexpr std::string_view kFunctions[] = {"sqrt",    "cbrt",    "root",       "exp",  "abs",     "square",
                                           "squared", "cubed",   "reciprocal", "inv",  "inverse", "inverted",
                                           "asinh",   "arcsinh", "sinh",       "tanh", "minus",   "negative"};
// Numbers that are computed from values of f_r, or that accompany them, and are not f_r.
constexpr std::string_view kDerived[] = {
    "ratio",   "delta",   "diff",     "difference", "residual", "residuals", "min",        "max",
    "minimum", "maximum", "variance", "var",        "rsd",      "rmse",      "derivative", "gradient"};
// Words that are names of samples as well: derived only next to the word of a quantity or to a band.
constexpr std::string_view kPerhapsDerived[] = {"dark",  "bg",    "background", "offset", "lower",
                                                "upper", "range", "sum",        "slope"};
// Words of up to three letters that are names, not units, within brackets.
constexpr std::string_view kShortNames[] = {
    "r",   "g",   "b",   "x",   "y",   "z",   "red", "uv",  "vis", "ir",  "nir", "mir", "pan", "avg",
    "raw", "fit", "top", "mid", "new", "old", "in",  "out", "co",  "cie", "fr",  "the", "of",  "and"};
constexpr std::string_view kMeans[] = {"mean", "average", "avg", "median"};

template <std::size_t n>
bool is_one_of_words(std::string_view word, const std::string_view (&list)[n]) {
  return std::ranges::find(list, word) != std::end(list);
}

std::string of_part(std::string_view what, std::string_view part) {
  return "has the " + std::string(what) + " " + shown(part) +
         " in its name, which is not applied: rename the column if its values are f_r or the named quantity, "
         "give --quantity, as in --quantity 'BRDF x1000', or describe the columns with --layout";
}

bool is_power_of_ten(double number) {
  const double ten = std::log10(number);
  return number > 0 && number != 1 && std::abs(ten - std::round(ten)) < 1e-12;
}

// Looks at the tokens that no reader has used.
class Unread {
 public:
  explicit Unread(const QuantityWords& words) : words_(words), tokens_(words.tokens), text_(words.plain) {}

  std::optional<UnreadPart> find() const {
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      if (tokens_[k].is_used) continue;
      if (auto part = operation_at(k)) return part;
      if (auto part = factor_at(k)) return part;
      if (auto part = word_at(k)) return part;
      if (auto part = bracket_at(k)) return part;
    }
    return std::nullopt;
  }

 private:
  using Part = std::optional<UnreadPart>;
  using Type = Token::Type;

  bool has(std::size_t k, Type type) const { return k < tokens_.size() && tokens_[k].type == type; }
  bool is(std::size_t k, std::string_view text) const {
    return k < tokens_.size() && tokens_[k].text == text;
  }
  bool is_quantity(std::size_t k) const {
    return k < tokens_.size() && tokens_[k].is_used && tokens_[k].type == Type::word;
  }
  double number(std::size_t k) const {
    double number = NAN;
    return has(k, Type::number) && parse_number(tokens_[k].text, number) ? number : NAN;
  }
  std::string_view text_of(std::size_t begin, std::size_t end) const {
    return std::string_view(text_).substr(tokens_[begin].begin, tokens_[end].end - tokens_[begin].begin);
  }

  // Returns whether the slash parts the two angles of a geometry: 45/0, 0/45.
  bool is_geometry(std::size_t slash) const {
    const double before = slash > 0 ? number(slash - 1) : NAN, after = number(slash + 1);
    return (before == 0 && after > 0 && after <= 90) || (after == 0 && before > 0 && before <= 90);
  }

  Part operation_at(std::size_t k) const {
    const Token& token = tokens_[k];
    if (token.type != Type::sign) return std::nullopt;
    const bool is_operator =
        std::string_view("*/^|").find(token.text) != std::string_view::npos || (is(k, "+") && words_.kind);
    if (is_operator && !(is(k, "/") && is_geometry(k))) return UnreadPart{of_part("operator", token.text)};
    // "-fr", "1-fr"; the hyphen in "sample-A" and "fr-550" parts words.
    const bool is_minus = is(k, "-") && is_quantity(k + 1) && (k == 0 || has(k - 1, Type::number));
    if (is_minus) return UnreadPart{of_part("operator", token.text)};
    return std::nullopt;
  }

  // A number that may be the wavelength of a band, or the number of a sample, is not a factor.
  Part factor_at(std::size_t k) const {
    if (tokens_[k].type != Type::number) return std::nullopt;
    const double value = number(k);
    const bool is_band = wavelength_of(text_of(k, std::min(k + 1, tokens_.size() - 1))).has_value();
    const bool has_exponent = tokens_[k].text.find('e') != std::string::npos;
    const bool leads = k == 0 && is_quantity(k + 1) && value != 1;
    const bool is_in_range = with_band_unit(tokens_[k].text) != tokens_[k].text && !is_power_of_ten(value);
    const bool is_small = words_.kind && value < 1 && is_power_of_ten(value);
    const bool is_bracketed = words_.kind && is_power_of_ten(value) && k > 0 &&
                              (is(k - 1, "(") || is(k - 1, "[")) && (is(k + 1, ")") || is(k + 1, "]"));
    if (is_band || !(has_exponent || (leads && !is_in_range) || is_small || is_bracketed))
      return std::nullopt;
    return UnreadPart{of_part("factor", tokens_[k].text)};
  }

  Part word_at(std::size_t k) const {
    const Token& token = tokens_[k];
    if (token.type != Type::word) return std::nullopt;
    if (is_one_of_words(token.text, kFunctions) || is_function(k))
      return UnreadPart{of_part("function", token.text)};
    const bool is_prefix = is(k, "d") && is_quantity(k + 1) && tokens_[k + 1].begin == token.end;
    const bool is_derived = is_one_of_words(token.text, kDerived) || is_prefix ||
                            (is_one_of_words(token.text, kPerhapsDerived) && (words_.kind || has_band()));
    if (is_derived) return UnreadPart{of_part("word", token.text), true};
    return std::nullopt;
  }

  // Returns whether the word is called with the quantity: f(BRDF). A mean is not another quantity.
  bool is_function(std::size_t k) const {
    const bool is_call = is(k + 1, "(") && tokens_[k + 1].begin == tokens_[k].end && is_quantity(k + 2);
    return is_call && !is_one_of_words(tokens_[k].text, kMeans);
  }

  bool has_band() const {
    return std::ranges::any_of(tokens_, [](const Token& t) { return t.type == Type::number; });
  }

  // A word in brackets behind a quantity is a unit, unless it is a name.
  Part bracket_at(std::size_t k) const {
    if (!words_.kind || !(is(k, "(") || is(k, "["))) return std::nullopt;
    std::size_t close = k + 1;
    while (close < tokens_.size() && !is(close, ")") && !is(close, "]")) {
      if (tokens_[close].is_used) return std::nullopt;
      ++close;
    }
    if (close == tokens_.size() || close == k + 1) return std::nullopt;
    const std::string_view inside = text_of(k + 1, close - 1);
    const bool is_short = close == k + 2 && has(k + 1, Type::word) && inside.size() <= 3 &&
                          !is_one_of_words(tokens_[k + 1].text, kShortNames);
    const bool has_per =
        std::any_of(tokens_.begin() + std::ptrdiff_t(k), tokens_.begin() + std::ptrdiff_t(close),
                    [](const Token& t) { return t.text == "per"; });
    if (!(is_short || has_per) || polarisation_named(inside) || wavelength_of(inside) || is_filling(inside))
      return std::nullopt;
    return UnreadPart{of_part("unknown unit", inside)};
  }

  const QuantityWords& words_;
  const std::vector<Token>& tokens_;
  const std::string& text_;
};

}  // namespace

std::optional<UnreadPart> unread_part(const QuantityWords& words) {
  return Unread(words).find();
}

}  // namespace brdf::io
