// The fit of one table: the output of its results.
#pragma once

#include <optional>
#include <string>

#include "cli/verb.h"
#include "fit/fit.h"
#include "io/samples/samples.h"

namespace brdf::cli {

struct FitTargets {
  std::string material, report;  // file names; empty: not written
  std::string samples;  // file that `brdf view` can show next to the material; empty: no such file is known
  bool json = false;    // prints JSON on stdout instead of text
  std::optional<double> tolerance = {};  // of the median error (fitted), a fraction
};
// Writes the material and the report. Prints the result as text with the next step, or as JSON.
// The exit code is that of a failed result if the fit misses the tolerance.
Exit write_fit(const fit::FitResult& result, const io::SampleTable& table, const fit::FitOptions& options,
               const FitTargets& targets);

}  // namespace brdf::cli
