#include "io/formats/bands.h"

#include <cmath>
#include <utility>

#include "io/columns/wavelengths.h"
#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::io {

SampleTable all_bands(SampleTable narrow, std::vector<Band> bands) {
  const std::size_t incomplete = leave_out_incomplete(narrow, bands);
  if (narrow.rows() == 0)
    throw InputError(narrow.name() +
                     ": no pair of directions has a value in every band (wavelength and polarisation): write "
                     "one file for each band");
  if (incomplete > 0) {
    narrow.skipped += incomplete;
    narrow.assume(plural(incomplete, "pair") + " of directions left out: not measured in every band");
  }
  return widened(narrow, bands);
}

double wavelength_in_nm(double metres) {
  constexpr double kNmPerMetre = 1e9, kPerNm = 1000;
  return without_noise(std::round(metres * kNmPerMetre * kPerNm) / kPerNm);
}

}  // namespace brdf::io
