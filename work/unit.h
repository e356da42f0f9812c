// One unit of a plan: its processing, and the combined content of all units.
#pragma once

#include <cstdint>
#include <filesystem>

#include "work/files.h"
#include "work/task.h"

namespace brdf::work {

// Does the unit and writes its result. Returns immediately if the result already exists. `check`: read the
// inputs again and compare them with the plan. Throws if the unit cannot be done. If the caller stops the
// work, nothing is written.
void do_unit(const Task& task, std::size_t unit, std::uint64_t memory, bool check, const Caller& caller);

// Return the combined content of the units, for each kind of task. Precondition: all units are done.
fit::RefitSolutions refits_of(const Task& task);
texel::Planes maps_of(const Task& task, const StackTask& stack);
// Unpacks the results of tables into the folder: the files that the verb writes for each table, with the
// names under which the verb finds and keeps them.
void unpack_units(const Task& task, const std::filesystem::path& folder);

}  // namespace brdf::work
