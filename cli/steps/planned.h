#pragma once

#include <string>

#include "cli/verb.h"
#include "work/task.h"

namespace brdf::cli {

// A job that was planned. Names are looked up where it was planned from now on, and outputs name the command
// that does the same at once. Throws InputError.
work::Task planned(const std::string& job);

struct CollectFiles {
  std::string output, report;  // absolute
};
// What the verb writes at once, from the units' results, byte by byte the same. Precondition: all units are
// done.
Exit put_together(const work::Task& task, const CollectFiles& files);

}  // namespace brdf::cli
