// Reciprocal pairs of a table: exact ones, and by interpolation between its directions.
#pragma once

#include <vector>

#include "io/samples.h"

namespace brdf::io {

// f with light and viewer in one order and in the other.
struct ReciprocalPair {
  double theta_a, theta_b, azimuth;  // degrees; azimuth between the directions, 0 to 180
  std::size_t channel;
  double forward, backward;  // light at a, viewer at b; and exchanged
  std::size_t row;           // of the forward value; exact pairs only
};

// Pairs of rows whose directions are exchanged, each once; rows with equal polar angles are their own
// partners and are left out.
std::vector<ReciprocalPair> exact_pairs(const SampleTable& table);

// For every two polar angles of the light that occur and every azimuth that occurs with both: each value by
// linear interpolation in the viewer's polar angle.
std::vector<ReciprocalPair> interpolated_pairs(const SampleTable& table);

// |a - b| over their mean
double relative_difference(const ReciprocalPair& pair);

}  // namespace brdf::io
