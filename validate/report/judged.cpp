#include "validate/report/judged.h"

#include <algorithm>

#include "io/columns/foreign_json.h"
#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/formats/read.h"

namespace brdf::validate {
namespace {

// Describes the fit that a material came from, as recorded in the material's file; empty if there is no
// record.
std::string fit_text(const io::Json& fit) {
  const char* const key = "median_relative_error";
  if (!fit.is_object() || !fit.contains(key) || !fit[key].is_number()) return "";
  return "median error (fitted) " + io::percent(fit[key].get<double>(), 2);
}

}  // namespace

void add_material(ReportContent& content, const std::string& name, io::MaterialFile file) {
  if (std::string fit = fit_text(file.fit); !fit.empty()) content.fits[name] = std::move(fit);
  content.subjects.push_back(Subject::material(name, std::move(file.material)));
}

void add_table(ReportContent& content, io::SampleTable table) {
  sheet::DataSheet sheet = sheet::data_sheet(table, {content.max_theta, content.keep_fill});
  content.tables.push_back({std::move(table), std::move(sheet)});
}

void add_file(ReportContent& content, const std::string& path, const io::Supplied& supplied) {
  io::Content bytes = io::read_content(path);
  const std::string name = bytes.name;
  if (io::may_be_material(bytes)) return add_material(content, name, io::read_material_file(bytes));
  try {
    add_table(content, io::read_samples(std::move(bytes), supplied));
  } catch (const ExchangedColumns& e) {
    io::SampleTable table;
    table.source = name;
    content.tables.push_back({table, sheet::exchanged_columns(table, e.what())});
  }
}

void check_max_theta(double degrees) {
  if (!(degrees > 0 && degrees <= 90))
    throw InputError("--max-theta " + io::to_text(degrees) + ": must be above 0 and at most 90 degrees");
}

void judge_all(ReportContent& content, const CheckOptions& options, const io::Progress& progress) {
  content.findings = run_checks(content.subjects, options, progress);
  for (const MeasuredTable& measured : content.tables)
    content.findings.insert(content.findings.end(), measured.sheet.findings.begin(),
                            measured.sheet.findings.end());
}

std::vector<std::string> required_names() {
  std::vector<std::string> known = check_names();
  for (const std::string& name : sheet::data_sheet_names()) known.push_back(name);
  return known;
}

void check_required(const std::vector<std::string>& names) {
  const std::vector<std::string> known = required_names();
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end())
      throw InputError("--require " + name + ": unknown check; known: " + io::joined(known));
}

bool holds(const std::vector<Finding>& findings, const std::vector<std::string>& required) {
  return std::ranges::all_of(findings, [&](const Finding& f) {
    const bool needed = std::ranges::find(required, f.check) != required.end();
    return needed ? f.outcome == Outcome::pass : f.outcome != Outcome::fail;
  });
}

}  // namespace brdf::validate
