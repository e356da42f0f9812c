// The checks: each goes from a subject to a finding. A check searches the subject's whole parameter domain (a
// material has its own parameters only) and directions for the largest violation; whether a violation was
// declared is judged afterwards.
#pragma once

#include <cstdint>
#include <functional>

#include "io/parallel.h"
#include "validate/budget.h"
#include "validate/finding.h"
#include "validate/subject.h"

namespace brdf::validate {

enum class Effort { quick, full };

struct CheckOptions {
  Effort effort = Effort::quick;
  double max_theta = 89.5;  // degrees, of the energy check's fixed direction
  std::uint64_t seed = 1;
  double seconds = 0;        // of each check's searches; 0: no limit
  Budget* budget = nullptr;  // of the check that runs; run_checks() sets it
};

// f and f cos are numbers, for every direction: below the horizon, at it, coincident, opposite, subnormal.
Finding check_finite(const Subject& subject, const CheckOptions& options);
// No value depends on what the shader's language leaves undefined; of code that is not ours. `share` is the share of the
// pairs inside the hemisphere at which one does.
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

// A check within the options' seconds: if its searches were cut short, it says how far they came, and a pass is undecided.
Finding within_seconds(CheckOptions options, const std::function<Finding(const CheckOptions&)>& check);

// All checks of all subjects in their order, judged against what the forms declare. On all processors.
std::vector<Finding> run_checks(const std::vector<Subject>& subjects, const CheckOptions& options,
                                const io::Progress& progress = {});

// The names of the checks, in order.
std::vector<std::string> check_names();

}  // namespace brdf::validate
