// The long format: one row for each wavelength, or polarisation, of each pair of directions.
#pragma once

#include <optional>
#include <vector>

#include "io/samples/polarisation.h"
#include "io/samples/samples.h"

namespace brdf::io {

// What a row of the long format was measured in.
struct Band {
  double nm = 0;  // 0 where the table has no wavelengths
  std::optional<Polarisation> polarisation;

  auto operator<=>(const Band&) const = default;
};

// The same samples with a channel for each band (one for each row of `narrow`, whose one channel holds the
// values): `465nm`, `fr_s`, `s_465nm`, sorted, the pairs of directions in the order of their first rows.
// Pairs that were measured more than once, in all their bands, keep as many rows. A table of mere directions
// keeps each pair once. Throws InputError where a pair lacks a band or has one more often than another,
// naming the row.
SampleTable widened(const SampleTable& narrow, const std::vector<Band>& bands);

}  // namespace brdf::io
