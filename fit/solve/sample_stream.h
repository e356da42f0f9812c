// Passes over the samples, one block of rows at a time. They compute normal equations without ever storing
// a Jacobian.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fit/algebra/matrix.h"
#include "fit/model/data.h"
#include "fit/model/model.h"
#include "fit/solve/noise_shares.h"
#include "fit/solve/residual.h"

namespace brdf::fit {

// cost = 1/2 sum rho(r^2), with its gradient and Gauss-Newton matrix by the solver's parameters.
struct NormalEquations {
  Matrix hessian;
  std::vector<double> gradient;
  double cost = 0;
};

// Additional results of a pass: the values of the model, [channel][row], and the expected meat (below) if
// there is no loss.
struct Besides {
  std::vector<std::vector<double>> values;
  Matrix expected_meat;
};

// Matrices for the uncertainty. `bread` is the normal matrix with the curvature of the loss instead of its
// slope. `meat` is the sum over rows of the outer product of the row's gradient (channels of one row may
// share their noise).
struct ScoreMatrices {
  Matrix bread, meat;
};

// Sums over all rows of the Gram matrix of (lobes, derivatives of lobes), weighted by the squared slope of
// a linear residual. With these sums, any choice of weights is evaluated by algebra alone. Valid if all
// channels of a group have the same row weights.
struct LobeGram {
  std::size_t lobes = 0, derivatives = 0;  // columns: lobes, then for each derivative the lobes of its term
  Matrix gram;                             // of the columns
  Matrix cross;                            // [channel][column]: products with the measurement
  std::vector<double> square;              // [channel]: sum of squares of the measurement
};

// A cost that is quadratic in the weights of the lobes: its second derivatives, and its first derivatives
// and value at zero weights.
struct LobeQuadratic {
  std::vector<Matrix> hessian;  // [channel]
  Matrix gradient;              // [channel][lobe]
  double cost = 0;
};

// The extent of shared noise: not shared, or shared by the channels of a row.
enum class Clusters { values, rows };

// A contribution of one derivative column: the solver's parameter and the factor.
struct Contribution {
  std::size_t slot;
  double factor;
};

// Values of the model with their standard errors.
struct ValueErrors {
  std::vector<std::vector<double>> values, errors;  // [channel][row]
};

// Sets `value_slope`, if the metric has one: the part of the residuals that does not depend on the
// parameters, computed once for all passes under this metric.
void note_value_slopes(FitData& data, Metric metric);

// Evaluates a model and its residuals at the samples, block by block.
class SampleStream {
  struct Shapes;
  struct Workspace;

 public:
  // A workspace that one pass leaves for the next pass. It serves streams of the same model. Several
  // threads may use it concurrently.
  class Spare {
   public:
    Spare() = default;
    Spare(const Spare&) = delete;
    Spare& operator=(const Spare&) = delete;
    ~Spare();

   private:
    friend class SampleStream;
    std::unique_ptr<Workspace> take(const Model& model);
    void give(std::unique_ptr<Workspace> workspace);

    std::atomic<Workspace*> kept_{nullptr};
  };

  // `aperture`: full width of the detector's field in degrees, 0 for none. The sums are over all rows.
  // `spare`: a workspace that the streams of many small problems share, one after another; by default the
  // stream has its own.
  SampleStream(const FitData& data, const Model& model, const Residual& residual, double aperture,
               std::shared_ptr<Spare> spare = nullptr);
  // Restricts the sums of the normal equations, linearised_weights, linearised_lobes, lobe_gram, values and
  // residuals to some rows. The statistics (scores, bread, meat, noise_shares, value_errors) are still over
  // all rows.
  SampleStream(const SampleStream& all, std::vector<RowRange> part);

  const FitData& data() const { return data_; }
  const Model& model() const { return model_; }
  const Residual& residual() const { return residual_; }
  double aperture() const { return aperture_; }  // full width of the detector's field in degrees

