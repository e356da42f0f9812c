// The checks: each goes from a subject to a finding. A check searches the subject's whole parameter domain (a
// material has its own parameters only) and directions for the largest violation; whether a violation was
// declared is judged afterwards.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/parallel.h"
#include "validate/search/finding.h"
#include "validate/search/options.h"
#include "validate/search/subject.h"

namespace brdf::validate {

// f and f cos are numbers, for every direction: below the horizon, at it, coincident, opposite, subnormal.
Finding check_finite(const Subject& subject, const CheckOptions& options);
// No value depends on what the shader's language leaves undefined; of code that is not ours. `share` is the
// share of the pairs inside the hemisphere at which one does.
Finding check_undefined(const Subject& subject, const CheckOptions& options);
// The lowest f is not below 0.
Finding check_non_negative(const Subject& subject, const CheckOptions& options);
// f(i, o) = f(o, i): all pairs of a grid of cosines graded from 1 to 1e-6, and the search between them.
Finding check_reciprocity(const Subject& subject, const CheckOptions& options);
// The directional albedo with the light fixed does not exceed 1.
Finding check_energy(const Subject& subject, const CheckOptions& options);
// The albedo agrees with closed forms of the literature, where there are some.
Finding check_albedo(const Subject& subject, const CheckOptions& options);
// Isotropic forms do not see a quarter turn of the sample;
// anisotropic ones are symmetric about their tangent.
Finding check_isotropy(const Subject& subject, const CheckOptions& options);
// f cos_i fades out as the light sets, instead of jumping to 0 at the horizon.
Finding check_continuity(const Subject& subject, const CheckOptions& options);
// The distribution of slopes of a microfacet form is normalised.
Finding check_normalisation(const Subject& subject, const CheckOptions& options);
// The masking of a microfacet form leaves exactly the projected area visible (the weak white furnace).
Finding check_white_furnace(const Subject& subject, const CheckOptions& options);
// f cos_i over the sampling density averages to the albedo.
Finding check_sampling(const Subject& subject, const CheckOptions& options);
// Float agrees with double of the same code; of code that is not ours.
Finding check_float(const Subject& subject, const CheckOptions& options);
// Derivatives by dual numbers agree with differences.
Finding check_derivatives(const Subject& subject, const CheckOptions& options);

// One of them, with all that others need to know of it. A check does not name its finding: whoever runs it
// does.
struct Check {
  enum class Of { all, outside };  // outside: of code that is not ours alone
  std::string_view name, meaning;
  double cost;  // about, relative to the others
  Of of;
  Finding (*run)(const Subject&, const CheckOptions&);
};
// All of them, in order.
inline constexpr Check kChecks[] = {
    {"finite", "Whether every value is a number, whatever the directions.", 0.1, Check::Of::all,
     check_finite},
    {"undefined", "Whether a shader's value depends on what its language leaves undefined.", 1,
     Check::Of::outside, check_undefined},
    {"non_negative", "Whether no value is below 0.", 1.1, Check::Of::all, check_non_negative},
    {"reciprocity", "Whether light and viewer may change places without changing the value (Helmholtz).", 1,
     Check::Of::all, check_reciprocity},
    {"energy",
     "Whether no light gives back more than it brings: the reflected fraction is at most 1 at every angle.",
     20, Check::Of::all, check_energy},
    {"albedo", "Whether the integrated reflected fraction agrees with its closed form, where there is one.",
     0.2, Check::Of::all, check_albedo},
    {"normalisation", "Whether the facets' projected areas add up to the surface's area.", 2, Check::Of::all,
     check_normalisation},
    {"white_furnace",
     "Whether the facets that one sees have just the area that the masking leaves (weak white furnace, Heitz "
     "2014).",
     5, Check::Of::all, check_white_furnace},
    {"isotropy",
     "Whether turning the surface about its normal changes nothing, or does so along two axes only.", 1.2,
     Check::Of::all, check_isotropy},
    {"continuity", "Whether the reflected light fades out as the light sets, without a step.", 1.5,
     Check::Of::all, check_continuity},
    {"sampling", "Whether random directions drawn for this form average to the reflected fraction.", 1,
     Check::Of::all, check_sampling},
    {"derivatives", "Whether derivatives computed exactly agree with differences of values.", 1,
     Check::Of::all, check_derivatives},
    {"float", "Whether a shader's values in single precision are those that its formula has in double.", 1,
     Check::Of::outside, check_float},
};

// A check within the options' seconds: if its searches were cut short, it says how far they came, and a pass
// is undecided.
Finding within_seconds(CheckOptions options, const std::function<Finding(const CheckOptions&)>& check);

// All checks of all subjects in their order, judged against what the forms declare. On all processors.
std::vector<Finding> run_checks(const std::vector<Subject>& subjects, const CheckOptions& options,
                                const io::Progress& progress = {});

std::vector<std::string> check_names();

}  // namespace brdf::validate
