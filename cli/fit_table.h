// The fit of one table: what comes before it and what is written of it.
#pragma once

#include <string>

#include "cli/verbs.h"
#include "fit/fit.h"
#include "io/samples.h"

namespace brdf::cli {

// What is fitted, read and arranged as the options ask; warnings go to stderr.
fit::Samples samples_to_fit(const std::string& file, const fit::FitOptions& options);

struct FitTargets {
  std::string material, report;  // files; empty: none
  bool json = false;             // on stdout, in place of the text
};
Exit write_fit(const fit::FitResult& result, const io::SampleTable& table, const fit::FitOptions& options,
               const FitTargets& targets);

}  // namespace brdf::cli
