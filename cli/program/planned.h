// Planned jobs, and the combination of their results.
#pragma once

#include <string>

#include "cli/verb.h"
#include "work/task.h"

namespace brdf::cli {

// Reads a planned job. From then on, file names are resolved relative to the folder of the plan, and outputs
// record the equivalent command without a plan. Throws InputError.
work::Task planned(const std::string& job);

struct CollectFiles {
  std::string output, report;  // absolute paths
};
// Writes the output of the verb from the results of the units, byte by byte identical to a direct run.
// Precondition: all units are done.
Exit put_together(const work::Task& task, const CollectFiles& files);

}  // namespace brdf::cli
