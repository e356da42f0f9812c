// Units as the names of columns state them: 1/sr, cd/m2/lx, 10^-3 sr^-1, W m^-2 sr^-1, cm-1, GHz, °C, dB.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

struct Unit {
  enum Base {
    metre,
    second,
    steradian,
    radian,
    lumen,
    watt,
    ampere,
    volt,
    kelvin,
    electronvolt,
    count,
    pascal
  };
  enum class Kind {
    number,         // no unit, or a power of ten
    percent,        // also parts per million
    per_steradian,  // also cd/m2/lx and the like, which are 1/sr
    angle,
    length,
    wavenumber,
    frequency,
    energy,
    radiance,   // W/m2/sr
    luminance,  // cd/m2
    intensity,  // W/sr, cd
    signal,     // volts, amperes, watts, counts, irradiances
    area,       // also as a solid angle: a cross section
    other       // degrees Celsius, seconds, ...
  };

  double factor = 1;  // one of this unit in the product of the bases
  std::array<int, 12> exponents{};
  bool is_decibel = false, is_percent = false;

  bool operator==(const Unit&) const = default;
  Kind kind() const;
};

// Letters of other alphabets and signs as ASCII that units and formulas are written with: µ u, Å angstrom,
// sr⁻¹ sr^-1, · and × *, π pi. Greek letters become their names.
std::string plain_symbols(std::string_view text);

// A name and its unit, which stands in brackets, behind a slash or a comma, or as the last word: every way to
// part them, the whole name first.
struct NameAndUnit {
  std::string_view name, unit;
};
std::vector<NameAndUnit> ways_to_part(std::string_view name);

// Reads a product of units with exponents; std::nullopt if a word is not a unit. Nothing at all is not a
// unit.
std::optional<Unit> unit_named(std::string_view text);

}  // namespace brdf::io
