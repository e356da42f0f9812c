#include "io/columns/units.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "brdf/scalar.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using Power = std::pair<Unit::Base, int>;

Unit product(double factor, std::initializer_list<Power> powers) {
  Unit unit;
  unit.factor = factor;
  for (const auto& [base, exponent] : powers) unit.exponents[base] += exponent;
  return unit;
}

Unit decibel(std::initializer_list<Power> powers) {
  Unit unit = product(1, powers);
  unit.is_decibel = true;
  return unit;
}

Unit percent(double factor) {
  Unit unit = product(factor, {});
  unit.is_percent = true;
  return unit;
}

using UnitNames = std::map<std::string, Unit, std::less<>>;

// Symbols that may have a prefix (m, k, ...), spelled with case.
const UnitNames& symbols() {
  static const UnitNames all{{"m", product(1, {{Unit::metre, 1}})},
                             {"s", product(1, {{Unit::second, 1}})},
                             {"sr", product(1, {{Unit::steradian, 1}})},
                             {"rad", product(1, {{Unit::radian, 1}})},
                             {"lm", product(1, {{Unit::lumen, 1}})},
                             {"cd", product(1, {{Unit::lumen, 1}, {Unit::steradian, -1}})},
                             {"lx", product(1, {{Unit::lumen, 1}, {Unit::metre, -2}})},
                             {"W", product(1, {{Unit::watt, 1}})},
                             {"A", product(1, {{Unit::ampere, 1}})},
                             {"V", product(1, {{Unit::volt, 1}})},
                             {"Hz", product(1, {{Unit::second, -1}})},
                             {"eV", product(1, {{Unit::electronvolt, 1}})},
                             {"Pa", product(1, {{Unit::pascal, 1}})},
                             {"K", product(1, {{Unit::kelvin, 1}})}};
  return all;
}

// Words and symbols without prefixes, in any case.
const UnitNames& words() {
  static const UnitNames all = [] {
    UnitNames names;
    const auto add = [&](std::initializer_list<const char*> spellings, const Unit& unit) {
      for (const char* spelling : spellings) names.emplace(spelling, unit);
    };
    constexpr double kDegree = kPi / 180;
    add({"deg", "degs", "degree", "degrees", "°"}, product(kDegree, {{Unit::radian, 1}}));
    add({"rads", "radian", "radians"}, product(1, {{Unit::radian, 1}}));
    add({"gon", "grad", "gons"}, product(kPi / 200, {{Unit::radian, 1}}));
    add({"arcmin"}, product(kDegree / 60, {{Unit::radian, 1}}));
    add({"steradian", "steradians", "ster"}, product(1, {{Unit::steradian, 1}}));
    add({"nanometre", "nanometres", "nanometer", "nanometers"}, product(1e-9, {{Unit::metre, 1}}));
    add({"micron", "microns", "micrometre", "micrometres", "micrometer", "micrometers", "mum"},
        product(1e-6, {{Unit::metre, 1}}));
    add({"angstrom", "angstroms", "angstroem", "ang"}, product(1e-10, {{Unit::metre, 1}}));
    add({"millimetre", "millimetres", "millimeter", "millimeters"}, product(1e-3, {{Unit::metre, 1}}));
    add({"metre", "metres", "meter", "meters"}, product(1, {{Unit::metre, 1}}));
    add({"inch", "inches"}, product(0.0254, {{Unit::metre, 1}}));
    add({"sec", "second", "seconds"}, product(1, {{Unit::second, 1}}));
    add({"min", "minute", "minutes"}, product(60, {{Unit::second, 1}}));
    add({"h", "hour", "hours"}, product(3600, {{Unit::second, 1}}));
    add({"day", "days"}, product(86400, {{Unit::second, 1}}));
    add({"candela"}, product(1, {{Unit::lumen, 1}, {Unit::steradian, -1}}));
    add({"lux"}, product(1, {{Unit::lumen, 1}, {Unit::metre, -2}}));
    add({"nit", "nits"}, product(1, {{Unit::lumen, 1}, {Unit::steradian, -1}, {Unit::metre, -2}}));
    add({"watt", "watts"}, product(1, {{Unit::watt, 1}}));
    add({"volt", "volts"}, product(1, {{Unit::volt, 1}}));
    add({"ampere", "amperes", "amp", "amps"}, product(1, {{Unit::ampere, 1}}));
    add({"hertz", "hz"}, product(1, {{Unit::second, -1}}));
    add({"°c", "degc", "celsius", "°f", "degf", "kelvin"}, product(1, {{Unit::kelvin, 1}}));
    add({"cts", "counts", "count", "adu", "dn", "photons"}, product(1, {{Unit::count, 1}}));
    add({"bar", "hpa", "mbar"}, product(1, {{Unit::pascal, 1}}));
    add({"%", "percent", "pct"}, percent(1e-2));
    add({"permille", "permil", "promille"}, percent(1e-3));
    add({"ppm"}, percent(1e-6));
    add({"ppb"}, percent(1e-9));
    // Units that no column of values has: a name with one of them is refused by it.
    add({"kg", "mg", "gram", "grams", "kilogram", "kilograms"},
        product(1, {{Unit::pascal, 1}, {Unit::metre, 1}, {Unit::second, 2}}));
    add({"newton", "newtons"}, product(1, {{Unit::pascal, 1}, {Unit::metre, 2}}));
    add({"joule", "joules"}, product(1, {{Unit::watt, 1}, {Unit::second, 1}}));
    add({"ohm", "ohms"}, product(1, {{Unit::volt, 1}, {Unit::ampere, -1}}));
    add({"psi", "atm", "torr"}, product(1, {{Unit::pascal, 1}}));
    add({"px", "pixel", "pixels", "bit", "bits", "mol"}, product(1, {{Unit::count, 1}}));
    add({"db", "decibel", "decibels"}, decibel({}));
    add({"dbsm"}, decibel({{Unit::metre, 2}}));
    add({"milli"}, product(1e-3, {}));
    return names;
  }();
  return all;
}

