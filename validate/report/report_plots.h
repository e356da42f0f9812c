// The plots of one subject: albedo, lobes, white furnace, reciprocity.
#pragma once

#include "io/page/html_report.h"
#include "validate/search/finding.h"
#include "validate/search/subject.h"

namespace brdf::validate {

// Each with the command that prints the same numbers. `findings` are those of all subjects; `max_theta` in
// degrees.
void add_subject_plots(io::HtmlReport& report, const Subject& subject, const std::vector<Finding>& findings,
                       double max_theta);

}  // namespace brdf::validate
