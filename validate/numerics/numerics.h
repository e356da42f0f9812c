// How exactly float and double evaluate every form, measured against 50 digits.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "brdf/reflectance.h"

namespace brdf::validate {

// Largest errors over the grid of extremes.h and over a search for the worst place, relative to the exact
// value at the same rounded inputs with the directions taken as unit vectors. The truth of double has 50
// digits, that of float is double. Stored vectors are never exactly unit, and a lobe of width alpha seen near
// grazing magnifies the difference of their lengths by 1/(alpha cos): where that alone moves the exact value
// by more than a quarter of the body's budget, the exact value at the vectors as they stand is the truth
// instead. Where a value is the difference of larger terms the error is relative to those: to a hundredth of
// the lobe at f0 = 1 where Fresnel's term is less than that, to |f| + the diffuse weight over pi for a form
// that declares negative values, as its terms change sign, to the lobe's peak where the mirror lobe's cosine
// is below 1/2. Where that lobe ends it may be steep, for exponent 0 a step: there every value that r.o
// within 4 ulp gives is right. Nothing is promised of values below 1e-30.
struct NumericsRow {
  std::string form;
  std::string scalar;  // float | double
  Accuracy::Errors errors{};
  struct Where {
    std::string parameters;  // as --set takes them
    Vec3<double> wi, wo;
  } where;                    // of the largest error of the body
  std::size_t count = 0;      // values
  std::size_t as_stored = 0;  // of them judged at the vectors as they stand
  std::size_t nan = 0, inf = 0, negative = 0;
  bool may_be_negative = false;            // the form declares it
  std::optional<Accuracy::Errors> stated;  // by the form's header
};

struct NumericsOptions {
  std::size_t evaluations = 10'000;  // of the search, per scalar
  std::uint64_t seed = 1;
};

// One row per scalar, float first; none of what is not in the catalogue: there is no template to run in 50
// digits.
std::vector<NumericsRow> measure_numerics(const Reflectance& form, const NumericsOptions& options = {});

// What every form promises (what it states for itself is less, see its header).
Accuracy::Errors numerics_budget(const std::string& scalar);

// Within the budget, every value finite, and none negative unless the form declares it.
bool meets_budget(const NumericsRow& row);
// No error is larger than the form's header states.
bool meets_statement(const NumericsRow& row);

// Prints the rows of these forms, as a table while they are measured or as {"rows": [...], "provenance":
// ...}, and names those that cannot be measured. True where all others meet their budgets and statements.
bool report_numerics(const std::vector<Reflectance>& forms, const NumericsOptions& options, bool json,
                     std::ostream& out, const std::function<void(int done, int total)>& progress);

}  // namespace brdf::validate
