// What becomes of values, followed as polynomials across the normal, in a step of a program.
#pragma once

#include <optional>

#include "shader/function.h"
#include "shader/polynomials.h"
#include "shader/program/operations.h"

namespace brdf::shader {

// What is known of every slot, numbers first.
using State = std::vector<Form>;

class TurningSteps {
 public:
  TurningSteps(const Program& program, Polynomials& forms) : p_(program), forms_(forms) {}

  // What the step makes of its operands, written to its result.
  Turning step(State& s, const Step& x);

  const Form& at(const State& s, bool integer, std::uint32_t slot) const {
    return s[integer ? p_.numbers + slot : slot];
  }
  Form& at(State& s, bool integer, std::uint32_t slot) const { return s[integer ? p_.numbers + slot : slot]; }

  // Operations from the coordinates to a number that does not change, at most.
  int depth() const { return depth_; }
  // The first line, or 1, in which a value that changes is too many operations from the coordinates; else 0.
  std::uint32_t too_deep() const { return too_deep_; }
  void start_over() { too_deep_ = 0; }

 private:
  Turning indexed(State& s, const Step& x, const Operation& o);
  Form value(const State& s, const Step& x, const Operation& o);
  Hand hand_of(const State& s, const Step& x, const Operation& o, bool all_still) const;
  // Which errors of rounding are relative to the value itself: not those of sums whose terms are rounded
  // already and may cancel.
  void set_rounding(Form& f, const State& s, const Step& x) const;
  // Sums, products and choices as polynomials; nothing of other operations, or beyond the second degree.
  std::optional<Terms> polynomial(const State& s, const Step& x, bool all_known);

  const Program& p_;
  Polynomials& forms_;
  int depth_ = 0;
  std::uint32_t too_deep_ = 0;
};

}  // namespace brdf::shader
