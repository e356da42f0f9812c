// GLSL's built-in functions (GLSL.std.450). The geometric functions are expanded to the formulas that
// define them.
#include <glslang/SPIRV/GLSL.std.450.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "shader/program/lowering.h"
#include "shader/spirv/names.h"

namespace brdf::shader {
namespace {

const std::map<std::uint32_t, Op>& componentwise() {
  static const std::map<std::uint32_t, Op> map{{GLSLstd450Round, Op::round},
                                               {GLSLstd450RoundEven, Op::round_even},
                                               {GLSLstd450Trunc, Op::trunc},
                                               {GLSLstd450FAbs, Op::abs},
                                               {GLSLstd450SAbs, Op::iabs},
                                               {GLSLstd450FSign, Op::sign},
                                               {GLSLstd450SSign, Op::isign},
                                               {GLSLstd450Floor, Op::floor},
                                               {GLSLstd450Ceil, Op::ceil},
                                               {GLSLstd450Fract, Op::fract},
                                               {GLSLstd450Sin, Op::sin},
                                               {GLSLstd450Cos, Op::cos},
                                               {GLSLstd450Tan, Op::tan},
                                               {GLSLstd450Asin, Op::asin},
                                               {GLSLstd450Acos, Op::acos},
                                               {GLSLstd450Atan, Op::atan},
                                               {GLSLstd450Sinh, Op::sinh},
                                               {GLSLstd450Cosh, Op::cosh},
                                               {GLSLstd450Tanh, Op::tanh},
                                               {GLSLstd450Atan2, Op::atan2},
                                               {GLSLstd450Pow, Op::pow},
                                               {GLSLstd450Exp, Op::exp},
                                               {GLSLstd450Log, Op::log},
                                               {GLSLstd450Exp2, Op::exp2},
                                               {GLSLstd450Log2, Op::log2},
                                               {GLSLstd450Sqrt, Op::sqrt},
                                               {GLSLstd450InverseSqrt, Op::inverse_sqrt},
                                               {GLSLstd450FMin, Op::min},
                                               {GLSLstd450FMax, Op::max},
                                               {GLSLstd450NMin, Op::min},
                                               {GLSLstd450NMax, Op::max},
                                               {GLSLstd450UMin, Op::umin},
                                               {GLSLstd450SMin, Op::imin},
                                               {GLSLstd450UMax, Op::umax},
                                               {GLSLstd450SMax, Op::imax},
                                               {GLSLstd450FClamp, Op::clamp},
                                               {GLSLstd450NClamp, Op::clamp},
                                               {GLSLstd450SClamp, Op::imin},
                                               {GLSLstd450UClamp, Op::umin},
                                               {GLSLstd450FMix, Op::mix},
                                               {GLSLstd450Step, Op::step},
                                               {GLSLstd450SmoothStep, Op::smoothstep},
                                               {GLSLstd450Fma, Op::fma}};
  return map;
}

}  // namespace

Slot Lowering::dot(const Slots& a, const Slots& b) {
  if (a.size() != b.size() || a.empty()) refuse("a value has two types");
  Slot sum = emit(Op::mul, a[0], b[0]);
  for (std::size_t k = 1; k < a.size(); ++k) sum = emit(Op::add, sum, emit(Op::mul, a[k], b[k]));
  return sum;
}

Slots Lowering::scaled(const Slots& a, Slot by) {
  Slots out;
  for (const Slot x : a) out.push_back(emit(Op::mul, x, by));
  return out;
}

// The content of the slot if it is a constant whole number from 1 to 16; otherwise 0.
std::uint32_t Lowering::whole_exponent(Slot slot) const {
  const auto constant =
      std::ranges::find_if(program_.constants, [&](const Program::Constant& c) { return c.slot == slot; });
  const double value = constant == program_.constants.end() ? 0 : constant->value;
  return value >= 1 && value <= 16 && value == std::floor(value) ? std::uint32_t(value) : 0;
}

Slots Lowering::function(Frame& frame, const spirv::Instruction& i) {
  if (i.words.size() < 3 || i.words[0] != module_.extended) refuse("calls an unknown function");
  const std::uint32_t which = i.words[1];
  const auto found = componentwise().find(which);
  if (found == componentwise().end()) return geometric(frame, i, which);
  std::vector<Slots> operands;
  for (std::size_t k = 2; k < i.words.size(); ++k) operands.push_back(value(frame, i.words[k]));
  if (operands.size() > 3) refuse("a function has too many arguments");
  Slots out;
  for (std::size_t k = 0; k < operands[0].size(); ++k) {
    const auto at = [&](std::size_t operand) -> Slot {
      if (operand >= operands.size()) return 0;
      if (operands[operand].size() != operands[0].size()) refuse("a value has two types");
      return operands[operand][k];
    };
    // A clamp becomes two operations; the upper one also refers to the slot of the lower limit (Step::c).
    if (operands.size() == 3 && which != GLSLstd450FMix && which != GLSLstd450SmoothStep &&
        which != GLSLstd450Fma) {
      const auto [least, most] = found->second == Op::clamp  ? std::pair(Op::max, Op::min)
                                 : found->second == Op::imin ? std::pair(Op::imax, Op::imin)
                                                             : std::pair(Op::umax, Op::umin);
      out.push_back(emit(most, emit(least, at(0), at(1)), at(2), at(1) + 1));
      continue;
    }
    out.push_back(
        emit(found->second, at(0), at(1), found->second == Op::pow ? whole_exponent(at(1)) : at(2)));
  }
  return out;
}

Slots Lowering::geometric(Frame& frame, const spirv::Instruction& i, std::uint32_t which) {
  const auto of = [&](std::size_t k) {
    if (k + 2 >= i.words.size()) refuse("an instruction is incomplete");
    return value(frame, i.words[k + 2]);
  };
  const auto each = [&](Op op, const Slots& a, const Slots& b) {
    if (a.size() != b.size()) refuse("a value has two types");
    Slots out;
    for (std::size_t k = 0; k < a.size(); ++k) out.push_back(emit(op, a[k], b[k]));
    return out;
  };
  const auto length = [&](const Slots& v) {
    return v.size() == 1 ? emit(Op::abs, v[0]) : emit(Op::sqrt, dot(v, v));
  };
  const auto number = [&](double x) { return number_constant(x); };
  const auto clamped = [&](Op above, Op below) {  // of integers
    return each(below, each(above, of(0), of(1)), of(2));
  };
  switch (which) {
    case GLSLstd450Length:
      return {length(of(0))};
    case GLSLstd450Distance:
      return {length(each(Op::sub, of(0), of(1)))};
    case GLSLstd450Normalize: {
      const Slots v = of(0);
      const Slot l = length(v);
      Slots out;
      for (const Slot x : v) out.push_back(emit(Op::div, x, l));
      return out;
    }
    case GLSLstd450Cross: {
      const Slots a = of(0), b = of(1);
      if (a.size() != 3 || b.size() != 3) refuse("a value has two types");
      Slots out;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
        out.push_back(emit(Op::sub, emit(Op::mul, a[x], b[y]), emit(Op::mul, a[y], b[x])));
      }
      return out;
    }
    case GLSLstd450Reflect: {  // I - 2 dot(N, I) N
      const Slots incident = of(0), n = of(1);
      return each(Op::sub, incident, scaled(n, emit(Op::mul, number(2), dot(n, incident))));
    }
    case GLSLstd450Refract: {
      const Slots incident = of(0), n = of(1);
      const Slot eta = of(2).at(0), d = dot(n, incident);
      const Slot k =
          emit(Op::sub, number(1),
               emit(Op::mul, emit(Op::mul, eta, eta), emit(Op::sub, number(1), emit(Op::mul, d, d))));
      const Slot whole = emit(Op::less, k, number(0));
      const Slot along = emit(Op::add, emit(Op::mul, eta, d), emit(Op::sqrt, emit(Op::max, k, number(0))));
      Slots out;
      for (const Slot x : each(Op::sub, scaled(incident, eta), scaled(n, along)))
        out.push_back(emit(Op::select, whole, number(0), x));
      return out;
    }
    case GLSLstd450FaceForward: {
      const Slots n = of(0);
      const Slot behind = emit(Op::less, dot(of(2), of(1)), number(0));
      Slots out;
      for (const Slot x : n) out.push_back(emit(Op::select, behind, x, emit(Op::neg, x)));
      return out;
    }
    case GLSLstd450UClamp:
      return clamped(Op::umax, Op::umin);
    case GLSLstd450SClamp:
      return clamped(Op::imax, Op::imin);
    case GLSLstd450Radians:
    case GLSLstd450Degrees: {
      constexpr double kTurn = 0.017453292519943295;
      return scaled(of(0), number(which == GLSLstd450Radians ? kTurn : 1 / kTurn));
    }
    default:
      refuse("calls " + spirv::function_name(which) + "(), which is not supported; write its formula");
  }
}

}  // namespace brdf::shader
