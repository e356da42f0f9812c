// Searches over a subject's parameters and over pairs of directions.
#pragma once

#include <functional>

#include "validate/search/options.h"
#include "validate/search/search.h"
#include "validate/search/subject.h"

namespace brdf::validate {

struct Pair {
  Vec3<double> wi, wo;
  double theta_i, phi_i, theta_o, phi_o;  // degrees
};

// Returns the direction with the cosine `z` to the normal and the azimuth `phi` in radians.
Vec3<double> at_cosine(double z, double phi);

// Returns the pair with the cosines 10^(-6 a) and 10^(-6 b). The azimuth of wi is turn_i half turns, and wo
// is turn_o half turns further.
Pair pair_at(double a, double b, double turn_o, double turn_i);

// Returns the pair at these angles in degrees, with bit for bit the vectors that `brdf eval` computes from
// them.
Pair pair_at_angles(double theta_i, double phi_i, double theta_o, double phi_o);

// Number of coordinates, and the pair at a point. The coordinates are the subject's, then two cosines and
// the azimuth between the directions, then, if the subject is anisotropic, the azimuth of wi. For outside
// code, azimuths cover the full circle unless half of it is known to represent all azimuths, and the
// vectors are computed as in pair_at_angles().
std::size_t pair_dimensions(const Subject& subject);
Pair pair_of(const Subject& subject, std::span<const double> point);

inline constexpr double kTiny = 1e-30;  // 1/sr: a value below this is an underflowing tail
// Returns |a - b| over the larger magnitude, which counts as at least `least`; 0 if both are below kTiny.
double difference(double a, double b, double least = 0);

// 1/sr: differences of smaller values are judged relative to this value.
inline constexpr double kFaintest = 0.01;

// f of each channel at one pair, 1/sr.
using Values = std::vector<double>;
using PairMeasure = std::function<double(const Material&, const Pair&)>;

// Finds the largest value of the measure. Evaluates a structured grid (corners and a cover of the
// parameters, all pairs of graded cosines, azimuths that include the plane of incidence) and a cover, then
// climbs from the best points.
Best worst_pair(const Subject& subject, const PairMeasure& measure, const CheckOptions& options);
// Finds the largest value over a part of the parameter domain. The grid uses the given `parameters`; the
// measure marks other parameters outside that part by a value below 0.
Best worst_pair(const Subject& subject, const PairMeasure& measure, const CheckOptions& options,
                const std::vector<std::vector<double>>& parameters);
// Returns how many points of a cover of the parameters the grid uses in addition to the corners.
std::size_t parameter_cover(const CheckOptions& options);

// Returns a witness with the command that prints f at the pair. With `both_orders` the command also prints
// f with light and viewer exchanged; with `other` also f at another pair.
Witness pair_witness(const Subject& subject, const Material& at, const Pair& pair, bool both_orders = false,
                     const Pair* other = nullptr);

}  // namespace brdf::validate
