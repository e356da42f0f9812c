// Forms of the catalogue on boxes: the variables of a box, and the values of a form on the box.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "prove/scalar/elementary.h"

namespace brdf::prove {

enum class Precision { float_type, double_type };

// One dimension of a box: [low, high], cut in two at the place that `cut` gives.
struct Variable {
  enum class Cut {
    middle,
    logarithmic,  // at the geometric mean
    cosine        // at the geometric mean, down to the smallest cosine
  };
  std::string name;
  double low, high;
  Cut cut;
  bool weight = false;
  bool tied = false;  // replaces two parameters that are held equal
};

// The arguments of a form. They are the parameters over the whole ranges of their tables, the weights of
// the first channel if the form mixes channels, and both directions anywhere in the hemisphere. A direction
// is given by its cosine and its turn, -2 to 2. A whole turn is a quarter of the circle of azimuths.
// Between whole turns the azimuth is not proportional to the turn t: cos : sin = 1 - |t| : t for |t| <= 1.
// Stored directions may differ from unit vectors by 2 units in each component.
struct Domain {
  std::vector<Variable> variables;
};

// Returns the domain of a form. `form` is an index in the catalogue.
Domain domain_of(int form);
// Returns the domain on which values are enclosed: the same, except for a matt basis. Its directions are r_i,
// r_o (0 to 1) and the cosine of the difference of the azimuths, in which f is a polynomial.
Domain value_domain_of(int form);
// Encloses all values of f and of f cos_i on a box of value_domain_of (low and high of each variable),
// rounded or exact.
// lo = -inf if some intermediate value may leave the range of that precision.
Bounds enclose_value(int form, Precision precision, std::span<const Bounds> box);

// Returns the common bound of the two halves.
double cut_of(const Variable& variable, Bounds range);

}  // namespace brdf::prove
