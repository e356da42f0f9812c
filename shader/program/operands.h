// What each operation reads and writes.
#pragma once

#include "shader/program/program.h"

namespace brdf::shader {

struct Operands {
  int count = 0;         // slots a, b, c that are read
  bool integer[3] = {};  // of each
  bool result_integer = false;
  bool indexed_load = false, indexed_store = false;  // slots a to a + c - 1 are read, r to r + c - 1 written

  std::uint32_t writes(const Step& step) const { return indexed_store ? step.c : 1; }
};

constexpr Operands operands_of(Op op) {
  if (op == Op::select) return {3, {true, false, false}};
  if (op <= Op::select) {
    const bool three = op == Op::clamp || op == Op::mix || op == Op::smoothstep || op == Op::fma;
    const bool two = op == Op::add || op == Op::sub || op == Op::mul || op == Op::div || op == Op::mod ||
                     op == Op::rem || op == Op::pow || op == Op::atan2 || op == Op::min || op == Op::max ||
                     op == Op::step || op == Op::log1p || op == Op::angle;
    return {three ? 3 : two ? 2 : 1, {}};
  }
  if (op <= Op::bits_of) return {op <= Op::less_equal_or ? 2 : 1, {}, true};
  if (op <= Op::from_bits) return {1, {true}};
  if (op == Op::iselect) return {3, {true, true, true}, true};
  if (op <= Op::logical_not) {
    const bool one = op == Op::icopy || op == Op::ineg || op == Op::inot || op == Op::iabs ||
                     op == Op::isign || op == Op::logical_not;
    return {one ? 1 : 2, {true, true}, true};
  }
  if (op == Op::load_number) return {2, {false, true}, false, true};
  if (op == Op::load_integer) return {2, {true, true}, true, true};
  if (op == Op::store_number) return {2, {false, true}, false, false, true};
  return {2, {true, true}, true, false, true};
}

}  // namespace brdf::shader