  // `besides`, if not null, receives additional results of the same pass, over all rows of the pass.
  NormalEquations normal_equations(std::span<const double> p, Besides* besides = nullptr) const;
  // Returns the same without what the limits of the weights contribute.
  NormalEquations without_cuts(std::span<const double> p) const;
  // Returns the normal equations at linear weights 0 for the residual linearised at the measurement: a
  // quadratic in the weights.
  NormalEquations linearised_weights(std::span<const double> p) const;
  // Returns the same quadratic in the weights of the lobes themselves.
  LobeQuadratic linearised_lobes(std::span<const double> p) const;
  // Returns the bread and the meat, or the bread alone.
  ScoreMatrices scores(std::span<const double> p) const;
  Matrix bread(std::span<const double> p) const;
  // Returns the meat with every residual divided by the root of 1 less its leverage, computed with the
  // inverse of the bread. This makes the square of the residual unbiased if all values are equally noisy
  // (MacKinnon and White 1985, HC2). With `expected`, the sandwich of the expected meat, the square is
  // unbiased if the noise is proportional to the value (Bell and McCaffrey 2002, for this working model;
  // never below HC2, nor above HC3).
  Matrix meat(std::span<const double> p, const Matrix& inverse, const Matrix* expected = nullptr) const;
  // Returns the meat of noise equal to the value itself.
  Matrix expected_meat(std::span<const double> p) const;
  // Returns the meat with these scores, [channel][row], in place of the residuals. The scores are
  // independent of each other or shared within a row.
  Matrix meat_of(std::span<const double> p, const std::vector<std::vector<double>>& scores,
                 Clusters clusters) const;
  // Returns the sums of the gradients of the values times their scores, [channel][row], over each cluster of
  // rows: a matrix [cluster][solver's parameter]. `cluster` holds the number of the cluster of each row.
  Matrix score_sums(std::span<const double> p, const std::vector<std::vector<double>>& scores,
                    std::span<const std::uint32_t> cluster) const;
  // Returns the contributions of the values to the variance of v'g for each v, where g is the gradient of
  // one value. The noise is assumed to be proportional to the value.
  std::vector<NoiseShares> noise_shares(std::span<const double> p,
                                        const std::vector<std::vector<double>>& v) const;
  // Returns the model's values and their standard errors, given the covariance of the solver's parameters.
  ValueErrors value_errors(std::span<const double> p, const Matrix& covariance) const;
  // Returns the Gram matrix of one group of shapes.
  LobeGram lobe_gram(std::span<const double> p, std::size_t group) const;
  // Compute the model's values, [channel][row]. The second function writes only the rows of this stream's
  // sums.
  std::vector<std::vector<double>> values(std::span<const double> p) const;
  void values(std::span<const double> p, std::vector<std::vector<double>>& out) const;
  // Return the residuals before the loss, [channel][row], at the parameters p or for given values of the
  // model.
  std::vector<std::vector<double>> residual_values(std::span<const double> p) const;
  std::vector<std::vector<double>> residuals_of(std::vector<std::vector<double>> values) const {
    return of_values(std::move(values), false);
  }
  // Returns the derivatives of the residuals by the model's values, before the loss, [channel][row].
  std::vector<std::vector<double>> slopes_of(std::vector<std::vector<double>> values) const {
    return of_values(std::move(values), true);
  }

 private:
  std::vector<std::vector<double>> of_values(std::vector<std::vector<double>> values, bool slopes) const;
  Shapes shapes(std::span<const double> p, std::size_t group, bool derivatives) const;
  // Does nothing if the workspace still holds these lobes. The lobes of a single block thus serve all
  // passes with the same shapes.
  void fill_lobes(const Shapes& shapes, std::size_t first, std::size_t rows, Workspace& w) const;
  void evaluate_lobes(const Shapes& shapes, std::size_t first, std::size_t rows, Workspace& w) const;
  void fill_tilted(const Shapes& shapes, std::size_t first, std::size_t rows, Workspace& w) const;
  Directions<double> tilt(const Vec3<double>& normal, std::size_t first, std::size_t rows,
                          Workspace& w) const;
  struct Leverage {
    const Matrix* inverse = nullptr;   // of the bread; null: residuals are used unchanged
    const Matrix* expected = nullptr;  // covariance of the unknowns under noise equal to the value
    bool noise_alone = false;          // use that noise in place of the residuals
    // Scores, [channel][row], used in place of the residuals.
    const std::vector<std::vector<double>>* scores = nullptr;
    Clusters clusters = Clusters::rows;
    // If set, receives the sums of the scores of each cluster of rows. `cluster` is then set too.
    Matrix* sums = nullptr;
    std::span<const std::uint32_t> cluster;
  };
  // Adds to `bread` and `meat`, each only if not null.
  void add_scores(std::span<const double> p, const Leverage& leverage, Matrix* bread, Matrix* meat) const;
  static void add_to_scores(const std::vector<std::vector<Contribution>>& map, bool robust, std::size_t rows,
                            Workspace& w);
  void fill_jacobian(const double* weights, std::size_t rows, Workspace& w) const;
  template <class Visit>
  void for_each_block(Visit&& visit) const;
  // Products of the columns (lobes, partials, residual) of every channel, and the cost.
  struct ChannelSums {
    std::vector<Matrix> raw;
    double cost = 0;
  };
  ChannelSums accumulate(std::span<const double> p, const Matrix& weights, const Residual& residual,
                         bool derivatives, Besides* besides = nullptr) const;
  // Add what the limits of the weights that are not met contribute.
  void add_cuts(std::span<const double> p, NormalEquations& to) const;
  void add_cuts(std::span<const double> p, Matrix& hessian) const;
  NormalEquations mapped(const ChannelSums& sums, std::span<const double> p) const;
  Matrix lobe_weights(std::span<const double> p) const;  // [channel][lobe]

  const FitData& data_;
  const Model& model_;
  Residual residual_;
  double aperture_;
  std::vector<ApertureNode> detector_;  // empty: readings are of a single direction
  std::vector<RowRange> part_;
  std::shared_ptr<Spare> spare_;
  std::uint64_t id_;  // shared by streams over the same samples; identifies a workspace's lobes
};

}  // namespace brdf::fit
