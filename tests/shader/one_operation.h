// Shaders of one operation each, as flattened programs: the operation with three sets of operands, whose
// results are the red, green and blue values.
#pragma once

#include <array>
#include <limits>

#include "shader/program/operations.h"
#include "tests/shader/texts.h"

namespace brdf::shader {

struct Operands {
  std::array<double, 3> numbers;
  std::array<std::uint32_t, 3> integers;
};

inline constexpr std::array<std::array<Operands, 3>, 2> kOperandSets{
    {{{{{0.75, -2.5, 3.25}, {7, 3, 5}},
       {{-1.5, 0.5, 2.0}, {0xfffffff9, 3, 1}},
       {{2.5, 2.5, 1e-6}, {0x80000000, 0xffffffff, 0}}}},
     {{{{3e9, 1.75, -0.25}, {5, 0, 9}},
       {{-1e5, -3.5, 1e-4}, {0, 0xfffffffe, 40}},
       {{std::numeric_limits<double>::quiet_NaN(), 1, 2}, {0xffff0001, 33, 2}}}}}};

// An index outside of the array is the fault of a shader, and not an operation's.
inline bool reads_an_array(const Operation& o) {
  return o.loads() || o.stores();
}

// Adds the operation with the operands to the program, in slots from `first`. Returns the slot of the result.
// An integer becomes a number of 24 bits.
inline std::uint32_t add_operation(Program& p, const Operation& o, const Operands& operands,
                                   std::uint32_t first) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    p.constants.push_back({first + k, operands.numbers[k]});
    p.integer_constants.push_back({first + k, reads_an_array(o) ? k % 2 : operands.integers[k]});
  }
  std::vector<Step>& steps = p.stretches[0].steps;
  const std::uint32_t r = first + 3, more = first + 5;
  Step step{o.op, r, first, first + 1, first + 2};
  if (o.op == Op::pow) step.c = 0;  // the exponent is not known to be a whole number
  if (reads_an_array(o)) step.c = 2;
  steps.push_back(step);
  const std::uint32_t result = o.stores() ? r + 1 : r;
  if (!o.writes_integer()) return result;
  p.integer_constants.push_back({more, 8});
  p.integer_constants.push_back({more + 1, 0xffffff});
  steps.push_back({Op::shr, more + 2, result, more});
  steps.push_back({Op::ixor, more + 3, result, more + 2});
  steps.push_back({Op::iand, more + 4, more + 3, more + 1});
  steps.push_back({Op::from_unsigned, more, more + 4});
  return more;
}

// Returns a shader whose function is the operation, with this name.
inline std::shared_ptr<const ShaderReflectance> shader_of_operation(const Operation& o,
                                                                    const std::array<Operands, 3>& sets,
                                                                    const std::string& name) {
  Function f = make_function(parse_source(name + ".glsl", "float brdf(vec3 L, vec3 V) { return 1.0; }"));
  Program p;
  p.stretches.resize(1);
  p.numbers = p.integers = 30;
  for (std::uint32_t k = 0; k < 3; ++k) p.results.push_back(add_operation(p, o, sets[k], 10 * k));
  f.as_written = f.as_meant = p;
  f.bindings.clear();
  f.bindings_as_meant.clear();
  f.constant.reset();
  f.symmetry = f.symmetry_as_meant = {};
  return std::make_shared<const ShaderReflectance>(std::move(f));
}

// Calls use(operation, shader, name) for every operation that can be exported, with the first `sets` of the
// sets of operands.
template <class Use>
void for_each_operation(std::size_t sets, Use&& use) {
  for (std::size_t op = 0; op < std::size_t(Op::count); ++op) {
    if (Op(op) == Op::texel) continue;
    for (std::size_t k = 0; k < sets; ++k) {
      const std::string name = "operation_" + std::to_string(op) + "_" + std::to_string(k);
      use(Op(op), shader_of_operation(operation(Op(op)), kOperandSets[k], name), name);
    }
  }
}

// Returns the three values in float at one pair of directions.
inline std::array<float, 3> values_in_float(const Material& material, const Vec3<float>& wi,
                                            const Vec3<float>& wo) {
  std::array<float, 3> values;
  for (std::size_t c = 0; c < 3; ++c)
    eval_batch(material.terms.front(), std::min(c, material.channels.size() - 1), one_pair(wi, wo),
               &values[c]);
  return values;
}

// Returns whether a language's function computed the interpreter's value. Functions such as exp differ in
// their last digits.
inline bool is_same_value(float a, float b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b || std::fabs(a - b) <= 2e-6f * std::fabs(a);
}

}  // namespace brdf::shader
