// Measures how accurately float and double evaluate every form, compared with 50 digits.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "brdf/reflectance.h"

namespace brdf::validate {

// Largest errors over the grid of extremes.h and over a search for the worst place. Errors are relative to
// the exact value at the same rounded inputs, with the directions taken as unit vectors. The truth for
// double has 50 digits; the truth for float is double. Exceptions:
//
// Stored vectors are never exactly unit vectors, and a lobe of width alpha seen near grazing magnifies the
// difference of their lengths by 1/(alpha cos). If this alone moves the exact value by more than a quarter
// of the body's budget, the truth is the exact value at the stored vectors instead.
//
// If a value is the difference of larger terms, the error is relative to these terms: to a hundredth of the
// lobe at f0 = 1 if the Fresnel term is less than that; to |f| + the diffuse weight over pi for a form that
// declares negative values, because its terms change sign; to |f| + the sizes of the weights over pi for a
// basis; to the lobe's peak if the cosine r.o of the mirror lobe is below 1/2.
//
// Where the mirror lobe ends, the lobe may be steep; for exponent 0 it is a step. There, every value that
// results from r.o within 4 ulp is correct. Nothing is promised about values below 1e-30.
struct NumericsRow {
  std::string form;
  std::string scalar;  // float | double
  Accuracy::Errors errors{};
  struct Where {
    std::string parameters;  // in the syntax of --set
    Vec3<double> wi, wo;
  } where;                    // the place of the largest error of the body
  std::size_t count = 0;      // number of values
  std::size_t as_stored = 0;  // how many of them are judged at the stored vectors
  std::size_t nan = 0, inf = 0, negative = 0;
  bool may_be_negative = false;            // the form declares negative values
  std::optional<Accuracy::Errors> stated;  // the errors that the form's header states
};

struct NumericsOptions {
  std::size_t evaluations = 10'000;  // of the search, per scalar
  std::uint64_t seed = 1;
};

// Returns one row per scalar, float first. Returns an empty vector for a form that is not in the catalogue,
// because there is no template to run with 50 digits.
std::vector<NumericsRow> measure_numerics(const Reflectance& form, const NumericsOptions& options = {});

// Returns the error limits that every form meets. (The limits that a form states for itself are lower, see
// its header.)
Accuracy::Errors numerics_budget(const std::string& scalar);

// Returns whether the errors are within the budget, every value is finite, and no value is negative unless
// the form declares negative values.
bool meets_budget(const NumericsRow& row);
// Returns whether all errors are at most as large as the form's header states.
bool meets_statement(const NumericsRow& row);

// Prints the rows of these forms, as a table while they are measured or as {"rows": [...], "provenance":
// ...}, and names the forms that cannot be measured. Returns true if all others meet their budgets and
// statements.
bool report_numerics(const std::vector<Reflectance>& forms, const NumericsOptions& options, bool json,
                     std::ostream& out, const std::function<void(int done, int total)>& progress);

}  // namespace brdf::validate
