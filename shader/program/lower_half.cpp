// Half precision: which results are rounded, and constants of 16 bits.
#include <algorithm>
#include <cmath>
#include <glslang/SPIRV/spirv.hpp>

#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/program/half.h"
#include "shader/program/lowering.h"

namespace brdf::shader {

// Returns whether the result of the operation on numbers of half precision may need more bits. The geometric
// functions consist of several operations, and each of them is rounded.
bool Lowering::needs_rounding(Op op) {
  switch (op) {
    case Op::copy:
    case Op::neg:
    case Op::abs:
    case Op::sign:
    case Op::floor:
    case Op::ceil:
    case Op::trunc:
    case Op::round:
    case Op::round_even:
    case Op::min:
    case Op::max:
    case Op::step:
    case Op::to_half:
      return false;
    default:
      return op < Op::select;
  }
}

bool Lowering::is_narrow_result(Id value, Id type) const {
  return (options_.halves != Halves::none && module_.is_half(type)) ||
         (options_.halves == Halves::allowed && module_.relaxed.contains(value));
}

// A variable that is relaxed relaxes the values that are loaded from it.
bool Lowering::is_narrow(const spirv::Instruction& i) const {
  if (i.type == 0) return false;
  return is_narrow_result(i.result, i.type) ||
         (i.code == spv::OpLoad && !i.words.empty() && is_narrow_result(i.words[0], i.type));
}

Slot Lowering::to_half(Slot slot) {
  if (halves_.contains(slot)) return slot;
  const Slot rounded = emit(Op::to_half, slot);
  halves_.insert(rounded);
  return rounded;
}

Slots Lowering::to_half(Slots slots, Id type) {
  if (slots.empty()) return slots;  // of a function without a value
  const std::vector<bool>& integer = kinds(type);
  for (std::size_t k = 0; k < std::min(slots.size(), integer.size()); ++k)
    if (!integer[k]) slots[k] = to_half(slots[k]);
  return slots;
}

// An input of a 16-bit type is rounded before the program begins.
Slot Lowering::half_input(Slot slot) {
  const Slot rounded = program_.numbers++;
  prelude_.push_back({Op::to_half, rounded, slot});
  halves_.insert(rounded);
  return rounded;
}

// Programs that do not round to half precision use the shortest decimal number that rounds to the constant,
// as for constants of 32 bits.
Slot Lowering::half_constant(std::uint32_t bits) {
  const double value = half_of_bits(std::uint16_t(bits));
  if (options_.halves != Halves::none || !std::isfinite(value)) {
    const Slot slot = number_constant(value);
    halves_.insert(slot);
    return slot;
  }
  for (int digits = 1; digits < 6; ++digits) {
    double decimal = 0;
    if (io::parse_number(io::short_number(value, digits), decimal) &&
        rounded_to_half(float(decimal)) == float(value))
      return number_constant(decimal);
  }
  return number_constant(value);
}

std::optional<std::uint32_t> first_half(const Program& program) {
  std::optional<std::uint32_t> line;
  for (const Stretch& stretch : program.stretches)
    for (const Step& step : stretch.steps)
      if (step.op == Op::to_half && (!line || *line == 0 || (step.line > 0 && step.line < *line)))
        line = step.line;
  return line;
}

}  // namespace brdf::shader
