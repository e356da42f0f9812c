// The checks of a table of measurements, and what they share.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/cosine_factor.h"
#include "io/reciprocal_pairs.h"
#include "validate/data_sheet.h"

namespace brdf::validate {

// Rows by themselves.
Finding negative(const io::SampleTable& table);
Finding missing(const io::SampleTable& table);
Finding duplicates(const io::SampleTable& table);
// At theta = 0 the azimuth means nothing: values that depend on it betray exchanged columns.
Finding directions(const io::SampleTable& table);
// Rows against their neighbours; those with an angle beyond max_theta (degrees) are named apart.
Finding outliers(const io::SampleTable& table, double max_theta);
// The unit and the conventions of the angles.
Finding angle_unit(const io::SampleTable& table);
// A cosine that is left in the values makes highlights fade as wrong angles do.
Finding polar_angle(const io::SampleTable& table, const io::CosineFactor& cosine);
Finding azimuth(const io::SampleTable& table);
// The values: equal largest ones; whether they can be f_r.
Finding saturation(const io::SampleTable& table);
Finding quantity(const io::SampleTable& table, const std::vector<MeasuredAlbedo>& albedo);
// Light and viewer exchanged, and the sample turned.
Finding exact_reciprocity(const io::SampleTable& table);
// The median relative difference of interpolated pairs; none where they are too few.
std::optional<double> exchanged_difference(const std::vector<io::ReciprocalPair>& pairs);
Finding noise_floor(const io::SampleTable& table, const std::vector<io::ReciprocalPair>& pairs);
Finding cosine_factor(const io::SampleTable& table, const io::CosineFactor& cosine);
Finding isotropy(const io::SampleTable& table);
// Integrals, one for each angle of the light.
MeasuredAlbedo integrate(const io::SampleTable& table, const std::vector<std::size_t>& rows, double noise);
inline constexpr double kEnoughCoverage = 0.6;  // of the projected hemisphere, for an integral
Finding coverage(const io::SampleTable& table, const std::vector<MeasuredAlbedo>& albedo);
Finding energy(const io::SampleTable& table, const std::vector<MeasuredAlbedo>& albedo);
// The least that a channel reflects: what is known of the part that is covered.
double proven(const MeasuredAlbedo& albedo, std::size_t channel);

// The checks of a MERL file's cells, which have neighbours by their numbers and symmetries by their format.
void add_cell_findings(const io::SampleTable& table, double max_theta, DataSheet& sheet);
// Its values in the plane of incidence against the viewer's angle (mirror side positive), light at theta_i.
io::Series cells_in_plane(const io::SampleTable& table, double theta_i);

// --- Tools ------------------------------------------------------------------------------------------------

std::string plural(std::size_t n, const std::string& word);

NamedRow named_row(const io::SampleTable& table, std::size_t row);
NamedRow named_row(const io::SampleTable& table, std::size_t row, std::size_t channel);

Finding start(const io::SampleTable& table, const char* check);
// `fail` where there are rows, naming the first of them.
Finding counted(const io::SampleTable& table, const char* check, const std::vector<std::size_t>& rows,
                const std::string& clean, const std::string& fault);

// The rows far from their neighbours, those beyond max_theta apart.
Finding outliers_of(const io::SampleTable& table, std::vector<NamedRow> rows, double max_theta);

// Whether the rows are cells of a MERL file.
bool is_of_cells(const io::SampleTable& table);

// Rows with the same light: theta_i, phi_i.
std::map<std::pair<double, double>, std::vector<std::size_t>> by_light(const io::SampleTable& table);

}  // namespace brdf::validate
