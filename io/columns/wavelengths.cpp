#include "io/columns/wavelengths.h"

#include <algorithm>
#include <cmath>

#include "io/columns/angle_names.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

constexpr double kLight = 299792458;             // m/s
constexpr double kElectronvoltNm = 1239.841984;  // energy times wavelength of a photon

bool is_one_of(const std::string& key, std::initializer_list<const char*> words) {
  return std::ranges::find(words, key) != words.end();
}

std::optional<WavelengthColumn> column_of(std::string_view bare, std::string_view unit_text,
                                          bool has_brackets) {
  using K = Unit::Kind;
  const std::string key = plain_spelling(bare);
  const std::optional<Unit> unit = unit_named(unit_text);
  // Also matches centre wavelength and laser wavelength.
  const bool is_wave =
      key.ends_with("wavelength") ||
      is_one_of(key, {"wavelengths", "lambda", "wl", "wellenlänge", "wellenlaenge", "longueurd'onde"});
  if (!unit_text.empty() && !(unit && is_of_light(*unit))) {
    if (!is_wave || !has_brackets) return std::nullopt;
    return WavelengthColumn{std::nullopt,
                            "has the unit " + shown(unit_text) +
                                ", which is not a unit of wavelengths (nm, um, m, cm-1, GHz, THz, eV)"};
  }
  const auto is_unit = [&](K kind) { return unit && unit->kind() == kind; };
  if (is_wave) return WavelengthColumn{unit, ""};
  if (is_one_of(key, {"wavenumber", "wavenumbers", "wellenzahl"}) && (!unit || is_unit(K::wavenumber)))
    return WavelengthColumn{unit ? unit : unit_named("cm-1"), ""};
  if (is_one_of(key, {"nu", "nubar"}) && (is_unit(K::wavenumber) || is_unit(K::frequency)))
    return WavelengthColumn{unit, ""};
  if (is_one_of(key, {"frequency", "freq", "f", "frequenz"}) && is_unit(K::frequency))
    return WavelengthColumn{unit, ""};
  if (is_one_of(key, {"energy", "photonenergy", "e", "hnu"}) && is_unit(K::energy))
    return WavelengthColumn{unit, ""};
  if (is_one_of(key, {"frequency", "freq", "photonenergy"}) && unit_text.empty())
    return WavelengthColumn{std::nullopt, "has no unit: write the unit in brackets, as in 'frequency (THz)'"};
  return std::nullopt;
}

}  // namespace

bool is_of_light(const Unit& unit) {
  using K = Unit::Kind;
  const K kind = unit.kind();
  return kind == K::length || kind == K::wavenumber || kind == K::frequency || kind == K::energy;
}

std::optional<WavelengthColumn> wavelength_column(std::string_view name) {
  const bool has_brackets = name.ends_with(')') || name.ends_with(']');
  for (const auto& [bare, unit] : ways_to_part(name))
    if (auto column = column_of(bare, unit, has_brackets)) return column;
  return std::nullopt;
}

bool is_wavelength_name(std::string_view name) {
  return wavelength_column(name).has_value();
}

bool are_micrometres(double largest) {
  constexpr double kFewest = 100;
  return largest < kFewest;
}

double to_nm(double number, const Unit& unit) {
  const double picometres = [&] {
    switch (unit.kind()) {
      case Unit::Kind::wavenumber:
        return 1e12 / (number * unit.factor);
      case Unit::Kind::frequency:
        return 1e12 * kLight / (number * unit.factor);
      case Unit::Kind::energy:
        return 1e3 * kElectronvoltNm / (number * unit.factor);
      default:
        return number * (1e12 * unit.factor);
    }
  }();
  return std::round(picometres) / 1e3;
}

double without_noise(double nm) {
  constexpr double kNoise = 2e-6;
  const double rounded = std::round(1e3 * nm) / 1e3;
  return std::abs(rounded - nm) < kNoise ? rounded : nm;
}

namespace {

// Returns the wavelength in nm. A number in another unit must be a wavelength of light: "10 m" is not one.
std::optional<double> in_range(double number, const Unit& unit) {
  constexpr double kShortest = 10, kLongest = 1e5;  // nm
  if (unit.factor == 1e-9 && unit.kind() == Unit::Kind::length) return number;
  const double nm = to_nm(number, unit);
  if (nm >= kShortest && nm <= kLongest) return nm;
  return std::nullopt;
}

}  // namespace

std::optional<double> wavelength_of(std::string_view channel) {
  const std::string name = plain_symbols(channel);
  const std::string_view text = name;
  constexpr std::string_view kOfNumber = "0123456789.";
  const std::size_t last = text.find_last_of(kOfNumber);
  if (last == text.npos) return std::nullopt;
  // The last digit may belong to an exponent of the unit: 18000cm-1.
  for (std::size_t end = last + 1; end > 0;) {
    const std::size_t before = text.substr(0, end).find_last_not_of(kOfNumber);
    const std::size_t begin = before == text.npos ? 0 : before + 1;
    std::string_view unit_text = text.substr(end);
    while (!unit_text.empty() && (unit_text.front() == ' ' || unit_text.front() == '_'))
      unit_text.remove_prefix(1);
    const auto unit = unit_named(unit_text);
    const bool is_in_word = begin > 0 && ((text[begin - 1] >= 'a' && text[begin - 1] <= 'z') ||
                                          (text[begin - 1] >= 'A' && text[begin - 1] <= 'Z'));
    double number;
    if (unit && is_of_light(*unit) && !is_in_word && parse_number(text.substr(begin, end - begin), number) &&
        number > 0)
      return in_range(number, *unit);
    if (begin == 0 || unit) return std::nullopt;
    const std::size_t next = text.substr(0, begin).find_last_of(kOfNumber);
    if (next == text.npos) return std::nullopt;
    end = next + 1;
  }
  return std::nullopt;
}

std::string with_band_unit(std::string_view name) {
  double nm;
  const bool is_band = parse_number(name, nm) && nm >= 100 && nm <= 1e5;
  return std::string(name) + (is_band ? "nm" : "");
}

}  // namespace brdf::io
