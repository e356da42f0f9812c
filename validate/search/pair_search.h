// Search over a subject's parameters and pairs of directions.
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

// The direction with this cosine to the normal at this azimuth, radians.
Vec3<double> at_cosine(double z, double phi);

// Cosines 10^(-6 a) and 10^(-6 b), the azimuth between them turn_o half turns.
Pair pair_at(double a, double b, double turn_o, double turn_i);

// The pair at these angles, degrees: the vectors that `brdf eval` makes of them, bit for bit.
Pair pair_at_angles(double theta_i, double phi_i, double theta_o, double phi_o);

// Coordinates: the subject's, then two cosines and the azimuth between, then the azimuth of wi if
// anisotropic. Of code that is not ours azimuths go all the way round unless half of them is known to stand
// for all, and the vectors are those of pair_at_angles.
std::size_t pair_dimensions(const Subject& subject);
Pair pair_of(const Subject& subject, std::span<const double> point);

inline constexpr double kTiny = 1e-30;  // 1/sr: below this a value is an underflowing tail
// |a - b| over the larger, which counts as at least `least`.
double difference(double a, double b, double least = 0);

// 1/sr: differences of values below it are judged against it.
inline constexpr double kFaintest = 0.01;

// f of each channel at one pair, 1/sr.
using Values = std::vector<double>;
using PairMeasure = std::function<double(const Material&, const Pair&)>;

// The largest value of the measure: a structured grid (corners and cover of the parameters, all pairs of
// graded cosines, the mirror plane among the azimuths), a cover, and climbs from the best.
Best worst_pair(const Subject& subject, const PairMeasure& measure, const CheckOptions& options);
// The same where only part of the parameters counts: the grid has these, of the others the measure says so by
// a value below 0.
Best worst_pair(const Subject& subject, const PairMeasure& measure, const CheckOptions& options,
                const std::vector<std::vector<double>>& parameters);
// How many points of a cover of the parameters the grid takes besides their corners.
std::size_t parameter_cover(const CheckOptions& options);

// With the command that prints f there, and with light and viewer exchanged if both orders are asked for, or
// at another pair as well.
Witness pair_witness(const Subject& subject, const Material& at, const Pair& pair, bool both_orders = false,
                     const Pair* other = nullptr);

}  // namespace brdf::validate
