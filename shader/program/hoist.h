// Finds the values of a program that stay the same while some of its inputs change, so that an interpreter
// computes them once.
#pragma once

#include <cstdint>
#include <vector>

#include "shader/program/program.h"

namespace brdf::shader {

// A set of slots.
struct SlotSet {
  explicit SlotSet(const Program& p) : numbers(p.numbers), integers(p.integers) {}
  std::vector<bool>& of(bool integer) { return integer ? integers : numbers; }
  const std::vector<bool>& of(bool integer) const { return integer ? integers : numbers; }

  std::vector<bool> numbers, integers;
};

// Adds the slots whose values are computed from the given ones, in any order of the steps. Branches are not
// followed. Derivatives do not pass through integers: `integers_too` is false for them.
void add_computed(const Program& program, SlotSet& slots, bool integers_too);

// A program in two parts. After `once` has run, `rest` gives the results of the whole program for every
// value of the slots that change.
struct Hoisted {
  std::vector<Step> once;
  Program rest;
};
// `inputs`: the inputs that have other values in the next run. Constants are no inputs.
Hoisted hoist(const Program& program, const SlotSet& inputs);

}  // namespace brdf::shader
