// What a table of measurements is worth, before anything is fitted to it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/html_report.h"
#include "io/samples.h"
#include "validate/finding.h"

namespace brdf::validate {

// The reflected fraction of light from one direction, integrated over the samples.
struct MeasuredAlbedo {
  double theta_i;                    // degrees
  double coverage;                   // fraction of the projected hemisphere within reach of a sample
  std::vector<double> value, bound;  // per channel
  std::vector<double> least;         // what the covered part reflects at least, per channel
};

struct DataSheet {
  std::vector<Finding> findings;
  std::vector<MeasuredAlbedo> albedo;
  std::vector<std::pair<std::string, std::string>> facts;  // rows, channels, angles, ...
};

// Checks: negative, missing, duplicates; the angles: angle_unit (radians?), polar_angle (elevations?), azimuth
// (the other convention?), directions (is a pole's azimuth without effect?); outliers, saturation; reciprocity
// (exact pairs), noise_floor (scatter about a smooth law), cosine_factor and quantity (are the values f_r?),
// isotropy, coverage, energy. What the table does not allow is not_applicable, and says why; what it is too coarse
// for is undecided. A fault is named once: the checks that it would mislead are then not_applicable.
// `max_theta` in degrees: outliers beyond it are named apart.
DataSheet data_sheet(const io::SampleTable& table, double max_theta = 90);

// Of a table whose reader refused it because columns are exchanged, and said why.
DataSheet exchanged_columns(const io::SampleTable& table, const std::string& why);

// The names of its checks.
std::vector<std::string> data_sheet_names();

void add_to_report(io::HtmlReport& report, const io::SampleTable& table, const DataSheet& sheet);

}  // namespace brdf::validate
