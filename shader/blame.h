// Which line of a shader's source a bad value comes from.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "shader/function.h"

namespace brdf::shader {

enum class Fault {
  not_finite,    // in the scalar asked for
  negative,      // in the scalar asked for
  loses_digits,  // float against double of the same code, at float's inputs
};

struct Blame {
  std::uint32_t line = 0;  // from 1; 0: unknown
  std::string expression;  // that line, trimmed
  std::string operation;   // with its operands and result: "0.25 / 0 = inf"
};

// Follows the value back from the result to the operation that first has the fault while its operands have
// not. `values` are all parameters' in order, of `component` of the result. Empty where the result has no
// such fault there. Throws EndlessLoop.
template <class T>
Blame blame(const Function& function, Fault fault, std::span<const double> values, const Vec3<double>& wi,
            const Vec3<double>& wo, std::size_t component);
extern template Blame blame<float>(const Function&, Fault, std::span<const double>, const Vec3<double>&,
                                   const Vec3<double>&, std::size_t);
extern template Blame blame<double>(const Function&, Fault, std::span<const double>, const Vec3<double>&,
                                    const Vec3<double>&, std::size_t);

// Of two pairs of directions that lie beside one another and have different values: the comparison that one
// passes and the other does not, else the operation that jumps.
struct DirectionPair {
  Vec3<double> wi, wo;
};
Blame blame_jump(const Function& function, std::span<const double> values, const DirectionPair& here,
                 const DirectionPair& there, std::size_t component);

// "line 12, `D = a2 / d;`: 0.25 / 0 = inf"; empty of no blame.
std::string to_text(const Blame& blame);

}  // namespace brdf::shader
