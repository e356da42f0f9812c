// Constants, variables, pointers and composites, which cost no operations in a flattened program.
#include <algorithm>
#include <bit>
#include <charconv>

#include <glslang/SPIRV/spirv.hpp>

#include "shader/program/lowering.h"

namespace brdf::shader {
namespace {

using spirv::Kind;

// Returns, in double, the shortest decimal number that rounds to this float. This is the number that the
// source contains; all scalars other than float use it.
double as_written(std::uint32_t bits) {
  const float value = std::bit_cast<float>(bits);
  char digits[32];
  const char* end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  double wide = value;
  std::from_chars(digits, end, wide);
  return wide;
}

}  // namespace

const std::vector<bool>& Lowering::kinds(Id type) {
  const auto [at, fresh] = kinds_.try_emplace(type);
  if (!fresh) return at->second;
  const spirv::Type& t = module_.type(type);
  const std::size_t size = module_.scalars(type);
  std::vector<bool> out;
  if (t.kind == Kind::structure) {
    for (const Id m : t.members) {
      const std::vector<bool>& inner = kinds(m);
      out.insert(out.end(), inner.begin(), inner.end());
    }
  } else if (t.kind == Kind::vector || t.kind == Kind::matrix || t.kind == Kind::array) {
    const std::vector<bool> inner = kinds(t.element);
    while (out.size() < size) out.insert(out.end(), inner.begin(), inner.end());
  } else {
    out.push_back(t.kind != Kind::number);
  }
  return kinds_[type] = std::move(out);
}

Lowering::Variable& Lowering::new_variable(Id type) {
  Variable& v = *variables_.emplace_back(std::make_unique<Variable>());
  v.integer = kinds(type);
  v.numbers = program_.numbers;
  v.integers = program_.integers;
  const bool some = std::ranges::find(v.integer, true) != v.integer.end(),
             all = std::ranges::find(v.integer, false) == v.integer.end();
  if (!all) program_.numbers += Slot(v.integer.size());
  if (some) program_.integers += Slot(v.integer.size());
  return v;
}

// Declares the variable as an input, with one Input for each number, vector or member of a struct.
void Lowering::make_input(Variable& variable, Id type, const std::string& name, int argument,
                          std::size_t offset) {
  const spirv::Type& t = module_.type(type);
  if (t.kind == Kind::structure) {
    const auto names = module_.member_names.find(type);
    for (std::size_t k = 0; k < t.members.size(); ++k) {
      const auto found = names == module_.member_names.end() ? decltype(names->second.end()){}
                                                             : names->second.find(std::uint32_t(k));
      const std::string member = names != module_.member_names.end() && found != names->second.end()
                                     ? found->second
                                     : std::to_string(k);
      make_input(variable, t.members[k], name.empty() ? member : name + "." + member, argument, offset);
      offset += module_.scalars(t.members[k]);
    }
    return;
  }
  const std::size_t count = module_.scalars(type);
  for (std::size_t k = 1; k < count; ++k)
    if (variable.integer[offset + k] != variable.integer[offset])
      refuse(name + " is " + module_.spelled(type) + ": parameters must be numbers or vectors");
  Input input{name, module_.spelled(type), {}, variable.integer[offset], argument};
  for (std::size_t k = 0; k < count; ++k) {
    const Slot slot = variable.integer[offset + k] ? program_.integers++ : program_.numbers++;
    input.slots.push_back(slot);
    remember(variable, offset + k, is_narrow_result(0, type) ? half_input(slot) : slot, false);
  }
  program_.inputs.push_back(std::move(input));
}

Lowering::Variable& Lowering::global_variable(Id id) {
  if (const auto found = globals_.find(id); found != globals_.end()) return *found->second;
  const auto found = module_.globals.find(id);
  if (found == module_.globals.end() || !found->second.variable) refuse("a variable is not declared");
  const spirv::Instruction& i = found->second.instruction;
  const spirv::Type& pointer = module_.type(i.type);
  const std::string name = module_.name(id);
  if (pointer.kind != Kind::pointer) refuse("a pointer is not a variable");
  if (is_opaque(pointer.element))
    refuse("reads " + name + ", which is no single texture; use a parameter for its value");
  Variable& v = new_variable(pointer.element);
  globals_[id] = &v;
  if (pointer.storage == spv::StorageClassUniformConstant || pointer.storage == spv::StorageClassUniform ||
      pointer.storage == spv::StorageClassPushConstant || pointer.storage == spv::StorageClassInput) {
    make_input(v, pointer.element, name, -1);
  } else if (i.words.size() > 1) {
    const Slots initial = constant(i.words[1]);
    if (initial.size() != v.integer.size()) refuse("a value has two types");
    for (std::size_t k = 0; k < initial.size(); ++k) remember(v, k, initial[k], false);
  } else {
    options_.zero_globals ? set_zero(v) : clear(v);
  }
  // The first access may be in a branch or a loop, so that the program's first steps set the variable.
  for (const std::size_t k : v.unwritten)
    prelude_.push_back(
        {v.integer[k] ? Op::icopy : Op::copy, (v.integer[k] ? v.integers : v.numbers) + Slot(k), v.known[k]});
  v.unwritten.clear();
  return v;
}

Slot Lowering::number_constant(double value) {
  const auto [at, fresh] =
      number_constants_.try_emplace(std::bit_cast<std::uint64_t>(value), program_.numbers);
  if (fresh) program_.constants.push_back({program_.numbers++, value});
  return at->second;
}

Slot Lowering::integer_constant(std::uint32_t value) {
  const auto [at, fresh] = integer_constants_.try_emplace(value, program_.integers);
  if (fresh) program_.integer_constants.push_back({program_.integers++, value});
  return at->second;
}

Slots Lowering::constant(Id id) {
  const auto found = module_.globals.find(id);
  if (found == module_.globals.end() || found->second.variable) refuse("a value is not defined");
  const spirv::Instruction& i = found->second.instruction;
  const auto word = [&](std::size_t k) {
    if (k >= i.words.size()) refuse("a constant is incomplete");
    return i.words[k];
  };
  Slots out;
  switch (i.code) {
    case spv::OpConstantTrue:
    case spv::OpSpecConstantTrue:
      return {integer_constant(1)};
    case spv::OpConstantFalse:
    case spv::OpSpecConstantFalse:
      return {integer_constant(0)};
    case spv::OpConstant:
    case spv::OpSpecConstant:
      if (kinds(i.type).size() != 1) refuse("a constant is not a number");
      if (kinds(i.type)[0]) return {integer_constant(word(0))};
      return {module_.is_half(i.type) ? half_constant(word(0)) : number_constant(as_written(word(0)))};
    case spv::OpConstantComposite:
    case spv::OpSpecConstantComposite:
      for (const Id part : i.words) {
        // Parts are declared earlier, with smaller numbers.
        if (part >= id) refuse("a constant contains itself");
        const Slots inner = constant(part);
        out.insert(out.end(), inner.begin(), inner.end());
      }
      break;
    case spv::OpConstantNull:
      for (const bool integer : kinds(i.type))
        out.push_back(integer ? integer_constant(0) : number_constant(0));
      break;
    case spv::OpUndef:
      out = undefined_value(i.type, Unset::no_return);
      break;
    default:
      refuse("has a specialisation constant that is computed by the driver");
  }
  if (out.size() != module_.scalars(i.type)) refuse("a value has two types");
  return out;
}

Slots Lowering::value(Frame& frame, Id id) {
  const auto operand = [&](Slots slots) {
    return narrow_ ? to_half(std::move(slots), type_of(frame, id)) : slots;
  };
  if (const auto found = frame.values.find(id); found != frame.values.end())
    return operand(found->second.second);
  if (const auto found = module_.globals.find(id); found != module_.globals.end() && found->second.variable)
    refuse("uses a pointer or a texture as a value");
  return operand(constant(id));
}

Id Lowering::type_of(Frame& frame, Id id) {
  if (const auto found = frame.values.find(id); found != frame.values.end()) return found->second.first;
  const auto found = module_.globals.find(id);
  if (found == module_.globals.end()) refuse("a value is not defined");
  return found->second.instruction.type;
}

Lowering::Pointer Lowering::pointer(Frame& frame, Id id) {
  if (const auto found = frame.pointers.find(id); found != frame.pointers.end()) return found->second;
  Variable& v = global_variable(id);
  return {&v, module_.type(module_.globals.at(id).instruction.type).element};
}

std::pair<std::size_t, Id> Lowering::part(Id type, std::span<const std::uint32_t> path) {
  std::size_t offset = 0;
  for (const std::uint32_t index : path) {
    const spirv::Type& t = module_.type(type);
    if (t.kind == Kind::structure) {
      if (index >= t.members.size()) refuse("a struct has no member of this number");
      for (std::size_t k = 0; k < index; ++k) offset += module_.scalars(t.members[k]);
      type = t.members[index];
    } else {
      if (t.element == 0 || t.kind == Kind::pointer || index >= t.count) refuse("an index is out of range");
      offset += index * module_.scalars(t.element);
      type = t.element;
    }
  }
  return {offset, type};
}

Lowering::Pointer Lowering::chain(Frame& frame, const spirv::Instruction& i) {
  if (i.words.empty()) refuse("a pointer is incomplete");
  Pointer p = pointer(frame, i.words[0]);
  for (std::size_t k = 1; k < i.words.size(); ++k) {
    const auto known = module_.globals.find(i.words[k]);
    const bool fixed = known != module_.globals.end() && known->second.instruction.code == spv::OpConstant;
    const spirv::Type& t = module_.type(p.type);
    if (fixed) {
      const std::uint32_t index = known->second.instruction.words.at(0);
      const auto [offset, type] = part(p.type, std::span(&index, 1));
      p.offset += offset;
      p.type = type;
      continue;
    }
    if (t.kind != Kind::vector && t.kind != Kind::matrix && t.kind != Kind::array)
      refuse("indexes a value without elements");
    // Outside the array the interpreter takes the last element; no language guarantees that.
    const Slot index = emit(Op::index, scalar(frame, i.words[k]), integer_constant(t.count - 1));
    const Slot by = emit(Op::imul, index, integer_constant(std::uint32_t(module_.scalars(t.element))));
    p.index = p.index ? emit(Op::iadd, *p.index, by) : by;
    p.type = t.element;
  }
  return p;
}

void Lowering::remember(Variable& variable, std::size_t k, Slot slot, bool written) {
  if (variable.known.empty()) touched_.push_back(&variable);
  variable.known[k] = slot;
  if (written)
    variable.unwritten.erase(k);
  else
    variable.unwritten.insert(k);
}

void Lowering::write_back(Variable& variable) {
  for (const std::size_t k : variable.unwritten) {
    const bool integer = variable.integer[k];
    emit_to(integer ? Op::icopy : Op::copy, (integer ? variable.integers : variable.numbers) + Slot(k),
            variable.known[k]);
  }
  variable.unwritten.clear();
}

Slots Lowering::load(const Pointer& from) {
  Variable& v = *from.to;
  const std::size_t size = module_.scalars(from.type);
  if (from.offset + size > v.integer.size()) refuse("reads beyond a variable");
  if (from.index) write_back(v);
  Slots out;
  for (std::size_t k = from.offset; k < from.offset + size; ++k) {
    const bool integer = v.integer[k];
    const Slot slot = (integer ? v.integers : v.numbers) + Slot(k);
    if (from.index) {
      out.push_back(
          emit(integer ? Op::load_integer : Op::load_number, slot, *from.index, Slot(v.integer.size() - k)));
      continue;
    }
    auto found = v.known.find(k);
    if (found == v.known.end()) {
      remember(v, k, emit(integer ? Op::icopy : Op::copy, slot), true);
      found = v.known.find(k);
    }
    out.push_back(found->second);
  }
  return out;
}

void Lowering::store(const Pointer& to, const Slots& value) {
  Variable& v = *to.to;
  if (value.size() != module_.scalars(to.type) || to.offset + value.size() > v.integer.size())
    refuse("writes beyond a variable");
  if (!to.index) {
    for (std::size_t k = 0; k < value.size(); ++k) remember(v, to.offset + k, value[k], false);
    return;
  }
  write_back(v);
  v.known.clear();
  for (std::size_t k = 0; k < value.size(); ++k) {
    const std::size_t at = to.offset + k;
    const bool integer = v.integer[at];
    emit_to(integer ? Op::store_integer : Op::store_number, (integer ? v.integers : v.numbers) + Slot(at),
            value[k], *to.index, Slot(v.integer.size() - at));
  }
}

Slot Lowering::undefined(bool integer, Unset why) {
  for (const Program::Undefined& u : program_.undefined)
    if (u.integer == integer && u.why == why) return u.slot;
  const Slot slot = integer ? program_.integers++ : program_.numbers++;
  program_.undefined.push_back({slot, integer, why});
  return slot;
}

Slots Lowering::undefined_value(Id type, Unset why) {
  Slots out;
  for (const bool integer : std::vector<bool>(kinds(type))) out.push_back(undefined(integer, why));
  return out;
}

// Assigns the slot for undefined values to each scalar, so that a run never reads a value that an earlier
// run left. For arrays with more than 1024 scalars, the slots themselves count as unwritten
// (shader/undefined.h).
void Lowering::clear(Variable& v, Unset why) {
  constexpr std::size_t kMost = 1024;
  for (std::size_t k = 0; k < v.integer.size() && v.integer.size() <= kMost; ++k)
    remember(v, k, undefined(v.integer[k], why), false);
}

void Lowering::set_zero(Variable& v) {
  for (std::size_t k = 0; k < v.integer.size(); ++k)
    remember(v, k, v.integer[k] ? integer_constant(0) : number_constant(0), false);
}

// Handles instructions that only rename scalars.
std::optional<Slots> Lowering::composite(Frame& frame, const spirv::Instruction& i) {
  const std::span<const std::uint32_t> words(i.words);
  const auto of = [&](std::size_t k) {
    if (k >= words.size()) refuse("an instruction is incomplete");
    return value(frame, words[k]);
  };
  Slots out;
  switch (i.code) {
    case spv::OpCompositeConstruct:
      for (std::size_t k = 0; k < words.size(); ++k) {
        const Slots inner = of(k);
        out.insert(out.end(), inner.begin(), inner.end());
      }
      return out;
    case spv::OpCompositeExtract: {
      const Slots whole = of(0);
      const auto [offset, type] = part(type_of(frame, words[0]), words.subspan(1));
      return Slots(whole.begin() + long(offset), whole.begin() + long(offset + module_.scalars(type)));
    }
    case spv::OpCompositeInsert: {
      const Slots object = of(0);
      out = of(1);
      const auto [offset, type] = part(type_of(frame, words[1]), words.subspan(2));
      if (object.size() != module_.scalars(type)) refuse("a value has two types");
      std::copy(object.begin(), object.end(), out.begin() + long(offset));
      return out;
    }
    case spv::OpVectorShuffle: {
      Slots both = of(0);
      const Slots second = of(1);
      both.insert(both.end(), second.begin(), second.end());
      for (const std::uint32_t k : words.subspan(2)) {
        if (k != 0xffffffff && k >= both.size()) refuse("an index is out of range");
        out.push_back(k == 0xffffffff ? undefined(kinds(i.type).at(0), Unset::variable) : both[k]);
      }
      return out;
    }
    case spv::OpCopyObject:
      return of(0);
    case spv::OpUndef:
      return undefined_value(i.type, Unset::no_return);
    default:
      return std::nullopt;
  }
}

}  // namespace brdf::shader
