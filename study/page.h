// Writes the page of one sample, in an order that suits readers.
#pragma once

#include <string>

#include "study/sample.h"

namespace brdf::study {

// Returns the page: the verdict with its warnings, spheres, slices, deviations of the fit, lobes,
// parameters, properties, forms, data sheet, files and commands. The page is self-contained except for
// links to the other files in its folder.
std::string sample_page(const Findings& found, const SampleOptions& options);

}  // namespace brdf::study
