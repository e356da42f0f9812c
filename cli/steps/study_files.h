// The terminal output of a study.
#pragma once

#include <string>
#include <vector>

#include "cli/verb.h"
#include "study/study.h"

namespace brdf::cli {

// Prints a line for each sample, or JSON if `json` is true, and on stderr the reason for each sample without
// a study. The text ends with the next step, which shows the samples in the window only if `is_readable` is
// true: the window reads them without --quantity, --mirror-side and --layout.
Exit print_study(const std::vector<study::Row>& rows, const std::filesystem::path& folder, bool json,
                 bool is_readable);

}  // namespace brdf::cli
