// The checks of a table of measurements: the one list of them, what they look at, and what they share.
#pragma once

#include <map>
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

// All that the checks of a scanned table look at, found once.
struct Evidence {
  const io::SampleTable& read;         // the table as it was read
  double max_theta;                    // degrees: rows beyond it are set apart
  const View& all;                     // without those
  std::vector<FillValue> fill;         // of `all`
  const View& view;                    // without rows of fill values, too
  const View& whole;                   // without rows of fill values, but with those beyond max_theta
  io::Noise neighbours;                // of `view`
  Turns turns;                         // of the sample
  std::vector<Pair> pairs;             // reciprocal ones of `view`
  Causes causes;                       // of their differences
  Scatter scatter;                     // of `view`
  std::vector<MeasuredAlbedo> albedo;  // for some of the lights
};

// The cells of a MERL file, which have neighbours by their numbers and symmetries by their format.
struct CellEvidence;

struct Check {
  std::string_view name;
  std::string_view meaning;  // for a page's glossary: what the check asks
  Finding (*run)(const Evidence&);
  // Of a MERL file: another function, or else why the check says nothing of its cells.
  Finding (*run_cells)(const CellEvidence&);
  std::string_view not_of_cells;
};
// In the order in which a sheet lists them.
std::span<const Check> checks();

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

Finding missing(const CellEvidence& evidence);
Finding negative(const CellEvidence& evidence);
Finding outliers(const CellEvidence& evidence);
Finding saturation(const CellEvidence& evidence);
Finding quantity(const CellEvidence& evidence);
Finding coverage(const CellEvidence& evidence);
Finding energy(const CellEvidence& evidence);
DataSheet sheet_of_cells(const io::SampleTable& table, double max_theta);
// The values of a MERL file in the plane of incidence against the viewer's angle (mirror side positive),
// light at theta_i.
io::Series cells_in_plane(const io::SampleTable& table, double theta_i);

// --- Shared by scans and cells ---------------------------------------------------------------------------

inline constexpr double kEnoughCoverage = 0.6;  // of the projected hemisphere, for an integral

Finding negative_of(const View& view);
Finding missing_of(const io::SampleTable& table);
// What the plane of incidence reflects beside its highlight, if it stood for all azimuths: over the lights of
// the channel that reflects most the median, and of the highlight's side alone the least, since there even
// half of the weight may be bright.
struct Plane {
  double reflected;  // 0 where no light covers enough of the plane
  bool is_half;
};
Plane plane_of(const std::vector<MeasuredAlbedo>& albedo);

// `scatter`: relative, 0 where it is not known.
Finding saturation_of(const View& view, double scatter);
Finding quantity_of(const View& view, const std::vector<MeasuredAlbedo>& albedo);
// The rows far from their neighbours, those beyond max_theta apart.
Finding outliers_of(const View& view, std::vector<NamedRow> rows, double max_theta);
Finding energy_of(const io::SampleTable& table, const std::vector<MeasuredAlbedo>& albedo);

// --- Tools -----------------------------------------------------------------------------------------------

using io::plural;
// The first places of a list, for people, each line once.
std::string places(const View& view, std::span<const Row> rows);
NamedRow named_row(const View& view, Row row);
NamedRow named_row(const View& view, Row row, std::size_t channel);
Finding start(const io::SampleTable& table, std::string_view check);
Finding undecided(const io::SampleTable& table, std::string_view check, std::string why);
// `fail` where there are rows, naming the first of them.
Finding counted(const View& view, std::string_view check, const std::vector<Row>& rows,
                const std::string& clean, const std::string& fault);
// Of each row whether both polar angles are at most max_theta, in degrees.
std::vector<bool> within(const io::SampleTable& table, double max_theta);

// The power of ten that all values are multiples of; 0 where they have more than 12 decimals.
double resolution(const std::vector<double>& values);
// Whether the rows are cells of a MERL file.
bool is_of_cells(const io::SampleTable& table);

}  // namespace brdf::sheet
