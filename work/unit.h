// One unit of a plan: what is done for it, and what the units hold together.
#pragma once

#include <cstdint>
#include <filesystem>

#include "work/files.h"
#include "work/task.h"

namespace brdf::work {

// Does the unit and writes its result; returns at once where that is there. `check` reads the inputs again
// and compares them with the plan. Throws where it could not be done; where the caller stops it, nothing is
// written.
void do_unit(const Task& task, std::size_t unit, std::uint64_t memory, bool check, const Caller& caller);

// What the units hold, of each kind of task. Precondition: all are done.
fit::RefitSolutions refits_of(const Task& task);
texel::Planes maps_of(const Task& task, const StackTask& stack);
// Of tables: the files that the verb writes for each, below the folder, where the verb finds and keeps them.
void unpack_units(const Task& task, const std::filesystem::path& folder);

}  // namespace brdf::work
