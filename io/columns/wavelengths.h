// Wavelengths in the units that laboratories write: lengths, wavenumbers, frequencies, energies of photons.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/columns/units.h"

namespace brdf::io {

// A column of wavelengths. `unit` is empty if the column's name states no unit; then micrometres or nm.
struct WavelengthColumn {
  std::optional<Unit> unit;
  std::string fault;  // why it cannot be read, as the end of a sentence about the column
};

// What a column's name says: `wavelength`, `lambda`, `wl` with a unit or without; `wavenumber`; `nu`,
// `frequency`, `energy` with a unit. std::nullopt if the name is another one.
std::optional<WavelengthColumn> wavelength_column(std::string_view name);
bool is_wavelength_name(std::string_view name);

// Whether wavelengths without a unit are micrometres: if the largest is below 100, as in tables of n and k.
bool are_micrometres(double largest);

// A number in this unit as nm, to the picometre: reciprocals add noise behind it.
double to_nm(double number, const Unit& unit);
// A number of nm without the noise of a conversion: 905.000001 is 905.
double without_noise(double nm);

// In nm, of a name that ends in a wavelength: 465nm, fr_465.5 nm, 0.55um, 5500 Å.
std::optional<double> wavelength_of(std::string_view channel);

// A name that is nothing but a wavelength's number, from 100 to 100,000 nm, with its unit: 400 is 400nm. Any
// other name as it is.
std::string with_band_unit(std::string_view name);

}  // namespace brdf::io
