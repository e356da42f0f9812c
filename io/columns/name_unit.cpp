#include "io/columns/name_unit.h"

#include <algorithm>

#include "io/columns/polarisation_names.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

bool is_band_unit(const Unit& unit) {
  using K = Unit::Kind;
  return unit.kind() == K::length || unit.kind() == K::wavenumber || unit.kind() == K::frequency ||
         unit.kind() == K::energy;
}

// Returns the position of the bracket that this one closes; npos if the text has no such bracket.
std::size_t opening_of(std::string_view text, std::size_t close) {
  int depth = 0;
  for (std::size_t k = close + 1; k-- > 0;) {
    depth += text[k] == ')' || text[k] == ']';
    depth -= text[k] == '(' || text[k] == '[';
    if (depth == 0) return k;
  }
  return text.npos;
}

bool says_no_unit(std::string_view inside) {
  constexpr std::string_view kWords[] = {"1", "-", "--", "unitless", "dimensionless", "none", "n/a"};
  return std::find(std::begin(kWords), std::end(kWords), lower_case(inside)) != std::end(kWords);
}

// Separates a unit in brackets, searching from the right. The name of a polarisation is not a unit: fr (s).
bool part_brackets(std::string_view text, NameUnit& out) {
  for (std::size_t close = text.find_last_of(")]"); close != text.npos && close > 0;
       close = text.find_last_of(")]", close - 1)) {
    const std::size_t open = opening_of(text, close);
    if (open == text.npos) return false;
    const std::string_view inside = trimmed(text.substr(open + 1, close - open - 1));
    const auto unit = unit_named(inside);
    const std::string plain = plain_symbols(inside);
    const bool is_multiplier = unit && *unit == Unit{unit->factor} && plain.find("^-") == plain.npos &&
                               plain.find("e-") == plain.npos && lower_case(plain) != "milli";
    const bool is_dimensionless = says_no_unit(plain);
    if ((!unit || is_multiplier || polarisation_named(inside)) && !is_dimensionless) continue;
    if (!is_dimensionless) out.unit = unit;
    out.unit_text = inside;
    out.bare = std::string(trimmed(text.substr(0, open)));
    const std::string_view after = trimmed(text.substr(close + 1));
    if (!after.empty()) out.bare += (out.bare.empty() ? "" : " ") + std::string(after);
    return true;
  }
  return false;
}

// Returns whether a unit is accepted only in brackets: single letters and these words.
bool is_word_first(std::string_view unit) {
  constexpr std::string_view kWords[] = {
      "min", "count",  "counts",  "day",    "days",    "h",    "hour",  "hours",   "sec",    "bar",
      "ang", "second", "seconds", "minute", "minutes", "grad", "milli", "photons", "photon", "inch"};
  return unit.size() == 1
             ? unit != "%" && unit != "°"
             : std::find(std::begin(kWords), std::end(kWords), lower_case(unit)) != std::end(kWords);
}

// Separates the longest unit after a separator: "fr 1/sr", "wavelength_nm", "theta/deg". A unit of
// wavelengths with a number before it is part of the name of a band.
bool part_suffix(std::string_view text, NameUnit& out) {
  for (std::size_t at = text.find_first_of("/, _"); at != text.npos;
       at = text.find_first_of("/, _", at + 1)) {
    const std::string_view before = trimmed(text.substr(0, at)), after = trimmed(text.substr(at + 1));
    const bool is_bracket = after.starts_with('(') || after.starts_with('[');
    if (before.empty() || after.empty() || is_bracket || is_word_first(after)) continue;
    if (after.starts_with('/')) continue;  // "BRF / %": the slash is the separator
    const bool is_per = text[at] == '/' && unit_named(after) == unit_named("sr");
    const auto unit = is_per ? unit_named("1/sr") : unit_named(after);  // values are never in steradians
    if (!unit || *unit == Unit{unit->factor}) continue;
    constexpr std::string_view digits = "0123456789";
    const bool has_number =
        digits.find(after.front()) != digits.npos || digits.find(before.back()) != digits.npos;
    if (is_band_unit(*unit) && has_number) continue;
    out.bare = std::string(before);
    out.unit = unit;
    out.unit_text = after;
    return true;
  }
  return false;
}

}  // namespace

NameUnit parted(std::string_view text) {
  text = trimmed(text);
  NameUnit out{std::string(text), std::nullopt, ""};
  const auto whole = unit_named(text);
  const bool has_sign =
      text.find_first_of("/^%") != text.npos || lower_case(text) == "db" || (whole && whole->is_percent);
  if (whole && has_sign && !is_band_unit(*whole)) {
    out.unit = whole;
    out.unit_text = text;
    out.bare.clear();
  } else if (!part_brackets(text, out)) {
    part_suffix(text, out);
  }
  return out;
}

}  // namespace brdf::io
