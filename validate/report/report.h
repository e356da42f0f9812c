// Writes findings as a table for the terminal, as JSON, as Markdown and as HTML.
#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "io/files/json.h"
#include "io/page/html_report.h"
#include "sheet/data_sheet.h"
#include "validate/form/checks.h"

namespace brdf::validate {

// Prints the findings as a table for the terminal; `colour`: with ANSI colours.
void print_findings(std::ostream& out, const std::vector<Finding>& findings, bool colour);
using sheet::to_json;
// Returns the findings as a Markdown table, with the summary above.
std::string to_markdown(const std::vector<Finding>& findings);

// Returns the meaning of a check in one sentence, for readers who do not know the checks; empty if there is
// no such check.
std::string_view check_meaning(std::string_view check);

struct Picture {
  std::string name, png;  // the content of the PNG file
};

struct MeasuredTable {
  io::SampleTable table;
  sheet::DataSheet sheet;
};

struct ReportContent {
  std::vector<Finding> findings;  // without subjects and tables, the page has no plots
  std::vector<Subject> subjects;
  std::vector<MeasuredTable> tables;
  std::vector<Picture> pictures;
  std::map<std::string, std::string> fits;  // by subject: a clause on the fit that the material came from
  double max_theta = 89.5;                  // degrees, the largest angle of the plots
  bool keep_fill = false;                   // of tables: judge rows of fill values like other rows
};

// Returns the report as an HTML page: the verdict, the pictures in a row with one line each, the properties
// as a matrix, then the plots of each table and subject. The command that prints the same numbers is folded
// beneath each plot.
// Example:
//     brdf::validate::ReportContent content;
//     content.subjects = {brdf::validate::Subject::form(*brdf::find_form("phong"))};
//     content.findings = {check_reciprocity(content.subjects.front(), {})};
//     std::ofstream("phong.html") << to_html(content);
//     std::printf("%s\n", brdf::validate::summary(content.findings).c_str());
std::string to_html(const ReportContent& content);

// Returns the overall verdict: how many checks passed, and how many failed, are known violations, undecided
// or not applicable.
std::string summary(const std::vector<Finding>& findings);

// Adds a matrix with a row for each check and a column for each subject. Checks that apply to no subject
// are folded away.
void add_properties(io::HtmlReport& report, const std::vector<Finding>& findings);

}  // namespace brdf::validate
