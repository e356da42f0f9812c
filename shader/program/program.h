// A shader's function, flattened: calls inlined, vectors taken apart, every value in a numbered slot. What
// remains are blocks of operations on single numbers, which an interpreter runs over any scalar (shader/run)
// and which can be written as GLSL again.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace brdf::shader {

// Numbers and integers (with booleans, as 0 and 1) have slots of their own. Comments name the operands a, b,
// c and the result r.
enum class Op : std::uint8_t {
  // numbers to a number
  copy,
  add,
  sub,
  mul,
  div,
  neg,
  mod,
  rem,
  abs,
  sign,
  floor,
  ceil,
  trunc,
  round,
  round_even,
  fract,
  sqrt,
  inverse_sqrt,
  exp,
  exp2,
  log,
  log2,
  pow,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  sinh,
  cosh,
  tanh,
  min,
  max,
  clamp,
  mix,
  step,
  smoothstep,
  fma,
  // The library's own kernels, by their meaning (log1p and angle have two operands).
  log1p,
  erfcx,
  angle,
  select,  // r = integer a ? number b : number c
  // numbers to an integer; _or: true as well where one is no number
  equal,
  not_equal,
  less,
  less_equal,
  not_equal_or,
  less_or,
  less_equal_or,
  is_nan,
  is_inf,
  to_signed,
  to_unsigned,
  bits_of,
  // integers to a number
  from_signed,
  from_unsigned,
  from_bits,
  // integers to an integer
  icopy,
  iadd,
  isub,
  imul,
  sdiv,
  udiv,
  smod,
  srem,
  umod,
  ineg,
  iand,
  ior,
  ixor,
  inot,
  shl,
  shr,
  sar,
  ieq,
  ine,
  slt,
  sle,
  ult,
  ule,
  imin,
  imax,
  umin,
  umax,
  index,  // r = min(a, b), b the last element; a above b is outside the array
  iabs,
  isign,
  iselect,
  logical_not,
  // r = slot a + number of integer b, which is below c; and the other way: slot r + integer b becomes a
  load_number,
  load_integer,
  store_number,
  store_integer,
  count  // of them: no operation
};

struct Step {
  Op op;
  std::uint32_t
      r = 0,
      a = 0, b = 0,
      c = 0;  // of a pow: its exponent, where that is a constant from 1 to 16; of a min (imin, umin) that ends a
              // clamp: the slot of the lower limit, and 1
  std::uint32_t line = 0;  // of the source, from 1; 0: unknown
};

enum class End : std::uint8_t { jump, branch, stop };

struct Stretch {
  std::vector<Step> steps = {};
  End end = End::stop;
  std::uint32_t condition = 0;     // integer slot, of a branch
  std::uint32_t line = 0;          // of the source, where it ends
  std::uint32_t next[2] = {0, 0};  // stretches: next[0] where the condition is true
};

// A slot of the function's arguments and globals, to be filled before each run.
struct Input {
  std::string name;  // of the argument or global; members as in the source: "material.roughness"
  std::string type;  // float, vec2, vec3, vec4, int, bool, or float[4], mat3
  std::vector<std::uint32_t> slots = {};
  bool integer = false;  // slots of integers
  int argument = -1;     // its place among the arguments; -1: a uniform, an input or a global variable
};

// Why a slot holds no defined value.
enum class Unset : std::uint8_t { variable, no_return };

struct Program {
  // The first is where it starts; later ones never lead into the middle of earlier ones but by loops.
  std::vector<Stretch> stretches;
  std::uint32_t numbers = 0, integers = 0;  // slots
  struct Constant {
    std::uint32_t slot;
    double value;
  };
  struct IntegerConstant {
    std::uint32_t slot, value;
  };
  std::vector<Constant> constants = {};
  std::vector<IntegerConstant> integer_constants = {};
  // Slots that stand for a value which the language does not define. They hold 0 and are never written.
  struct Undefined {
    std::uint32_t slot;
    bool integer;
    Unset why;
  };
  std::vector<Undefined> undefined = {};
  std::vector<Input> inputs = {};
  std::uint32_t line = 0;                   // of the source, where the function begins; 0: unknown
  std::vector<std::uint32_t> results = {};  // number slots: one, or three
  bool takes_bits = false;  // operates on the bits of a float: in other scalars on those of its float value
  bool loops = false;       // some stretch leads back

  std::size_t size() const {
    std::size_t sum = 0;
    for (const Stretch& s : stretches) sum += s.steps.size() + 1;
    return sum;
  }
};

}  // namespace brdf::shader
