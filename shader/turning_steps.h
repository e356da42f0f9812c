// Propagates values, represented as polynomials across the normal, through the steps of a program.
#pragma once

#include <optional>

#include "shader/function.h"
#include "shader/polynomials.h"
#include "shader/program/operations.h"

namespace brdf::shader {

// The known form of every slot, numbers first.
using State = std::vector<Form>;

class TurningSteps {
 public:
  TurningSteps(const Program& program, Polynomials& forms) : p_(program), forms_(forms) {}

  // Applies the step to its operands, writes the form of its result, and returns how the result depends on
  // the rotation.
  Turning step(State& s, const Step& x);

  const Form& at(const State& s, bool integer, std::uint32_t slot) const {
    return s[integer ? p_.numbers + slot : slot];
  }
  Form& at(State& s, bool integer, std::uint32_t slot) const { return s[integer ? p_.numbers + slot : slot]; }

  // Returns the largest number of operations from the coordinates to a number that does not change.
  int depth() const { return depth_; }
  // Returns the first line in which a changing value is too many operations away from the coordinates, or 1
  // if that line is unknown; 0 if there is no such value.
  std::uint32_t too_deep() const { return too_deep_; }
  void start_over() { too_deep_ = 0; }

 private:
  Turning indexed(State& s, const Step& x, const Operation& o);
  Form value(const State& s, const Step& x, const Operation& o);
  Hand hand_of(const State& s, const Step& x, const Operation& o, bool all_still) const;
  // Determines whether the rounding error is relative to the value itself. This is false for sums of terms
  // that are already rounded and may cancel.
  void set_rounding(Form& f, const State& s, const Step& x) const;
  // Returns sums, products and choices as polynomials; std::nullopt for other operations and beyond the
  // second degree.
  std::optional<Terms> polynomial(const State& s, const Step& x, bool all_known);

  const Program& p_;
  Polynomials& forms_;
  int depth_ = 0;
  std::uint32_t too_deep_ = 0;
};

}  // namespace brdf::shader
