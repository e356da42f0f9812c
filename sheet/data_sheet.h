// Checks the quality of a table of measurements before anything is fitted to it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/page/html_report.h"
#include "io/samples/samples.h"
#include "sheet/finding.h"
#include "sheet/scatter.h"

namespace brdf::sheet {

// Rows beyond this polar angle (of the light or the viewer) are judged separately: near grazing incidence
// every error of an angle has a large effect.
inline constexpr double kMaxTheta = 89.5;  // degrees

struct SheetOptions {
  double max_theta = kMaxTheta;  // degrees
  bool keep_fill = false;        // judge rows of fill values like other rows
};

// The reflected fraction of light from one direction, integrated over the samples.
struct MeasuredAlbedo {
  double theta_i;             // degrees
  double coverage;            // fraction of the projected hemisphere that lies between samples
  double plane_coverage = 0;  // the same fraction of the plane of incidence, where azimuths have no weight
  std::vector<double> value, bound;  // per channel
  std::vector<double> least;  // per channel: a lower bound, the fraction reflected between samples that agree
  // Per channel: the fraction without the highlight, if all azimuths were like the plane of incidence.
  std::vector<double> in_plane;
};

struct DataSheet {
  std::vector<Finding> findings;
  std::vector<MeasuredAlbedo> albedo;
  std::vector<std::pair<std::string, std::string>> facts;  // rows, channels, angles, ...
  std::vector<bool> not_measured;  // for each row whether it holds a fill value; empty if no row does
  Scatter scatter;
  bool is_anisotropic = false;  // shown by rotations of the sample

  // Returns the findings that a fit must report before its own results: first the failed findings, then the
  // findings that are undecided and name a suspected fault.
  std::vector<const Finding*> faults() const;
  // Returns whether the check of this name fails.
  bool has_failed(std::string_view check) const;
};

// Runs every check of sheet/checks.cpp once. A check that the table does not permit is not_applicable and
// gives the reason; a check that could not have seen its fault is undecided. Each fault is reported once:
// the checks that it would mislead are then not_applicable. A large table takes as long as reading its
// file, a small one some tens of milliseconds (bench_sheet FILE).
// Example:
//     // #include "brdf/io/formats/read.h"
//     const brdf::sheet::DataSheet sheet = brdf::sheet::data_sheet(brdf::io::read_samples("paint.csv"));
//     for (const brdf::sheet::Finding* fault : sheet.faults())
//       std::printf("%s: %s\n", fault->check.c_str(), fault->statement.c_str());
DataSheet data_sheet(const io::SampleTable& table, const SheetOptions& options = {});

// Returns for each row whether it holds a fill value: the same as DataSheet::not_measured, without the
// other checks. max_theta: degrees.
std::vector<bool> not_measured(const io::SampleTable& table, double max_theta = kMaxTheta);

// Makes the named checks not_applicable, with this reason. Checks that are not_applicable already keep
// their own.
void set_apart(DataSheet& sheet, const std::vector<std::string_view>& checks, const std::string& why);

// Removes the marked rows, if any, and adds a warning with their number. `rows`: one entry per row, or
// empty.
void leave_out(const std::vector<bool>& rows, io::SampleTable& table);

// Returns the data sheet of a table that the reader refused because columns are exchanged. `why`: the
// reader's reason.
DataSheet exchanged_columns(const io::SampleTable& table, const std::string& why);

// Returns the names of the checks, and the question that each check answers; empty for an unknown name.
std::vector<std::string> data_sheet_names();
std::string_view check_meaning(std::string_view check);

// Adds a table of the facts and plots of the values and of the reflected fractions to the report.
void add_to_report(io::HtmlReport& report, const io::SampleTable& table, const DataSheet& sheet);

}  // namespace brdf::sheet
