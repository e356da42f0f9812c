// The checks. Each takes a subject and returns a finding. A check searches directions and the subject's
// whole parameter domain for the largest violation; a material contributes only its own parameters. Whether
// a violation was declared is judged afterwards.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/parallel.h"
#include "validate/outside/outside_checks.h"
#include "validate/search/finding.h"
#include "validate/search/options.h"
#include "validate/search/subject.h"

namespace brdf::validate {

// Checks that f and f cos are finite for every direction: below and at the horizon, coincident, opposite
// and subnormal.
Finding check_finite(const Subject& subject, const CheckOptions& options);
// Checks that the lowest f is not below 0.
Finding check_non_negative(const Subject& subject, const CheckOptions& options);
// Checks f(i, o) = f(o, i) on all pairs of a grid of cosines graded from 1 to 1e-6, and by a search between
// them.
Finding check_reciprocity(const Subject& subject, const CheckOptions& options);
// Checks that the directional albedo, with the light fixed, does not exceed 1.
Finding check_energy(const Subject& subject, const CheckOptions& options);
// Checks that the albedo agrees with closed forms from the literature, if there are any.
Finding check_albedo(const Subject& subject, const CheckOptions& options);
// Checks that isotropic forms are invariant under a quarter turn of the sample, and that anisotropic forms
// are symmetric about their tangent.
Finding check_isotropy(const Subject& subject, const CheckOptions& options);
// Checks that f cos_i fades to 0 as the light approaches the horizon, without a jump to 0 there.
Finding check_continuity(const Subject& subject, const CheckOptions& options);
// Checks that the slope distribution of a microfacet form is normalised.
Finding check_normalisation(const Subject& subject, const CheckOptions& options);
// Checks that the masking of a microfacet form leaves exactly the projected area visible (the weak white
// furnace test).
Finding check_white_furnace(const Subject& subject, const CheckOptions& options);
// Checks that f cos_i over the sampling density averages to the albedo.
Finding check_sampling(const Subject& subject, const CheckOptions& options);
// Checks that derivatives by dual numbers agree with finite differences.
Finding check_derivatives(const Subject& subject, const CheckOptions& options);

// One check, with all that callers need to know about it. A check does not put its own name into its
// finding; the code that runs the check does.
struct Check {
  // outside: only for outside code; sampled: only for outside code with a sampler or a density of its own,
  // and for forms of the catalogue if their samplers are judged as well.
  enum class Of { all, outside, sampled };
  std::string_view name, meaning;
  double cost;  // approximate, relative to the other checks
  Of of;
  // Null for the checks of a sampler, which judge_sampler() runs together.
  Finding (*run)(const Subject&, const CheckOptions&) = nullptr;
};
// All checks, in order.
inline constexpr Check kChecks[] = {
    {"finite", "Whether every value is finite, for all directions.", 0.1, Check::Of::all, check_finite},
    {"undefined", "Whether a shader's value depends on operations that its language leaves undefined.", 1,
     Check::Of::outside, check_undefined},
    {"non_negative", "Whether no value is below 0.", 1.1, Check::Of::all, check_non_negative},
    {"reciprocity",
     "Whether exchanging the two directions leaves the value unchanged (Helmholtz reciprocity).", 1,
     Check::Of::all, check_reciprocity},
    {"energy",
     "Whether the directional albedo is at most 1 at every angle of incidence (energy conservation).", 20,
     Check::Of::all, check_energy},
    {"albedo", "Whether the integrated directional albedo agrees with its closed form, if the form has one.",
     0.2, Check::Of::all, check_albedo},
    {"normalisation", "Whether the projected areas of the microfacets add up to the area of the surface.", 2,
     Check::Of::all, check_normalisation},
    {"white_furnace",
     "Whether the visible microfacets have the projected area that masking predicts (weak white furnace, "
     "Heitz 2014).",
     5, Check::Of::all, check_white_furnace},
    {"isotropy",
     "Whether the value is independent of rotations about the normal, or symmetric about two axes.", 1.2,
     Check::Of::all, check_isotropy},
    {"continuity",
     "Whether f cos_i tends to 0 continuously as the incident direction approaches the horizon.", 1.5,
     Check::Of::all, check_continuity},
    {"sampling", "Whether the mean of the form's importance sampling equals the directional albedo.", 1,
     Check::Of::all, check_sampling},
    {"density_mass",
     "Whether the density of a sampler integrates to 1 minus the share of samples that are lost.", 10,
     Check::Of::sampled},
    {"density_match", "Whether the density that the sampler returns equals the density function.", 10,
     Check::Of::sampled},
    {"sample_value", "Whether the value that the sampler returns is f, f cos_i or f cos_i / pdf, as stated.",
     10, Check::Of::sampled},
    {"jacobian",
     "Whether the density equals the area of random numbers per area of directions, without noise.", 10,
     Check::Of::sampled},
    {"sample_distribution", "Whether a histogram of samples follows the density (chi-square test).", 10,
     Check::Of::sampled},
    {"sample_mean", "Whether the mean of the weights f cos_i / pdf is the directional albedo.", 10,
     Check::Of::sampled},
    {"density_support", "Whether the density is above 0 wherever f cos_i is.", 10, Check::Of::sampled},
    {"sample_range",
     "Whether sampled directions have unit length and lie above the horizon, also for random numbers 0 and "
     "1.",
     10, Check::Of::sampled},
    {"sample_float", "Whether the sampler gives the same in single and in double precision.", 10,
     Check::Of::sampled},
    {"derivatives", "Whether exact derivatives agree with finite differences.", 1, Check::Of::all,
     check_derivatives},
    {"float",
     "Whether a shader's values in single precision, and in half precision if it has types of 16 bits, agree "
     "with its formula in double precision.",
     1, Check::Of::outside, check_float},
};

// Runs a check within options.seconds. If its searches are cut short, the statement reports how far they
// came, and a pass becomes undecided.
Finding within_seconds(CheckOptions options, const std::function<Finding(const CheckOptions&)>& check);

// Runs all checks of all subjects in order, on all processors, and judges them against the violations that
// the forms declare. Throws InputError if outside code declares a violation of an unknown check.
// Example:
//     // #include "brdf/io/material/material_file.h"
//     using brdf::validate::Subject;
//     const Subject copper = Subject::material("copper", brdf::io::read_material("copper.json"));
//     for (const auto& finding : brdf::validate::run_checks({copper}, {}))
//       std::printf("%s: %s\n", finding.check.c_str(), finding.statement.c_str());
std::vector<Finding> run_checks(const std::vector<Subject>& subjects, const CheckOptions& options,
                                const io::Progress& progress = {});

// Returns the names of all checks, in order.
std::vector<std::string> check_names();

}  // namespace brdf::validate
