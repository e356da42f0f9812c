// The columns of angles as a file holds them: evidence for their unit, before a reader applies units, signs
// or conventions.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace brdf::io {

inline constexpr std::size_t kMostRawMagnitudes = 1000;

// One of the four angles. All members are empty if the format has no column for the angle.
struct RawAngle {
  std::string name;       // name of the column, as in the file
  bool has_unit = false;  // the file states the unit
  double largest = 0;     // largest absolute value of all cells
  std::vector<double>
      magnitudes;  // absolute values of the cells, each once: the first kMostRawMagnitudes of them
};

// In the order theta_i, phi_i, theta_o, phi_o.
using RawAngles = std::array<RawAngle, 4>;

// Collects the cells of one column in some nanoseconds per cell, because tables have millions of rows but
// few distinct angles.
class RawMagnitudes {
 public:
  void add(double cell) {
    const double size = std::abs(cell);
    if (size == last_) return;
    last_ = size;
    if (size > largest_) largest_ = size;
    if (found_.size() < kMostRawMagnitudes) keep(size);
  }

  void store(RawAngle& angle) && {
    angle.largest = largest_;
    angle.magnitudes = std::move(found_);
  }

 private:
  // An open hash table that is never more than half full.
  static constexpr std::size_t kSlots = 2048;

  void keep(double size) {
    if (slots_.empty()) slots_.assign(kSlots, -1.0);
    const std::uint64_t mixed = std::bit_cast<std::uint64_t>(size) * 0x9E3779B97F4A7C15u;
    std::size_t at = mixed >> 53;
    while (slots_[at] >= 0 && slots_[at] != size) at = (at + 1) % kSlots;
    if (slots_[at] == size) return;
    slots_[at] = size;
    found_.push_back(size);
  }

  double last_ = -1, largest_ = 0;
  std::vector<double> slots_, found_;
};

}  // namespace brdf::io