constexpr std::pair<char, double> kPrefixes[] = {{'n', 1e-9}, {'u', 1e-6}, {'m', 1e-3}, {'c', 1e-2},
                                                 {'k', 1e3},  {'M', 1e6},  {'G', 1e9},  {'T', 1e12}};

std::optional<Unit> with_prefix(std::string_view word) {
  if (const auto found = symbols().find(word); found != symbols().end()) return found->second;
  for (const auto& [letter, factor] : kPrefixes) {
    if (word.size() < 2 || word.front() != letter) continue;
    const auto found = symbols().find(word.substr(1));
    if (found == symbols().end()) continue;
    Unit unit = found->second;
    unit.factor *= factor;
    return unit;
  }
  return std::nullopt;
}

std::optional<Unit> one_word(std::string_view word) {
  if (const auto unit = with_prefix(word)) return unit;
  const std::string lower = lower_case(word);
  if (const auto found = words().find(lower); found != words().end()) return found->second;
  // Names written in capitals throughout are accepted: SR, NM, GHZ.
  if (lower == "ghz" || lower == "thz") return with_prefix(lower == "ghz" ? "GHz" : "THz");
  return with_prefix(lower);
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' ||
         static_cast<unsigned char>(c) >= 0x80;
}

class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : rest_(text) {}

  std::optional<Unit> read() {
    for (skip(); !rest_.empty(); skip()) {
      if (rest_.front() == '/') {
        rest_.remove_prefix(1);
        is_divided_ = true;
      } else if (!(is_number() ? take_number() : take_word())) {
        return std::nullopt;
      }
    }
    if (!is_anything_) return std::nullopt;
    return unit_;
  }

 private:
  void skip() { rest_.remove_prefix(std::min(rest_.size(), rest_.find_first_not_of(" \t*.()[]{}"))); }
  bool is_number() const { return rest_.front() >= '0' && rest_.front() <= '9'; }

  // Takes the exponent that follows a unit: 2, -1, ^-1, **-1, ^(-1), ^{-1}. Returns 1 if there is no
  // exponent and 0 if the exponent is not a number.
  int take_exponent(bool needs_sign) {
    std::string_view text = rest_;
    const bool is_marked = text.starts_with('^') || text.starts_with("**");
    if (is_marked) text.remove_prefix(text.front() == '^' ? 1 : 2);
    while (is_marked && (text.starts_with('(') || text.starts_with('{'))) text.remove_prefix(1);
    const bool has_sign = text.starts_with('-') || text.starts_with('+');
    if (!is_marked && needs_sign && !has_sign) return 1;
    if (text.starts_with('+')) text.remove_prefix(1);
    int exponent = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    if (error != std::errc()) return is_marked || has_sign ? 0 : 1;
    rest_.remove_prefix(static_cast<std::size_t>(stop - rest_.data()));
    return exponent > -100 && exponent < 100 ? exponent : 0;
  }

  // A unit after a slash is a divisor, unless its own exponent is negative: cd/m2 lx^-1.
  int signed_exponent(int exponent) const { return is_divided_ && exponent > 0 ? -exponent : exponent; }

  // Takes a power of ten: 10^-3, 1e-3, 1000, 1.
  bool take_number() {
    double number;
    const auto [stop, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (error != std::errc()) return false;
    rest_.remove_prefix(static_cast<std::size_t>(stop - rest_.data()));
    const int exponent = take_exponent(true);
    const double ten = std::log10(number);
    if (!(number > 0) || std::abs(ten - std::round(ten)) > 1e-12 || exponent == 0) return false;
    unit_.factor *= std::pow(10.0, std::round(ten) * exponent * (is_divided_ ? -1 : 1));
    return is_anything_ = true;
  }

  // Takes "per": per mille and per thousand are one unit, and per sr is a divisor.
  bool take_per() {
    skip();
    for (const std::string_view word : {"mille", "mil", "thousand"}) {
      const bool is_whole = rest_.size() <= word.size() || !is_letter(rest_[word.size()]);
      if (!lower_case(rest_).starts_with(word) || !is_whole) continue;
      rest_.remove_prefix(word.size());
      unit_.factor *= is_divided_ ? 1e3 : 1e-3;
      return unit_.is_percent = is_anything_ = true;
    }
    return is_divided_ = true;
  }

  bool take_word() {
    std::size_t size = 0;
    while (size < rest_.size() && is_letter(rest_[size])) ++size;
    const std::string_view word = rest_.substr(0, size);
    if (word.empty()) return false;
    rest_.remove_prefix(size);
    const std::string lower = lower_case(word);
    if (lower == "x") return true;               // x 10^-3 1/sr
    if (lower == "re") return unit_.is_decibel;  // dB re 1/sr
    if (lower == "per") return take_per();
    const std::optional<Unit> unit = one_word(word);
    const int exponent = signed_exponent(take_exponent(false));
    if (!unit || exponent == 0) return false;
    unit_.factor *= std::pow(unit->factor, exponent);
    for (std::size_t k = 0; k < unit_.exponents.size(); ++k)
      unit_.exponents[k] += exponent * unit->exponents[k];
    unit_.is_decibel = unit_.is_decibel || unit->is_decibel;
    unit_.is_percent = unit_.is_percent || unit->is_percent;
    return is_anything_ = true;
  }

  std::string_view rest_;
  Unit unit_;
  bool is_divided_ = false, is_anything_ = false;
};

