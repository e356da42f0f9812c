// The page of one sample, in a reader's order.
#pragma once

#include <string>

#include "study/sample.h"

namespace brdf::study {

// Verdict with its warnings, spheres, slices, where the fit deviates, parameters, properties, forms, data
// sheet, files and commands. Self-contained but for links to the files beside it.
std::string sample_page(const Findings& found, const SampleOptions& options);

}  // namespace brdf::study
