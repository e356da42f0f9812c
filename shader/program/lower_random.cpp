// Random numbers as inputs, and functions with several results: samplers of directions.
#include <algorithm>

#include "shader/program/lowering.h"

namespace brdf::shader {

// The count is kept in a slot and not in the text's order of calls, because a loop or a branch decides how
// many numbers a run uses.
void Lowering::begin_random() {
  Input input{kRandomInput, "float[" + std::to_string(kMostRandom) + "]"};
  random_ = program_.numbers;
  program_.numbers += kMostRandom;
  for (Slot k = 0; k < kMostRandom; ++k) input.slots.push_back(random_ + k);
  program_.inputs.push_back(std::move(input));
  random_count_ = program_.integers++;
  emit_to(Op::icopy, random_count_, integer_constant(0));
}

Slot Lowering::next_random() {
  // The count changes, so its operations must not be found again as computed before.
  const Slot at = program_.integers++, next = program_.integers++, value = program_.numbers++;
  emit_to(Op::umin, at, random_count_, integer_constant(kMostRandom - 1));
  emit_to(Op::load_number, value, random_, at, kMostRandom);
  emit_to(Op::iadd, next, random_count_, integer_constant(1));
  emit_to(Op::icopy, random_count_, next);
  return value;
}

Slots Lowering::random_value(const spirv::Function& function) {
  Slots out;
  for (const bool integer : kinds(function.type)) {
    const Slot number = next_random();
    // An integer from a generator has 32 random bits.
    out.push_back(integer ? emit(Op::to_unsigned, emit(Op::mul, number, number_constant(0x1p32))) : number);
  }
  return out;
}

Slots Lowering::results_apart(const spirv::Function& entry, const Slots& returned,
                              const std::map<int, Pointer>& written) {
  Slots out;
  for (const ResultPart& part : options_.results) {
    const auto [all, type] = written_value(part.argument, entry, returned, written);
    const std::vector<bool> integer = kinds(type);
    if (part.first + part.count > all.size()) refuse("a result has two types");
    for (std::size_t k = part.first; k < part.first + part.count; ++k)
      out.push_back(integer[k] ? emit(Op::from_unsigned, all[k]) : all[k]);
  }
  if (!options_.random.empty()) {
    const Slot used = program_.numbers++;
    emit_to(Op::from_unsigned, used, random_count_);
    out.push_back(used);
  }
  return out;
}

}  // namespace brdf::shader
