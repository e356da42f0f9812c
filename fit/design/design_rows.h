// Directions as rows of a design: the logarithm of a fitted model there as a linear function of the solver's
// parameters, and the correlation of the model's errors at two directions.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "fit/algebra/eigen_view.h"
#include "fit/solved.h"

namespace brdf::fit {

// The place of a pair of directions: (r_i^2 + r_o^2, 2 q_i.q_o, |r_i^2 - r_o^2|), with q = (x, y)/sqrt(1 + z)
// for each unit vector and r = |q| = sqrt(2) sin(theta/2) (Koenderink and van Doorn 1998). Exchanging the
// directions, turning the sample, and mirroring it leave the place unchanged.
using Place = std::array<double, 3>;
Place place_of(const Vec3<double>& wi, const Vec3<double>& wo);

// The correlation of the errors of a model at two places: exp(-|u - u'|^2 / (2 * 0.35^2)).
double correlation(const Place& a, const Place& b);

struct DesignRows {
  std::vector<Place> places;                 // [row]
  std::vector<std::vector<double>> values;   // [channel][row], f of the model, 1/sr
  std::vector<RowMatrix> gradients;          // [channel], rows by parameters: the gradient of ln f
  std::vector<std::vector<double>> weights;  // [channel][row], of an error of ln f, squared, in the metric
  std::vector<bool> usable;                  // [row], whether f is above 0 in every channel

  std::size_t rows() const { return places.size(); }
  std::size_t channels() const { return values.size(); }
  Eigen::Index parameters() const { return gradients.empty() ? 0 : gradients.front().cols(); }
};

// Computes the rows of `data` for a solved model. A row that is not usable has a gradient and weights of 0.
DesignRows design_rows(const FitData& data, const Solved& solved, double aperture);

// Returns the rows at which a model is judged: `count` pairs of directions that fill both hemispheres up to
// `steepest` degrees evenly, with the density of the cosine. Every value is 1.
FitData hemisphere_rows(const std::vector<std::string>& channels, std::size_t count, double steepest);

// Returns the prior knowledge of the parameters as an information matrix (diagonal). One standard deviation
// of a parameter alone changes ln f by 1, as the root mean square over the hemisphere; that of a parameter
// without effect is 1.
Eigen::VectorXd prior_information(const DesignRows& hemisphere);

}  // namespace brdf::fit
