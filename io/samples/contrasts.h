// Contrasts: sums of the logarithms of a few values, with weights that add to 0 and whose squares add to 1.
// What varies slowly from row to row leaves them, noise stays: values that scatter by s, relative, give
// contrasts that scatter by s.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/samples/samples.h"

namespace brdf::io {

// Divided differences up to this order: a polynomial of a lower degree along the scan leaves nothing in them.
inline constexpr std::size_t kMostOrder = 6;

struct Contrast {
  std::array<std::uint32_t, kMostOrder + 1> rows;
  std::array<double, kMostOrder + 1> weights;
  std::size_t count = 0;
};

// How rows are put beside each other: along scans of one angle, the others being equal, and in pairs that a
// symmetry makes equal.
enum class Neighbours {
  repeated,      // rows of the same directions, two by two
  viewer_polar,  // through the normal
  viewer_azimuth,
  light_polar,
  light_azimuth,
  turn,        // of the sample: equal at once where it is isotropic
  mirrored,    // both sides of the plane of incidence: equal where the sample is isotropic
  reciprocal,  // light and viewer exchanged
  half_polar,  // theta_h, with theta_d and phi_d equal: the grid of MERL's files
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
  // Of these rows of the table, which must outlive this.
  Contrasts(const SampleTable& table, std::span<const std::uint32_t> rows);

  using Use = std::function<void(std::size_t order, const Contrast&)>;
  // Calls use(order, contrast) for every order that the scans are long enough for; a pair is of order 1, the
  // difference of neighbouring pairs of order 2. Rows that repeat directions and values are copies, no pair.
  // At most about `most` rows are used, whole scans of them. Which ones, and which of several rows of the
  // same directions, follows from angles and values alone, not from the order of rows.
  void for_each(Neighbours neighbours, std::size_t most, const Use& use);

 private:
  struct Place;
  // Angles in whole thousandths of a degree: 10.0 and 9.9999999 are one.
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
  std::vector<HalfDifference> half_;  // made where it is asked for
};

}  // namespace brdf::io
