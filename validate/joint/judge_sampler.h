// Judges a reflectance, its sampler and its density together.
#pragma once

#include <string>
#include <vector>

#include "brdf/direction_sampler.h"
#include "validate/search/options.h"
#include "validate/search/subject.h"

namespace brdf::validate {

// The checks of judge_sampler(), in the order of its findings.
inline constexpr std::string_view kSamplerChecks[] = {
    "density_mass", "density_match",   "sample_value", "jacobian",    "sample_distribution",
    "sample_mean",  "density_support", "sample_range", "sample_float"};

// Probability that any statistical test of a run fails by chance for a right sampler.
inline constexpr double kFalseAlarm = 1e-6;

// Runs the checks at several parameters and viewing directions and returns one finding for each check,
// without subject and name. A check without its functions is undecided and names the missing function.
// `draws`: samples of each case; 0: a quarter of a million, and a million with Effort::full.
std::vector<Finding> judge_sampler(const Subject& subject, const DirectionSampler& sampler,
                                   const CheckOptions& options, std::size_t draws = 0);

}  // namespace brdf::validate
