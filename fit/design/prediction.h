// The variance of a model's values over the hemisphere after readings at chosen directions, if the
// model has an error.
#pragma once

#include "fit/design/design_rows.h"
#include "fit/design/expected.h"

namespace brdf::fit {

// The knowledge of ln f = model + d at the candidates and over the hemisphere. The parameters of the model
// have the prior of prior_information(); d is a Gaussian process with the standard deviation `error` and the
// correlation of the places, independent in every channel. A reading has the noise `noise`.
class Prediction {
 public:
  // `start`: rows that were measured, each for `repeats` readings.
  Prediction(const DesignRows& start, double repeats, const DesignRows& candidates,
             const DesignRows& hemisphere, const NoiseAndError& known);

  // Returns the mean variance of ln f over the hemisphere and the channels.
  double variance() const;
  // Returns for every candidate by how much a reading there lowers this variance.
  std::vector<double> falls() const;
  // Takes a reading at a candidate into account.
  void read(std::size_t candidate);

 private:
  void condition(Eigen::Index point, double repeats);
  Eigen::VectorXd covariances(Eigen::Index point) const;

  double noise_variance_, error_variance_;
  Eigen::Index start_, candidates_, hemisphere_;
  std::vector<Place> places_;         // of the start, the candidates and the hemisphere
  std::vector<RowMatrix> gradients_;  // [channel], of the part that the errors do not explain
  RowMatrix information_;             // of the parameters
  // The readings so far: their covariances with all points, and their variances.
  std::vector<Eigen::VectorXd> columns_;
  std::vector<double> variances_;
  Eigen::VectorXd own_;  // variances of the error at all points
  RowMatrix across_;     // covariances of the error, hemisphere by candidates
};

}  // namespace brdf::fit
