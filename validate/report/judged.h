// What a user asks to be judged (forms, materials, tables), gathered and judged together.
#pragma once

#include <string>
#include <vector>

#include "io/columns/supplied.h"
#include "io/material/material_json.h"
#include "validate/report/report.h"

namespace brdf::validate {

// A material under a name, with the fit that it came from.
void add_material(ReportContent& content, const std::string& name, io::MaterialFile file);
// A table with its data sheet, up to content.max_theta.
void add_table(ReportContent& content, io::SampleTable table);
// A material's or a table's file, told by what it holds. A table that cannot be read because two columns are
// exchanged has that finding. Throws InputError.
void add_file(ReportContent& content, const std::string& path, const io::Supplied& supplied = {});

// Throws InputError where this is no largest angle.
void check_max_theta(double degrees);
// Runs the checks of every subject; a table's findings follow.
void judge_all(ReportContent& content, const CheckOptions& options, const io::Progress& progress = {});

// The checks that can be required: of what reflects, and of tables.
std::vector<std::string> required_names();
// Throws InputError where a name is no check's.
void check_required(const std::vector<std::string>& names);
// Whether nothing fails that need not pass, and everything required passes.
bool holds(const std::vector<Finding>& findings, const std::vector<std::string>& required);

}  // namespace brdf::validate
