// How exactly float and double evaluate every form, measured against 50 digits.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "brdf/reflectance.h"

namespace brdf::validate {

// Largest errors over the grid of extremes.h, relative to the exact value at the same rounded inputs with the
// directions taken as unit vectors. Stored vectors are never exactly unit, and a lobe of width alpha seen
// near grazing magnifies the difference of their lengths by 1/(alpha cos): where that alone moves the exact
// value by more than a quarter of the budget, the exact value at the vectors as they stand is the truth
// instead. Where a value is the difference of larger terms the error is relative to those: to the lobe at f0
// = 1 for f0 = 0, to the lobe's peak where the mirror lobe's cosine is below 1/2, to |f| + the diffuse weight
// over pi for a form that declares negative values, as its terms change sign.
struct NumericsRow {
  std::string form;
  std::string scalar;    // float | double
  double max_error = 0;  // where f >= 1e-6 of the lobe's peak for that light
  struct Where {
    std::string parameters;  // as --set takes them
    Vec3<double> wi, wo;
  } where;                    // of that error
  double faint_error = 0;     // where f is 1e-12..1e-6 of the peak: an exponent of 27 magnifies roundings
  double tail_error = 0;      // where f is 1e-30..1e-12 of the peak; below that nothing is promised
  std::size_t count = 0;      // values
  std::size_t as_stored = 0;  // of them judged at the vectors as they stand
  std::size_t nan = 0, inf = 0, negative = 0;
  bool may_be_negative = false;  // the form declares it
};

// One row per scalar, float first; none of what is not in the catalogue: there is no template to run in 50
// digits.
std::vector<NumericsRow> measure_numerics(const Reflectance& form);

// What every form promises (the largest error is a row's own fact, asserted on both sides in the tests).
struct NumericsBudget {
  double max_error, faint_error, tail_error;
};
NumericsBudget numerics_budget(const std::string& scalar);

// Within the budget, every value finite, and none negative unless the form declares it.
bool meets_budget(const NumericsRow& row);

// Prints the rows of these forms, as a table while they are measured (half a second a form)
// or as {"rows": [...], "provenance": ...}, and names those that cannot be measured. True where all others
// meet their budgets.
bool report_numerics(const std::vector<Reflectance>& forms, bool json, std::ostream& out,
                     const std::function<void(int done, int total)>& progress);

}  // namespace brdf::validate
