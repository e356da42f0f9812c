#include "io/columns/scale_comments.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "io/columns/name_tokens.h"
#include "io/columns/units.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using Tokens = std::vector<Token>;

constexpr std::array<std::string_view, 17> kScaleWords{
    "%",     "percent", "pct", "permille",    "ppm",       "ppb",        "db",         "decibel", "decibels",
    "log10", "ln",      "log", "logarithmic", "logarithm", "normalised", "normalized", "milli"};
constexpr std::array<std::string_view, 15> kValueWords{
    "value", "values", "data",  "brdf",   "bsdf",   "brf",     "fr",          "reflectance",
    "unit",  "units",  "scale", "scaled", "column", "columns", "reflectances"};
constexpr std::array<std::string_view, 20> kOtherWords{
    "noise",     "uncertainty", "uncertainties", "error",  "errors",    "sigma",      "humidity",
    "deviation", "accuracy",    "precision",     "std",    "linearity", "tolerance",  "repeatability",
    "drift",     "confidence",  "file",          "folder", "azimuth",   "temperature"};
constexpr std::array<std::string_view, 7> kScaleKeys{"scale",   "factor",     "scalefactor", "scalingfactor",
                                                     "scaling", "multiplier", "multipliedby"};

template <std::size_t n>
bool has_word(const Tokens& tokens, const std::array<std::string_view, n>& words) {
  return std::ranges::any_of(tokens,
                             [&](const Token& t) { return std::ranges::find(words, t.text) != words.end(); });
}

bool is_other_than_1(std::string_view text) {
  double number;
  return parse_number(text, number) && number != 1;
}

// Returns whether a word of a scale stands without a number: "in percent", but not "45 %".
bool has_bare_scale(const Tokens& tokens) {
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    const bool is_scale = std::ranges::find(kScaleWords, tokens[k].text) != kScaleWords.end();
    if (is_scale && (k == 0 || tokens[k - 1].type != Token::Type::number)) return true;
  }
  return false;
}

// Returns whether the values were multiplied or divided by a number: "multiplied by 1000", "x 1000".
bool has_factor(const Tokens& tokens) {
  constexpr std::array<std::string_view, 4> kVerbs{"multiplied", "divided", "scaled", "times"};
  for (std::size_t k = 0; k + 1 < tokens.size(); ++k) {
    const bool is_verb = std::ranges::find(kVerbs, tokens[k].text) != kVerbs.end();
    const std::size_t number = k + (tokens[k + 1].text == "by" ? 2 : 1);
    const bool is_parted = k == 0 || tokens[k - 1].end < tokens[k].begin;  // not the end of "MaterialX"
    const bool is_sign = (tokens[k].text == "x" && is_parted) || tokens[k].text == "*";
    if ((is_verb || is_sign) && number < tokens.size() && is_other_than_1(tokens[number].text)) return true;
  }
  return false;
}

// Returns whether a list of units has one that values of f_r and reflectance factors do not have. In a list
// with 1/sr the others belong to other columns.
bool has_other_unit(std::string_view list) {
  using K = Unit::Kind;
  std::vector<std::string_view> parts;
  split(list, list.find(';') != list.npos ? ';' : ',', parts);
  bool has_other = false;
  for (const std::string_view part : parts) {
    const auto unit = unit_named(part);
    if (!unit) continue;
    const K kind = unit->kind();
    const bool is_plain = unit->factor == 1 && !unit->is_percent && !unit->is_decibel;
    if (kind == K::per_steradian && is_plain) return false;
    const bool is_signal =
        kind == K::radiance || kind == K::luminance || kind == K::intensity || kind == K::signal;
    const bool is_scaled = (kind == K::number || kind == K::per_steradian || kind == K::percent) && !is_plain;
    has_other = has_other || is_signal || is_scaled || unit->is_decibel;
  }
  return has_other;
}

std::string plain_key(std::string_view key) {
  std::string plain = lower_case(key);
  std::erase_if(plain, [](char c) { return c == ' ' || c == '_' || c == '-'; });
  return plain;
}

}  // namespace

bool is_about_scale(const Comment& comment) {
  const std::string key = plain_key(comment.first);
  const bool is_of_units = key == "unit" || key == "units" || key == "valueunit" || key == "valueunits";
  if (is_of_units && has_other_unit(comment.second)) return true;
  const Tokens tokens = tokens_of(plain_symbols(comment.second));
  if (std::ranges::find(kScaleKeys, key) != kScaleKeys.end()) {
    double number;
    const bool is_number = parse_number(trimmed(comment.second), number);
    return is_number ? number != 1 : has_bare_scale(tokens) || has_factor(tokens);
  }
  Tokens all = tokens_of(plain_symbols(comment.first));
  all.insert(all.end(), tokens.begin(), tokens.end());
  if (!has_word(all, kValueWords) || has_word(all, kOtherWords)) return false;
  return has_bare_scale(all) || has_factor(all);
}

}  // namespace brdf::io
