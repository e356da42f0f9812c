// Parameters that the user fixes, bounds and starts. Names are resolved to parameters once. An option that
// would have no effect is rejected with the reason.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "fit/model/options.h"

namespace brdf::fit {

// The azimuth of the tangent, which belongs to no form, under its name in options and reports.
inline constexpr ParameterInfo kTangentInfo{"tangent_phi", -180,      180,   0,
                                            180,           "degrees", false, "azimuth of the tangent"};

// The components of the surface's normal, if the normal is fitted.
inline constexpr double kSteepest = 0.95;  // of either component
inline constexpr std::array<ParameterInfo, 2> kNormalInfo{
    ParameterInfo{"normal.x", -kSteepest, kSteepest, 0, kSteepest, "", false, "the surface's normal along x"},
    ParameterInfo{"normal.y", -kSteepest, kSteepest, 0, kSteepest, "", false,
                  "the surface's normal along y"}};

// The constraints of one parameter.
struct Constraint {
  std::vector<double> fixed, start;  // one value, or one per channel; empty if not given
  double low = 0, high = 0;          // the range of the table, or the given bounds
  bool tied = false;                 // one value for all channels
  std::string idle;                  // reason why options have no effect here; empty if they have an effect

  bool same_limits(const Constraint& c) const {
    return fixed == c.fixed && low == c.low && high == c.high && tied == c.tied;
  }
  bool is_fixed() const { return !fixed.empty(); }
  double fixed_in(std::size_t channel) const { return fixed[fixed.size() == 1 ? 0 : channel]; }
  double start_in(std::size_t channel) const { return start[start.size() == 1 ? 0 : channel]; }
};

struct TermConstraints {
  std::vector<Constraint> shape, weights;  // in the order of the tables
};

struct Constraints {
  std::vector<TermConstraints> terms;
  Constraint tangent;  // degrees
};

// Resolves the options for a sum of forms. A name may refer to several parameters: "kd" to the parameters
// of all terms, "terms[1].kd" to that of one term, and the common name of the two widths of a form
// ("alpha") to both widths. Tables of refractive indices are evaluated for the channels. Throws InputError
// if no parameter has the name, if values are out of range or their number is wrong, or if an option has no
// effect.
Constraints resolve(std::span<const Reflectance> forms, std::span<const std::string> channels,
                    const FitOptions& options);

// Returns "ward" or "oren_nayar+ward".
std::string name_of_sum(std::span<const Reflectance> forms);

// Returns the name of a parameter in a sum of `terms` terms: "alpha_x" for one term, otherwise
// "terms[1].alpha_x".
std::string name_in_sum(std::size_t terms, std::size_t term, std::string_view parameter);

}  // namespace brdf::fit
