// Arithmetic, comparisons and conversions, component by component.
#include <glslang/SPIRV/spirv.hpp>

#include <algorithm>
#include <map>

#include "shader/program/lowering.h"

namespace brdf::shader {
namespace {

// Operations on one, two or three operands of the same size.
const std::map<std::uint32_t, Op>& plain_operations() {
  static const std::map<std::uint32_t, Op> map{{spv::OpFAdd, Op::add},
                                               {spv::OpFSub, Op::sub},
                                               {spv::OpFMul, Op::mul},
                                               {spv::OpFDiv, Op::div},
                                               {spv::OpFNegate, Op::neg},
                                               {spv::OpFMod, Op::mod},
                                               {spv::OpFRem, Op::rem},
                                               {spv::OpFOrdEqual, Op::equal},
                                               {spv::OpFUnordEqual, Op::equal},
                                               {spv::OpFOrdNotEqual, Op::not_equal},
                                               {spv::OpFUnordNotEqual, Op::not_equal_or},
                                               {spv::OpFOrdLessThan, Op::less},
                                               {spv::OpFUnordLessThan, Op::less_or},
                                               {spv::OpFOrdLessThanEqual, Op::less_equal},
                                               {spv::OpFUnordLessThanEqual, Op::less_equal_or},
                                               {spv::OpIsNan, Op::is_nan},
                                               {spv::OpIsInf, Op::is_inf},
                                               {spv::OpIAdd, Op::iadd},
                                               {spv::OpISub, Op::isub},
                                               {spv::OpIMul, Op::imul},
                                               {spv::OpSDiv, Op::sdiv},
                                               {spv::OpUDiv, Op::udiv},
                                               {spv::OpSMod, Op::smod},
                                               {spv::OpSRem, Op::srem},
                                               {spv::OpUMod, Op::umod},
                                               {spv::OpSNegate, Op::ineg},
                                               {spv::OpBitwiseAnd, Op::iand},
                                               {spv::OpBitwiseOr, Op::ior},
                                               {spv::OpBitwiseXor, Op::ixor},
                                               {spv::OpNot, Op::inot},
                                               {spv::OpShiftLeftLogical, Op::shl},
                                               {spv::OpShiftRightLogical, Op::shr},
                                               {spv::OpShiftRightArithmetic, Op::sar},
                                               {spv::OpIEqual, Op::ieq},
                                               {spv::OpINotEqual, Op::ine},
                                               {spv::OpSLessThan, Op::slt},
                                               {spv::OpSLessThanEqual, Op::sle},
                                               {spv::OpULessThan, Op::ult},
                                               {spv::OpULessThanEqual, Op::ule},
                                               {spv::OpLogicalAnd, Op::iand},
                                               {spv::OpLogicalOr, Op::ior},
                                               {spv::OpLogicalNot, Op::logical_not},
                                               {spv::OpLogicalEqual, Op::ieq},
                                               {spv::OpLogicalNotEqual, Op::ine},
                                               {spv::OpConvertFToS, Op::to_signed},
                                               {spv::OpConvertFToU, Op::to_unsigned},
                                               {spv::OpConvertSToF, Op::from_signed},
                                               {spv::OpConvertUToF, Op::from_unsigned}};
  return map;
}

// Comparisons that are replaced by others with the operands exchanged.
const std::map<std::uint32_t, Op>& exchanged_operations() {
  static const std::map<std::uint32_t, Op> map{{spv::OpFOrdGreaterThan, Op::less},
                                               {spv::OpFUnordGreaterThan, Op::less_or},
                                               {spv::OpFOrdGreaterThanEqual, Op::less_equal},
                                               {spv::OpFUnordGreaterThanEqual, Op::less_equal_or},
                                               {spv::OpSGreaterThan, Op::slt},
                                               {spv::OpSGreaterThanEqual, Op::sle},
                                               {spv::OpUGreaterThan, Op::ult},
                                               {spv::OpUGreaterThanEqual, Op::ule}};
  return map;
}

}  // namespace

void Lowering::instruction(Frame& frame, const spirv::Instruction& i) {
  const auto word = [&](std::size_t k) {
    if (k >= i.words.size()) refuse("an instruction is incomplete");
    return i.words[k];
  };
  if (passes_texture(frame, i)) return;
  switch (i.code) {
    case spv::OpNop:
    case spv::OpSelectionMerge:
    case spv::OpLoopMerge:
    case spv::OpImageTexelPointer:
      return;
    // The slots of a phi are written at the branches. If an edge is never taken, they may not exist yet.
    case spv::OpPhi: {
      Slots& slots = frame.values.try_emplace(i.result, i.type, Slots{}).first->second.second;
      if (slots.empty())
        for (const bool integer : std::vector<bool>(kinds(i.type)))
          slots.push_back(integer ? program_.integers++ : program_.numbers++);
      return;
    }
    case spv::OpVariable: {
      const Id type = module_.type(i.type).element;
      Variable& variable = new_variable(type);
      frame.pointers[i.result] = {&variable, type};
      if (i.words.size() > 1)
        store(frame.pointers[i.result], value(frame, i.words[1]));
      else
        clear(variable);
      return;
    }
    case spv::OpAccessChain:
    case spv::OpInBoundsAccessChain:
      frame.pointers[i.result] = chain(frame, i);
      return;
    case spv::OpStore: {
      const Slots slots = value(frame, word(1));
      return store(pointer(frame, word(0)), slots);
    }
    case spv::OpCopyMemory: {
      const Slots slots = load(pointer(frame, word(1)));
      return store(pointer(frame, word(0)), slots);
    }
    case spv::OpFunctionCall: {
      const auto called = module_.functions.find(word(0));
      if (called == module_.functions.end()) refuse("calls a function that does not exist");
      std::vector<Argument> arguments;
      for (std::size_t k = 1; k < i.words.size(); ++k) {
        const Id id = i.words[k];
        const auto global = module_.globals.find(id);
        if (k <= called->second.parameter_types.size() && is_opaque(called->second.parameter_types[k - 1]))
          arguments.push_back({.texture = texture_of(frame, id)});
        else if (frame.pointers.contains(id) || (global != module_.globals.end() && global->second.variable))
          arguments.push_back({.pointer = pointer(frame, id)});
        else
          arguments.push_back({.slots = value(frame, id)});
      }
      const std::uint32_t line = line_;
      Slots returned = call(called->second, arguments);
      line_ = line;
      frame.values[i.result] = {i.type, is_narrow(i) ? to_half(std::move(returned), i.type) : returned};
      return;
    }
    default:
      break;
  }
  if (i.result == 0)
    refuse("writes to an image, a buffer or another pixel; a reflectance may only return a value");
  narrow_ = is_narrow(i);
  Slots out = operation(frame, i);
  if (narrow_) out = to_half(std::move(out), i.type);
  narrow_ = false;
  if (out.size() != module_.scalars(i.type)) refuse("a value has two types");
  frame.values[i.result] = {i.type, std::move(out)};
}

Slots Lowering::operation(Frame& frame, const spirv::Instruction& i) {
  if (auto renamed = composite(frame, i)) return *renamed;
  const auto of = [&](std::size_t k) {
    if (k >= i.words.size()) refuse("an instruction is incomplete");
    return value(frame, i.words[k]);
  };
  const auto binary = [&](Op op, const Slots& a, const Slots& b) {
    if (a.size() != b.size()) refuse("a value has two types");
    Slots out;
    for (std::size_t k = 0; k < a.size(); ++k) out.push_back(emit(op, a[k], b[k]));
    return out;
  };
  if (const auto plain = plain_operations().find(i.code); plain != plain_operations().end()) {
    if (i.words.size() == 1) {
      Slots out;
      for (const Slot a : of(0)) out.push_back(emit(plain->second, a));
      return out;
    }
    return binary(plain->second, of(0), of(1));
  }
  if (const auto other = exchanged_operations().find(i.code); other != exchanged_operations().end())
    return binary(other->second, of(1), of(0));
  switch (i.code) {
    case spv::OpLoad:
      return load(pointer(frame, i.words.at(0)));
    case spv::OpExtInst:
      return function(frame, i);
    case spv::OpDot:
      return {dot(of(0), of(1))};
    case spv::OpVectorTimesScalar:
    case spv::OpMatrixTimesScalar:
      return scaled(of(0), of(1).at(0));
    case spv::OpSelect:
      return select(frame, i);
    case spv::OpBitcast:
    case spv::OpFConvert:
    case spv::OpSConvert:
    case spv::OpUConvert:
      return convert(frame, i);
    case spv::OpAny:
    case spv::OpAll: {
      const Slots a = of(0);
      Slot out = a.at(0);
      for (std::size_t k = 1; k < a.size(); ++k)
        out = emit(i.code == spv::OpAny ? Op::ior : Op::iand, out, a[k]);
      return {out};
    }
    case spv::OpVectorExtractDynamic: {  // through memory
      const Id type = type_of(frame, i.words.at(0));
      Variable& variable = new_variable(type);
      store({&variable, type}, of(0));
      const Slot index = emit(Op::index, of(1).at(0), integer_constant(module_.type(type).count - 1));
      return load({&variable, i.type, 0, index});
    }
    case spv::OpQuantizeToF16:
      refuse("rounds to half precision, which is not supported");
    case spv::OpDPdx:
    case spv::OpDPdy:
    case spv::OpFwidth:
      refuse("uses screen-space derivatives; a reflectance depends on directions and parameters only");
    default:
      break;
  }
  if (const auto texels = read_texture(frame, i)) return *texels;
  if (i.code >= spv::OpSampledImage && i.code <= spv::OpImageQuerySamples)
    refuse(
        "reads a texture in a way that is not supported: texture, textureLod, texelFetch, Sample, "
        "SampleLevel and Load are");
  return matrix(frame, i);
}

Slots Lowering::matrix(Frame& frame, const spirv::Instruction& i) {
  const auto operand = [&](std::size_t k, std::size_t& rows) {
    if (k >= i.words.size()) refuse("an instruction is incomplete");
    const spirv::Type& type = module_.type(type_of(frame, i.words[k]));
    rows = type.kind == spirv::Kind::matrix ? module_.scalars(type.element) : type.count;
    return value(frame, i.words[k]);
  };
  std::size_t m = 0, n = 0;
  Slots out;
  const auto sum = [&](auto&& term, std::size_t count) {
    Slot total = term(0);
    for (std::size_t k = 1; k < count; ++k) total = emit(Op::add, total, term(k));
    return total;
  };
  const auto need = [&](bool good) {
    if (!good) refuse("a matrix has the wrong size");
  };
  switch (i.code) {
    case spv::OpTranspose: {
      const Slots a = operand(0, m);
      for (std::size_t r = 0; r < m; ++r)
        for (std::size_t c = 0; c < a.size() / m; ++c) out.push_back(a[c * m + r]);
      return out;
    }
    case spv::OpMatrixTimesVector: {
      const Slots a = operand(0, m), v = operand(1, n);
      need(a.size() == m * v.size());
      for (std::size_t r = 0; r < m; ++r)
        out.push_back(sum([&](std::size_t c) { return emit(Op::mul, a[c * m + r], v[c]); }, v.size()));
      return out;
    }
    case spv::OpVectorTimesMatrix: {
      const Slots v = operand(0, n), a = operand(1, m);
      need(v.size() == m);
      for (std::size_t c = 0; c < a.size() / m; ++c)
        out.push_back(sum([&](std::size_t r) { return emit(Op::mul, v[r], a[c * m + r]); }, m));
      return out;
    }
    case spv::OpMatrixTimesMatrix: {
      const Slots a = operand(0, m), b = operand(1, n);
      need(a.size() == m * n);
      for (std::size_t c = 0; c < b.size() / n; ++c)
        for (std::size_t r = 0; r < m; ++r)
          out.push_back(sum([&](std::size_t k) { return emit(Op::mul, a[k * m + r], b[c * n + k]); }, n));
      return out;
    }
    case spv::OpOuterProduct: {
      const Slots a = operand(0, m), b = operand(1, n);
      for (const Slot y : b)
        for (const Slot x : a) out.push_back(emit(Op::mul, x, y));
      return out;
    }
    default:
      refuse("uses an unsupported operation (SPIR-V " + std::to_string(i.code) + ")");
  }
}

Slots Lowering::convert(Frame& frame, const spirv::Instruction& i) {
  const Slots given = value(frame, i.words.at(0));
  const std::vector<bool> from = kinds(type_of(frame, i.words[0])), to = kinds(i.type);
  if (from.size() != to.size()) refuse("a value has two types");
  Slots out;
  for (std::size_t k = 0; k < given.size(); ++k)
    out.push_back(from[k] == to[k] ? given[k] : emit(to[k] ? Op::bits_of : Op::from_bits, given[k]));
  return out;
}

Slots Lowering::select(Frame& frame, const spirv::Instruction& i) {
  if (i.words.size() < 3) refuse("an instruction is incomplete");
  const Slots condition = value(frame, i.words[0]), yes = value(frame, i.words[1]),
              no = value(frame, i.words[2]);
  const std::vector<bool> integer = kinds(i.type);
  if (yes.size() != integer.size() || no.size() != integer.size() || condition.empty())
    refuse("a value has two types");
  Slots out;
  for (std::size_t k = 0; k < yes.size(); ++k)
    out.push_back(emit(integer[k] ? Op::iselect : Op::select,
                       condition[condition.size() == 1 ? 0 : std::min(k, condition.size() - 1)], yes[k],
                       no[k]));
  return out;
}

}  // namespace brdf::shader