struct Symbol {
  std::string_view sign, plain;
};
constexpr Symbol kSymbols[] = {{"µ", "u"},
                               {"μ", "u"},
                               {"\u00c5", "angstrom"},
                               {"\u212b", "angstrom"},
                               {"º", "°"},
                               {"·", "*"},
                               {"⋅", "*"},
                               {"∙", "*"},
                               {"×", "*"},
                               {"‰", " permille "},
                               {"％", "%"},
                               {"√", "sqrt "},
                               {"∛", "cbrt "},
                               {"∆", "delta "},
                               {"∂", "delta "},
                               {"∑", "sum "},
                               {"−", "-"},
                               {"–", "-"},
                               {"∕", "/"},
                               {"⁄", "/"},
                               {"\u00a0", " "},
                               {"\u202f", " "},
                               {"θ", "theta"},
                               {"ϑ", "theta"},
                               {"Θ", "theta"},
                               {"φ", "phi"},
                               {"ϕ", "phi"},
                               {"Φ", "phi"},
                               {"λ", "lambda"},
                               {"Λ", "lambda"},
                               {"ρ", "rho"},
                               {"π", "pi"},
                               {"σ", "sigma"},
                               {"β", "beta"},
                               {"ν", "nu"},
                               {"ω", "omega"},
                               {"Ω", "omega"},
                               {"Δ", "delta "},
                               {"δ", "delta"},
                               {"ψ", "psi"},
                               {"Ψ", "psi"},
                               {"τ", "tau"},
                               {"γ", "gamma"},
                               {"α", "alpha"},
                               {"ε", "epsilon"},
                               {"ᵢ", "i"},
                               {"ᵣ", "r"},
                               {"ₒ", "o"},
                               {"ₛ", "s"},
                               {"₀", "0"},
                               {"₁", "1"},
                               {"₂", "2"}};
