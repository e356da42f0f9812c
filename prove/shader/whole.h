// The range of an integer or a truth in a box: 32-bit integers, read as signed.
#pragma once

#include <cstdint>
#include <limits>

#include "shader/program/program.h"

namespace brdf::prove {

struct Whole {
  std::int64_t lo = 0, hi = 0;

  static constexpr std::int64_t kLeast = std::numeric_limits<std::int32_t>::min(),
                                kMost = std::numeric_limits<std::int32_t>::max();
  static constexpr Whole any() { return {kLeast, kMost}; }
  static constexpr Whole truth() { return {0, 1}; }
  static constexpr Whole of_bits(std::uint32_t bits) { return {std::int32_t(bits), std::int32_t(bits)}; }

  bool known() const { return lo == hi; }
  std::uint32_t bits() const { return std::uint32_t(std::int32_t(lo)); }
  // Returns whether the number is the same when read as signed or as unsigned.
  bool not_negative() const { return lo >= 0; }
  friend bool operator==(const Whole&, const Whole&) = default;
};

constexpr Whole hull(const Whole& a, const Whole& b) {
  return {a.lo < b.lo ? a.lo : b.lo, a.hi > b.hi ? a.hi : b.hi};
}

// Encloses every value that an operation from integers to an integer can give; exact if the operands are
// known. Loads and stores are not supported.
Whole whole_op(shader::Op op, const Whole& a, const Whole& b, const Whole& c);

// Returns whether the language may leave the result undefined for some operands of these ranges.
bool may_be_undefined(shader::Op op, const Whole& a, const Whole& b);

}  // namespace brdf::prove
