// Plots of one subject: albedo, lobes, white furnace, reciprocity.
#pragma once

#include <vector>

#include "io/page/html_report.h"
#include "validate/search/finding.h"
#include "validate/search/subject.h"

namespace brdf::validate {

// Adds the plots to the report, each with the command that prints the same numbers. `findings` are the
// findings of all subjects; `max_theta` is in degrees. `reach`: the least extent of the lobes' axes, 1/sr.
void add_subject_plots(io::HtmlReport& report, const Subject& subject, const std::vector<Finding>& findings,
                       double max_theta, double reach = 0);

// Returns the largest radius of the subjects' lobes, 1/sr, for one scale on a page.
double lobe_reach(const std::vector<Subject>& subjects);

}  // namespace brdf::validate
