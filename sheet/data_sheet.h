// What a table of measurements is worth, before anything is fitted to it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/page/html_report.h"
#include "io/samples/samples.h"
#include "sheet/finding.h"
#include "sheet/scatter.h"

namespace brdf::sheet {

// Rows beyond this polar angle (of light or viewer) are set apart: near grazing every error of an angle is
// large.
inline constexpr double kMaxTheta = 89.5;  // degrees

struct SheetOptions {
  double max_theta = kMaxTheta;  // degrees
  bool keep_fill = false;        // rows of fill values are judged like others
};

// The reflected fraction of light from one direction, integrated over the samples.
struct MeasuredAlbedo {
  double theta_i;                    // degrees
  double coverage;                   // fraction of the projected hemisphere that lies between samples
  double plane_coverage = 0;         // the same of the plane of incidence, in which azimuths have no weight
  std::vector<double> value, bound;  // per channel
  std::vector<double> least;  // a lower bound: what is reflected between samples that agree, per channel
  std::vector<double>
      in_plane;  // per channel: if the plane of incidence stood for all azimuths, without the highlight
};

struct DataSheet {
  std::vector<Finding> findings;
  std::vector<MeasuredAlbedo> albedo;
  std::vector<std::pair<std::string, std::string>> facts;  // rows, channels, angles, ...
  std::vector<bool> not_measured;  // of each row: it holds a fill value; empty where no row does
  Scatter scatter;
  bool is_anisotropic = false;  // turns of the sample show it

  // What a fit must say before it says anything else: the findings that fail, then the quantity where it is
  // in doubt.
  std::vector<const Finding*> faults() const;
  // Whether the check of this name fails.
  bool has_failed(std::string_view check) const;
};

// Every check of sheet/checks.cpp, once. A check that the table says nothing about is not_applicable, and
// says why; one that would not have seen its fault is undecided. A fault is named once: the checks that it
// would mislead are then not_applicable. Large tables take as long as their file takes to read, small ones
// some tens of milliseconds (bench_sheet FILE).
DataSheet data_sheet(const io::SampleTable& table, const SheetOptions& options = {});

// Of each row whether it holds a fill value: the same as DataSheet::not_measured, without the other checks.
std::vector<bool> not_measured(const io::SampleTable& table, double max_theta = kMaxTheta);

// Makes checks not_applicable, with this reason.
void set_apart(DataSheet& sheet, const std::vector<std::string_view>& checks, const std::string& why);

// Leaves out the marked rows, if any, and adds a warning that says so. `rows`: of each row, or empty.
void leave_out(const std::vector<bool>& rows, io::SampleTable& table);

// Of a table whose reader refused it because columns are exchanged, and said why.
DataSheet exchanged_columns(const io::SampleTable& table, const std::string& why);

// The names of its checks, and what each asks; empty of another name.
std::vector<std::string> data_sheet_names();
std::string_view check_meaning(std::string_view check);

void add_to_report(io::HtmlReport& report, const io::SampleTable& table, const DataSheet& sheet);

}  // namespace brdf::sheet
