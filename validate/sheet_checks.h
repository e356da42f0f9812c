// The checks of a table of measurements, and what they share.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "validate/data_sheet.h"
#include "validate/reciprocal_pairs.h"

namespace brdf::validate {

// Rows by themselves.
Finding negative(const io::SampleTable& table);
Finding missing(const io::SampleTable& table);
Finding duplicates(const io::SampleTable& table);
// At theta = 0 the azimuth means nothing: values that depend on it betray exchanged columns.
Finding directions(const io::SampleTable& table);
// Rows against their neighbours.
Finding outliers(const io::SampleTable& table);
// Light and viewer exchanged, and the sample turned.
Finding exact_reciprocity(const io::SampleTable& table);
Finding noise_floor(const io::SampleTable& table, const std::vector<ReciprocalPair>& pairs);
Finding cosine_factor(const io::SampleTable& table, const std::vector<ReciprocalPair>& pairs);
Finding isotropy(const io::SampleTable& table);
// Integrals, one for each angle of the light.
MeasuredAlbedo integrate(const io::SampleTable& table, const std::vector<std::size_t>& rows, double noise);
Finding coverage(const io::SampleTable& table, const std::vector<MeasuredAlbedo>& albedo);
Finding energy(const io::SampleTable& table, const std::vector<MeasuredAlbedo>& albedo);

// --- Tools ------------------------------------------------------------------------------------------------

std::string plural(std::size_t n, const std::string& word);

Finding start(const io::SampleTable& table, const char* check);
// `fail` where there are rows, naming the first of them.
Finding counted(const io::SampleTable& table, const char* check, const std::vector<std::size_t>& rows,
                const std::string& clean, const std::string& fault);

// Rows with the same light: theta_i, phi_i.
std::map<std::pair<double, double>, std::vector<std::size_t>> by_light(const io::SampleTable& table);

}  // namespace brdf::validate
