// The output of a fit of several files.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/verb.h"
#include "fit/file_batch.h"

namespace brdf::cli {

// Writes the summary, and prints its location, or JSON if `json` is true.
Exit summarise(const std::vector<fit::BatchRow>& rows, const std::filesystem::path& folder, bool json);

}  // namespace brdf::cli