constexpr Symbol kRaised[] = {{"⁻", "-"}, {"⁺", "+"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"}, {"³", "3"},
                              {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}};

template <std::size_t n>
const Symbol* symbol_at(std::string_view text, const Symbol (&symbols)[n]) {
  for (const Symbol& symbol : symbols)
    if (text.front() == symbol.sign.front() && text.starts_with(symbol.sign)) return &symbol;
  return nullptr;
}

}  // namespace

std::string plain_symbols(std::string_view text) {
  std::string plain;
  bool is_raised = false;
  while (!text.empty()) {
    // Most texts are ASCII throughout.
    const auto end = std::ranges::find_if(text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    const auto ascii = std::size_t(end - text.begin());
    plain += text.substr(0, ascii);
    text.remove_prefix(ascii);
    if (text.empty()) break;
    is_raised = is_raised && ascii == 0;
    const Symbol* const raised = symbol_at(text, kRaised);
    const Symbol* const symbol = raised ? raised : symbol_at(text, kSymbols);
    if (raised && !is_raised) plain += '^';
    is_raised = raised;
    plain += symbol ? symbol->plain : text.substr(0, 1);
    text.remove_prefix(symbol ? symbol->sign.size() : 1);
  }
  return plain;
}

std::vector<NameAndUnit> ways_to_part(std::string_view name) {
  std::vector<NameAndUnit> ways{{name, ""}};
  if (!name.empty() && (name.back() == ')' || name.back() == ']')) {
    const std::size_t open = name.find_last_of("([");
    if (open != name.npos && open > 0)
      ways.push_back({trimmed(name.substr(0, open)), trimmed(name.substr(open + 1, name.size() - open - 2))});
  }
  if (const std::size_t at = name.find_last_of("/, _"); at != name.npos && at > 0 && at + 1 < name.size())
    ways.push_back({trimmed(name.substr(0, at)), trimmed(name.substr(at + 1))});
  return ways;
}

std::optional<Unit> unit_named(std::string_view text) {
  constexpr std::size_t kLongest = 200;  // bytes; a longer text is no unit, and many may begin in one line
  if (text.size() > kLongest) return std::nullopt;
  const std::string plain = plain_symbols(text);
  return UnitReader(plain).read();
}

Unit::Kind Unit::kind() const {
  const auto is = [&](std::initializer_list<Power> powers) {
    return exponents == product(1, powers).exponents;
  };
  if (is({})) return is_percent ? Kind::percent : Kind::number;
  if (is({{steradian, -1}})) return Kind::per_steradian;
  if (is({{radian, 1}})) return Kind::angle;
  if (is({{metre, 1}})) return Kind::length;
  if (is({{metre, -1}})) return Kind::wavenumber;
  if (is({{second, -1}})) return Kind::frequency;
  if (is({{electronvolt, 1}})) return Kind::energy;
  if (is({{metre, 2}}) || is({{steradian, 1}})) return Kind::area;
  for (const Base flux : {watt, lumen})
    for (const int spectral : {0, -1}) {
      const Kind surface = flux == watt ? Kind::radiance : Kind::luminance;
      if (is({{flux, 1}, {steradian, -1}, {metre, spectral - 2}})) return surface;
      if (is({{flux, 1}, {steradian, -1}, {metre, spectral}})) return Kind::intensity;
      if (is({{flux, 1}, {metre, spectral}}) || is({{flux, 1}, {metre, spectral - 2}})) return Kind::signal;
    }
  if (is({{volt, 1}}) || is({{ampere, 1}}) || is({{count, 1}}) || is({{count, 1}, {second, -1}}))
    return Kind::signal;
  return Kind::other;
}

}  // namespace brdf::io
