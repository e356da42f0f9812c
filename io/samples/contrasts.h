// Contrasts are weighted sums of the logarithms of a few values. The weights add to 0 and their squares add
// to 1. A shape that varies slowly from row to row cancels in a contrast, but noise does not: values with a
// relative standard deviation s give contrasts with the standard deviation s.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/samples/samples.h"

namespace brdf::io {

// The highest order of divided differences. A divided difference is 0 for a polynomial along the scan of a
// degree below its order.
inline constexpr std::size_t kMostOrder = 6;

// A contrast: the rows and their weights. Only the first `count` entries are used.
struct Contrast {
  std::array<std::uint32_t, kMostOrder + 1> rows;
  std::array<double, kMostOrder + 1> weights;
  std::size_t count = 0;
};

// How rows are selected as neighbours: along scans of one angle while the other angles are equal, and in
// pairs that a symmetry makes equal.
enum class Neighbours {
  repeated,      // pairs of rows of the same directions
  viewer_polar,  // through the normal
  viewer_azimuth,
  light_polar,
  light_azimuth,
  turn,        // rotation of the sample; equal values if the sample is isotropic
  mirrored,    // both sides of the plane of incidence; equal values if the sample is isotropic
  reciprocal,  // light and viewer exchanged
  half_polar,  // theta_h, with equal theta_d and phi_d: the grid of MERL's files
  difference_polar,
  difference_azimuth
};
inline constexpr std::array<Neighbours, 8> kOfInstruments{
    Neighbours::repeated,      Neighbours::viewer_polar, Neighbours::viewer_azimuth, Neighbours::light_polar,
    Neighbours::light_azimuth, Neighbours::turn,         Neighbours::mirrored,       Neighbours::reciprocal};
inline constexpr std::array<Neighbours, 3> kOfHalfVectors{
    Neighbours::half_polar, Neighbours::difference_polar, Neighbours::difference_azimuth};

class Contrasts {
 public:
  // Prepares the contrasts of these rows. The table and `rows` must outlive this object.
  Contrasts(const SampleTable& table, std::span<const std::uint32_t> rows);

  using Use = std::function<void(std::size_t order, const Contrast&)>;
  // Calls use(order, contrast) for every order for which the scans are long enough. A pair has order 1, the
  // difference of two neighbouring pairs order 2. Rows that repeat both directions and values are copies
  // and form no pair. At most about `most` rows are used, in whole scans. The choice of scans, and of one
  // among several rows of the same directions, depends only on the angles and values, not on the order of
  // rows.
  void for_each(Neighbours neighbours, std::size_t most, const Use& use);

 private:
  struct Place;
  // Angles in whole thousandths of a degree, so that 10.0 and 9.9999999 are the same.
  struct Units {
    std::int32_t theta_i, phi_i, theta_o, phi_o;
  };
  struct HalfDifference {
    std::int32_t half, difference, azimuth, turn;
  };

  bool place(std::size_t index, Neighbours neighbours, Place& p) const;
  bool place_by_half_vector(std::size_t index, Neighbours neighbours, Place& p) const;
  std::vector<Place> places(Neighbours neighbours, std::size_t most) const;
  std::vector<Place> one_each(std::span<const Place> sorted) const;
  std::vector<Place> two_each(std::span<const Place> sorted) const;
  std::uint64_t lot(std::uint32_t row) const;

  const SampleTable& table_;
  std::span<const std::uint32_t> rows_;
  std::vector<Units> units_;
  std::vector<HalfDifference> half_;  // computed on first use
};

}  // namespace brdf::io
