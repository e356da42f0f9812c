// Reads units as the names of columns state them: 1/sr, cd/m2/lx, 10^-3 sr^-1, W m^-2 sr^-1, cm-1, GHz,
// degrees Celsius, dB.
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
    per_steradian,  // also units equal to 1/sr, such as cd/m2/lx
    angle,
    length,
    wavenumber,
    frequency,
    energy,
    radiance,   // W/m2/sr
    luminance,  // cd/m2
    intensity,  // W/sr, cd
    signal,     // volts, amperes, watts, counts, irradiances
    area,       // also a solid angle: a cross section
    other       // degrees Celsius, seconds, ...
  };

  // The size of this unit as a multiple of the product of the base units.
  double factor = 1;
  std::array<int, 12> exponents{};
  bool is_decibel = false, is_percent = false;

  bool operator==(const Unit&) const = default;
  // Returns the kind of quantity that the unit measures.
  Kind kind() const;
};

// Replaces letters of other alphabets and signs by ASCII, with which units and formulas are written. The
// micro sign becomes u, A with ring becomes angstrom, raised digits and signs become exponents (sr^-1), the
// centred dot and the multiplication sign become *, and Greek letters become their names. The degree sign
// is kept.
std::string plain_symbols(std::string_view text);

// A name and its unit. The unit is in brackets, after a slash or a comma, or the last word.
struct NameAndUnit {
  std::string_view name, unit;
};
// Returns every way to separate a unit from a name, the whole name first.
std::vector<NameAndUnit> ways_to_part(std::string_view name);

// Reads a product of units with exponents. Returns std::nullopt if a word is not a unit, or if the text is
// empty.
std::optional<Unit> unit_named(std::string_view text);

}  // namespace brdf::io
