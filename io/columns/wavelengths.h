// Reads wavelengths in the units that laboratories use: lengths, wavenumbers, frequencies, photon energies.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/columns/units.h"

namespace brdf::io {

// A column of wavelengths. `unit` is empty if the column's name states no unit; the numbers are then
// micrometres or nm.
struct WavelengthColumn {
  std::optional<Unit> unit;
  std::string fault;  // the reason against reading the column, as the end of a sentence
};

// Interprets a column's name: `wavelength`, `lambda`, `wl` with or without a unit; `wavenumber`; `nu`,
// `frequency`, `energy` with a unit. Returns std::nullopt for other names.
std::optional<WavelengthColumn> wavelength_column(std::string_view name);
// Returns whether the name is one of a column of wavelengths.
bool is_wavelength_name(std::string_view name);

// Returns whether the unit is one of wavelengths, wavenumbers, frequencies or photon energies.
bool is_of_light(const Unit& unit);

// Returns whether wavelengths without a unit are micrometres, that is, whether the largest is below 100, as
// in tables of n and k.
bool are_micrometres(double largest);

// Converts a number in this unit to nm, rounded to the picometre because reciprocals add rounding noise
// beyond that.
double to_nm(double number, const Unit& unit);
// Removes the rounding noise of a conversion from a number of nm: 905.000001 becomes 905.
double without_noise(double nm);

// Returns the wavelength, in nm, at the end of a name: 465nm, fr_465.5 nm, 0.55um, 5500 angstrom. Returns
// std::nullopt if the name does not end in a wavelength.
std::optional<double> wavelength_of(std::string_view channel);

// Adds the unit to a name that is only the number of a wavelength, from 100 to 100,000 nm: 400 becomes
// 400nm. Other names stay unchanged.
std::string with_band_unit(std::string_view name);

}  // namespace brdf::io
