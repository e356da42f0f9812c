// The fit of one table: what comes before it and what is written of it.
#pragma once

#include <string>

#include "cli/verb.h"
#include "fit/fit.h"
#include "io/samples/samples.h"

namespace brdf::cli {

struct FitTargets {
  std::string material, report;  // files; empty: none
  bool json = false;             // on stdout, in place of the text
};
Exit write_fit(const fit::FitResult& result, const io::SampleTable& table, const fit::FitOptions& options,
               const FitTargets& targets);

}  // namespace brdf::cli
