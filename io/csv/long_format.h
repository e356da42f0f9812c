// Converts the long format, which has one row for each wavelength or polarisation of each pair of
// directions.
#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "io/samples/polarisation.h"
#include "io/samples/samples.h"

namespace brdf::io {

// The wavelength and the polarisation of a row of the long format.
struct Band {
  double nm = 0;  // 0 if the table has no wavelengths
  std::optional<Polarisation> polarisation;

  friend bool operator==(const Band&, const Band&) = default;
  friend std::partial_ordering operator<=>(const Band& a, const Band& b) {
    const auto rank = [](const Band& band) { return band.polarisation ? int(*band.polarisation) : -1; };
    const std::partial_ordering order = a.nm <=> b.nm;
    return order != 0 ? order : rank(a) <=> rank(b);
  }
};

// Returns the same samples with one channel for each band, sorted: `465nm`, `fr_s`, `s_465nm`. `narrow`:
// the table in the long format, with one channel. `bands`: the band of each row of `narrow`. Pairs of
// directions keep the order of their first rows. A pair that was measured several times, in all bands,
// keeps that number of rows. A table of directions only keeps each pair once. Throws InputError, which
// names the row, if a pair lacks a band or has one band more often than another.
SampleTable widened(const SampleTable& narrow, const std::vector<Band>& bands);

// Removes the rows of all pairs of directions that lack a band of another pair, or have one band more often
// than another. Returns the number of these pairs.
std::size_t leave_out_incomplete(SampleTable& narrow, std::vector<Band>& bands);

}  // namespace brdf::io
