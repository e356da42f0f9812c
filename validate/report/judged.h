// Collects the forms, materials and tables that a user wants to have judged, and judges them together.
#pragma once

#include <string>
#include <vector>

#include "io/columns/supplied.h"
#include "io/material/material_json.h"
#include "validate/report/report.h"

namespace brdf::validate {

// Adds a material under a name, with the fit that it came from.
void add_material(ReportContent& content, const std::string& name, io::MaterialFile file);
// Adds a table with its data sheet, up to content.max_theta.
void add_table(ReportContent& content, io::SampleTable table);
// Adds the file of a material or a table; the kind is detected from the content. A table that cannot be
// read because two columns are exchanged is added with this finding. Throws InputError if the file cannot
// be read for another reason.
void add_file(ReportContent& content, const std::string& path, const io::Supplied& supplied = {});

// Throws InputError unless `degrees` is a valid largest angle, above 0 and at most 90.
void check_max_theta(double degrees);
// Runs the checks of every subject. The findings of the tables follow.
void judge_all(ReportContent& content, const CheckOptions& options, const io::Progress& progress = {});

// Returns the names of the checks that can be required, for reflectances and for tables.
std::vector<std::string> required_names();
// Throws InputError if a name is not the name of a check.
void check_required(const std::vector<std::string>& names);
// Returns whether every required check passes and no other check fails.
bool holds(const std::vector<Finding>& findings, const std::vector<std::string>& required);

}  // namespace brdf::validate
