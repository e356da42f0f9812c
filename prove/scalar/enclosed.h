// Forms of the catalogue on boxes: what a box is, and what a form takes on it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "prove/scalar/elementary.h"

namespace brdf::prove {

enum class Precision { float_type, double_type };

// One dimension of a box: [low, high], cut in two where its kind says.
struct Variable {
  enum class Cut {
    middle,
    logarithmic,  // at the geometric mean
    cosine        // the same, down to the smallest cosine
  };
  std::string name;
  double low, high;
  Cut cut;
  bool weight = false;
  bool tied = false;  // stands for two parameters that are held equal
};

// What a form is asked about: its parameters over their whole tables, the weights of the first channel where
// a form mixes channels, and both directions anywhere in the hemisphere. A direction is its cosine and its
// turn, -2 to 2: azimuths in quarter turns, but for how they run between (cos : sin = 1 - |t| : t for |t| <=
// 1). Stored directions may differ from unit vectors by 2 units in each component.
struct Domain {
  std::vector<Variable> variables;
};

// The number of forms, their names; `form` is a place in the catalogue.
Domain domain_of(int form);
// All values of f and of f cos_i on the box (low and high of each variable), rounded or not. lo = -inf where
// some intermediate may leave the range of that precision.
Bounds enclose_value(int form, Precision precision, std::span<const Bounds> box);
// f alone.
Bounds enclose_f(int form, Precision precision, std::span<const Bounds> box);

// The two halves' common bound.
double cut_of(const Variable& variable, Bounds range);

}  // namespace brdf::prove
