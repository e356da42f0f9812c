// A flattened function of a shader: calls are inlined, vectors are split into components, and every value
// has a numbered slot. The program consists of blocks of operations on single numbers. An interpreter runs
// it in any scalar (shader/run), and it can be written as GLSL.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "shader/front/texture.h"

namespace brdf::shader {

// Numbers and integers (including booleans, as 0 and 1) have separate slots. In the comments, a, b, c are
// the operands and r is the result.
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
  // The library's own kernels (log1p and angle have two operands).
  log1p,
  erfcx,
  angle,
  // Rounds to half precision in float; other scalars keep the value.
  to_half,
  select,  // r = integer a ? number b : number c
  // numbers to an integer; _or: also true if an operand is NaN
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
  texel,  // r = number a of table c of the program; the last number if a is above it
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
  index,  // r = min(a, b), with b the last element; a above b is outside the array
  iabs,
  isign,
  iselect,
  logical_not,
  // load: r = slot a + integer b, with b below c; store: slot r + integer b = a
  load_number,
  load_integer,
  store_number,
  store_integer,
  count  // number of operations, not an operation
};

struct Step {
  Op op;
  // c of a pow: its exponent, if the exponent is a constant from 1 to 16. c of a min (imin, umin) that ends
  // a clamp: the slot of the lower limit plus 1.
  std::uint32_t r = 0, a = 0, b = 0, c = 0;
  std::uint32_t line = 0;  // of the source, starting at 1; 0: unknown
};

enum class End : std::uint8_t { jump, branch, stop };

struct Stretch {
  std::vector<Step> steps = {};
  End end = End::stop;
  std::uint32_t condition = 0;     // integer slot, for a branch
  std::uint32_t line = 0;          // line of the source at which the stretch ends
  std::uint32_t next[2] = {0, 0};  // next stretches; next[0] if the condition is true
};

// Slots of an argument or a global variable of the function, to be filled before each run.
struct Input {
  std::string name;  // of the argument or global; members as in the source: "material.roughness"
  std::string type;  // float, vec2, vec3, vec4, int, bool, or float[4], mat3
  std::vector<std::uint32_t> slots = {};
  bool integer = false;  // the slots are integer slots
  int argument = -1;     // position among the arguments; -1: a uniform, an input or a global variable
};

// The reason why a slot has no defined value.
enum class Unset : std::uint8_t { variable, no_return };

struct Program {
  // Execution starts at the first stretch. Apart from loops, a stretch leads only to later stretches.
  std::vector<Stretch> stretches;
  std::uint32_t numbers = 0, integers = 0;  // number of slots
  struct Constant {
    std::uint32_t slot;
    double value;
  };
  struct IntegerConstant {
    std::uint32_t slot, value;
  };
  std::vector<Constant> constants = {};
  std::vector<IntegerConstant> integer_constants = {};
  // Slots for values that the language does not define. They contain 0 and are never written.
  struct Undefined {
    std::uint32_t slot;
    bool integer;
    Unset why;
  };
  std::vector<Undefined> undefined = {};
  std::vector<Input> inputs = {};
  std::vector<std::shared_ptr<const TexelTable>> tables = {};  // channels of textures
  std::uint32_t line = 0;                   // line of the source at which the function begins; 0: unknown
  std::vector<std::uint32_t> results = {};  // number slots: one or three
  // Operates on the bits of a float; other scalars use the bits of their value rounded to float.
  bool takes_bits = false;
  bool loops = false;  // some stretch leads back

  std::size_t size() const {
    std::size_t sum = 0;
    for (const Stretch& s : stretches) sum += s.steps.size() + 1;
    return sum;
  }
};

}  // namespace brdf::shader
