// The checks of a table of measurements: their list, their input and the functions that they share.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/numbers.h"
#include "io/page/html_report.h"
#include "sheet/causes.h"
#include "sheet/data_sheet.h"
#include "sheet/fill.h"
#include "sheet/pairs.h"
#include "sheet/scatter.h"
#include "sheet/turns.h"
#include "sheet/view.h"

namespace brdf::sheet {

// The input of the checks of a scanned table. Each part is computed once.
struct Evidence {
  const io::SampleTable& read;         // the table as read
  double max_theta;                    // degrees: rows beyond it are reported separately
  const View& all;                     // without the rows beyond max_theta
  std::vector<FillValue> fill;         // fill values of `all`
  const View& view;                    // also without rows of fill values
  const View& whole;                   // without rows of fill values, but with the rows beyond max_theta
  io::Noise neighbours;                // noise of `view`
  Turns turns;                         // rotations of the sample
  std::vector<Pair> pairs;             // reciprocal pairs of `view`
  Causes causes;                       // causes of their differences
  Scatter scatter;                     // noise of `view`, from all kinds of rows that should agree
  std::vector<MeasuredAlbedo> albedo;  // for some of the lights
};

// The input of the checks of a MERL file. Its cells have neighbours by their numbers and symmetries by
// their format.
struct CellEvidence;

struct Check {
  std::string_view name;
  std::string_view meaning;  // for the glossary of a page: the question that the check answers
  Finding (*run)(const Evidence&);
  // For a MERL file: either the function that checks its cells, or the reason why the check does not apply
  // to cells.
  Finding (*run_cells)(const CellEvidence&);
  std::string_view not_of_cells;
};
// The checks, in the order in which a data sheet lists them.
std::span<const Check> checks();

// The checks of scanned tables. Each returns the finding of the check with its name.
Finding negative(const Evidence& evidence);
Finding missing(const Evidence& evidence);
Finding fill(const Evidence& evidence);
Finding duplicates(const Evidence& evidence);
Finding stuck(const Evidence& evidence);
Finding invented(const Evidence& evidence);
Finding angle_unit(const Evidence& evidence);
Finding polar_angle(const Evidence& evidence);
Finding azimuth(const Evidence& evidence);
Finding directions(const Evidence& evidence);
Finding mirror(const Evidence& evidence);
Finding outliers(const Evidence& evidence);
Finding saturation(const Evidence& evidence);
Finding reciprocity(const Evidence& evidence);
Finding cosine_factor(const Evidence& evidence);
Finding light_gain(const Evidence& evidence);
Finding drift(const Evidence& evidence);
Finding dark_level(const Evidence& evidence);
Finding noise_floor(const Evidence& evidence);
Finding quantity(const Evidence& evidence);
Finding isotropy(const Evidence& evidence);
Finding coverage(const Evidence& evidence);
Finding energy(const Evidence& evidence);

// The checks of the cells of MERL files.
Finding missing(const CellEvidence& evidence);
Finding negative(const CellEvidence& evidence);
Finding outliers(const CellEvidence& evidence);
Finding saturation(const CellEvidence& evidence);
Finding quantity(const CellEvidence& evidence);
Finding coverage(const CellEvidence& evidence);
Finding energy(const CellEvidence& evidence);
// Runs the checks of a MERL file. max_theta: degrees.
DataSheet sheet_of_cells(const io::SampleTable& table, double max_theta);
// Returns the values of a MERL file in the plane of incidence over the viewing angle, which is positive on
// the mirror side. The light is at theta_i (degrees).
io::Series cells_in_plane(const io::SampleTable& table, double theta_i);

// --- Shared by scans and cells ---------------------------------------------------------------------------

// The least coverage of the projected hemisphere for an integral.
inline constexpr double kEnoughCoverage = 0.6;

// Check for values below 0, and for entries without a value.
Finding negative_of(const View& view);
Finding missing_of(const io::SampleTable& table);
// The fraction that the plane of incidence would reflect, without its highlight, if all azimuths were like
// it. The fraction is taken from the channel that reflects most. With both sides of the plane measured, it
// is the median over the lights. With the highlight's side alone it is the least over the lights, since on
// that side even half of the weight may be bright.
struct Plane {
  double reflected;  // 0 if no light covers enough of the plane
  bool is_half;
};
// Returns that fraction from the albedos of the lights.
Plane plane_of(const std::vector<MeasuredAlbedo>& albedo);

// `scatter`: relative noise of one value; 0 if the noise is unknown.
Finding saturation_of(const View& view, double scatter);
Finding quantity_of(const View& view, const std::vector<MeasuredAlbedo>& albedo);
// Judges the rows that are far from their neighbours. Rows beyond max_theta (degrees) are named, but are no
// fault.
Finding outliers_of(const View& view, std::vector<NamedRow> rows, double max_theta);
Finding energy_of(const io::SampleTable& table, const std::vector<MeasuredAlbedo>& albedo);

// --- Tools -----------------------------------------------------------------------------------------------

using io::plural;
// Returns the places of the first five rows for a message. Each line of the file is named once.
std::string places(const View& view, std::span<const Row> rows);
// Returns a row of the view for a finding, alone or with the value of a channel.
NamedRow named_row(const View& view, Row row);
NamedRow named_row(const View& view, Row row, std::size_t channel);
// Return a finding that passes and has no statement yet, or an undecided finding with its reason.
Finding start(const io::SampleTable& table, std::string_view check);
Finding undecided(const io::SampleTable& table, std::string_view check, std::string why);
// Returns a failed finding that names the first rows if there are any rows; otherwise a finding that
// passes.
Finding counted(const View& view, std::string_view check, const std::vector<Row>& rows,
                const std::string& clean, const std::string& fault);
// Returns for each row whether both polar angles are at most max_theta (degrees).
std::vector<bool> within(const io::SampleTable& table, double max_theta);

// Returns the power of ten of which all values are multiples; 0 if the values have more than 12 decimals.
double resolution(const std::vector<double>& values);
// Returns whether some value is above 0.
bool has_light(const io::SampleTable& table);
// Returns whether every channel has the same value in all rows.
bool is_constant(const io::SampleTable& table);
// Returns whether the rows are cells of a MERL file.
bool is_of_cells(const io::SampleTable& table);

}  // namespace brdf::sheet
