// The other turns of the light, which a shader that is isotropic in real numbers is not enclosed at.
//
// At one turn, a coordinate across the normal may be exactly 0. At other turns the same steps round
// differently, their results may be subnormal numbers, which have few digits, and they may overflow. Every
// number that changes with the turn therefore has a bound of its absolute value at every turn, and every
// number has a bound of the absolute error that underflow has caused in it. Later factors enlarge both.
#pragma once

#include "prove/shader/way.h"
#include "shader/function.h"

namespace brdf::prove {

template <class B>
class OtherTurns {
 public:
  using I = Interval<B>;
  // Bounds for the result of a step at every turn.
  struct Result {
    double most = 0;       // of the absolute value; for a sum, of its terms together
    double larger = 0;     // of a sum: of the larger one of two terms
    double underflow = 0;  // of the absolute error by underflow
  };

  explicit OtherTurns(const shader::Symmetry& symmetry) : depth_(symmetry.depth) {}

  // States that a slot holds a coordinate across the normal.
  static void begin(Way<B>& w, std::uint32_t slot);
  // Returns the bounds before the step is executed, because the step may overwrite an operand.
  static Result result_of(const Way<B>& w, const shader::Step& s, shader::Turning turning);
  // Widens the result of an executed step for the other turns. The result is poison if it, or one of the
  // terms of a sum, may be infinite at another turn.
  void widen(Way<B>& w, const shader::Step& s, shader::Turning turning, const Result& result) const;

 private:
  void close(Way<B>& w, const shader::Step& s, shader::Turning turning, const Result& result) const;
  void compare(Way<B>& w, const shader::Step& s) const;

  int depth_;
};

}  // namespace brdf::prove
