// The terminal output of a study.
#pragma once

#include <string>
#include <vector>

#include "cli/verb.h"
#include "study/study.h"

namespace brdf::cli {

// Studies the samples and prints a line for each as soon as it is finished, or JSON at the end if `json` is
// true, and on stderr the reason for each sample without a study. The text ends with the next step, which
// shows the samples in the window only if `is_readable` is true: the window reads them without --quantity,
// --mirror-side and --layout.
Exit study_files(const std::vector<std::string>& samples, study::StudyOptions options, bool json,
                 bool is_readable);

}  // namespace brdf::cli
