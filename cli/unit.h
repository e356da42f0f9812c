// One unit of a plan: what is done for it, and what becomes of all.
#pragma once

#include "cli/task.h"

namespace brdf::cli {

// Does the unit and writes its result; returns at once where that is there. `check` reads the inputs again and compares
// them with the plan. Throws where it could not be done; interrupted: nothing is written, and was_interrupted() is true.
void do_unit(const Task& task, std::size_t unit, std::uint64_t memory, bool check);

// What the verb writes at once, from the units' results, byte by byte the same. Precondition: all are done.
struct CollectFiles {
  std::string output, report;  // absolute
};
Exit put_together(const Task& task, const CollectFiles& files);

}  // namespace brdf::cli
