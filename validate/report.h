// Findings as a table for the terminal, JSON, Markdown and HTML.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "io/html_report.h"
#include "io/json.h"
#include "validate/checks.h"
#include "validate/data_sheet.h"

namespace brdf::validate {

void print_findings(std::ostream& out, const std::vector<Finding>& findings, bool colour);
io::Json to_json(const Finding& finding);
io::Json to_json(const std::vector<Finding>& findings);
std::string to_markdown(const std::vector<Finding>& findings);

struct Picture {
  std::string name, png;  // the file's bytes
};

struct MeasuredTable {
  io::SampleTable table;
  DataSheet sheet;
};

struct ReportContent {
  std::vector<Finding> findings;
  std::vector<Subject> subjects;
  std::vector<MeasuredTable> tables;
  std::vector<Picture> pictures;
  double max_theta = 89.5;  // degrees, to which plots go
};

// Verdicts first, then the plots of each subject and table, with the command that prints the same numbers.
std::string to_html(const ReportContent& content);

// The verdict over all: "all 12 checks passed", or how many did not.
std::string summary(const std::vector<Finding>& findings);

// A table of verdicts for each subject.
void add_tables(io::HtmlReport& report, const std::vector<Finding>& findings);

}  // namespace brdf::validate
