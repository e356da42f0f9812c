// Finds the line of a shader's source that causes a bad value.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "shader/function.h"

namespace brdf::shader {

enum class Fault {
  not_finite,    // in the scalar of the evaluation
  negative,      // in the scalar of the evaluation
  loses_digits,  // float differs from double of the same code, at inputs rounded to float
};

struct Blame {
  std::uint32_t line = 0;  // starting at 1; 0: unknown
  std::string expression;  // the text of that line, trimmed
  std::string operation;   // with its operands and result: "0.25 / 0 = inf"
};

// Follows the value back from the result to the operation that is the first to have the fault while its
// operands do not have it. `values` are the values of all parameters in order; `component` selects a
// component of the result. Returns an empty Blame if the result does not have the fault. Throws
// EndlessLoop.
template <class T>
Blame blame(const Function& function, Fault fault, std::span<const double> values, const Vec3<double>& wi,
            const Vec3<double>& wo, std::size_t component);
extern template Blame blame<float>(const Function&, Fault, std::span<const double>, const Vec3<double>&,
                                   const Vec3<double>&, std::size_t);
extern template Blame blame<double>(const Function&, Fault, std::span<const double>, const Vec3<double>&,
                                    const Vec3<double>&, std::size_t);

// A pair of unit directions.
struct DirectionPair {
  Vec3<double> wi, wo;
};
// Finds the cause of a jump between two adjacent pairs of directions with different values: the comparison
// with different outcomes at the two pairs, or else the operation with a jump. Returns an empty Blame if
// neither is found. Throws EndlessLoop.
Blame blame_jump(const Function& function, std::span<const double> values, const DirectionPair& here,
                 const DirectionPair& there, std::size_t component);

// Returns "line 12, `D = a2 / d;`: 0.25 / 0 = inf"; empty for an empty Blame.
std::string to_text(const Blame& blame);

}  // namespace brdf::shader
