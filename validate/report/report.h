// Findings as a table for the terminal, JSON, Markdown and HTML.
#pragma once

#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "io/files/json.h"
#include "io/page/html_report.h"
#include "sheet/data_sheet.h"
#include "validate/form/checks.h"

namespace brdf::validate {

void print_findings(std::ostream& out, const std::vector<Finding>& findings, bool colour);
using sheet::to_json;
std::string to_markdown(const std::vector<Finding>& findings);

struct Picture {
  std::string name, png;  // the file's bytes
};

struct MeasuredTable {
  io::SampleTable table;
  sheet::DataSheet sheet;
};

struct ReportContent {
  std::vector<Finding> findings;
  std::vector<Subject> subjects;
  std::vector<MeasuredTable> tables;
  std::vector<Picture> pictures;
  std::map<std::string, std::string> fits;  // by subject: a clause on the fit that the material came from
  double max_theta = 89.5;                  // degrees, to which plots go
  bool keep_fill = false;                   // of tables: rows of fill values are judged like others
};

// Verdict, pictures in a row with a line each, properties as a matrix, then the plots of each table and
// subject, with the command that prints the same numbers folded beneath.
std::string to_html(const ReportContent& content);

// The verdict over all: "all 12 checks passed", or how many did not.
std::string summary(const std::vector<Finding>& findings);

// A row for each check, a column for each subject; what applies to none is folded away.
void add_properties(io::HtmlReport& report, const std::vector<Finding>& findings);

}  // namespace brdf::validate
