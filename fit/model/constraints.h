// What the user holds, bounds and starts: names are resolved to parameters once, and what would have no
// effect is refused with the reason.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "fit/model/options.h"

namespace brdf::fit {

// The azimuth of the tangent, which is no form's own, as options and reports name it.
inline constexpr ParameterInfo kTangentInfo{"tangent_phi", -180,      180,   0,
                                            180,           "degrees", false, "azimuth of the tangent"};

// The components of the surface's normal where it is fitted.
inline constexpr double kSteepest = 0.95;  // either component
inline constexpr std::array<ParameterInfo, 2> kNormalInfo{
    ParameterInfo{"normal.x", -kSteepest, kSteepest, 0, kSteepest, "", false, "the surface's normal along x"},
    ParameterInfo{"normal.y", -kSteepest, kSteepest, 0, kSteepest, "", false,
                  "the surface's normal along y"}};

// One parameter's.
struct Constraint {
  std::vector<double> fixed, start;  // one value, or one per channel; empty: none given
  double low = 0, high = 0;          // the table's range, or as bounded
  bool tied = false;                 // one value for all channels
  std::string idle;                  // why what is said of it has no effect; empty: it has

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

// Of a sum of forms. A name may stand for several parameters: "kd" for every term's, "terms[1].kd" for one's,
// and what the two widths of a form are called together ("alpha") for both. Tables of refractive indices are
// asked for the channels. Throws InputError on names that none has, values out of range or in the wrong
// number, and on what has no effect.
Constraints resolve(std::span<const Reflectance> forms, std::span<const std::string> channels,
                    const FitOptions& options);

// "ward", "oren_nayar+ward".
std::string name_of_sum(std::span<const Reflectance> forms);

// A parameter's name in a sum of so many terms: "alpha_x", or "terms[1].alpha_x".
std::string name_in_sum(std::size_t terms, std::size_t term, std::string_view parameter);

}  // namespace brdf::fit
