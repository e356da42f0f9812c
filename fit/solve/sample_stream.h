// Passes over the samples, a block of rows at a time: normal equations without ever storing a Jacobian.
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

// cost = 1/2 sum rho(r^2); gradient and Gauss-Newton matrix of it by the solver's parameters.
struct NormalEquations {
  Matrix hessian;
  std::vector<double> gradient;
  double cost = 0;
};

// The model's values, [channel][row], and the expected meat (below) where there is no loss.
struct Besides {
  std::vector<std::vector<double>> values;
  Matrix expected_meat;
};

// What uncertainty needs besides: the curvature of the loss in place of its slope (bread), and the sum over
// rows of the outer product of the row's gradient (meat: channels of one row may share their noise).
struct ScoreMatrices {
  Matrix bread, meat;
};

// Sums over all rows of the Gram matrix of (lobes, derivatives of lobes)
// weighted by the squared slope of a linear residual: given it, every choice of
// weights is algebra. Valid while all channels of a group have the same weights.
struct LobeGram {
  std::size_t lobes = 0, derivatives = 0;  // columns: lobes, then for each derivative the term's lobes
  Matrix gram;                             // of the columns
  Matrix cross;                            // [channel][column]: with the measurement
  std::vector<double> square;              // [channel]: of the measurement
};

// A cost that is quadratic in the weights of the lobes: its second and first derivatives where they are 0,
// and its value.
struct LobeQuadratic {
  std::vector<Matrix> hessian;  // [channel]
  Matrix gradient;              // [channel][lobe]
  double cost = 0;
};

// What of the noise is shared: nothing, or the noise of the channels of a row.
enum class Clusters { values, rows };

// What one derivative column contributes to: the solver's parameters and the factors.
struct Contribution {
  std::size_t slot;
  double factor;
};

struct ValueErrors {
  std::vector<std::vector<double>> values, errors;  // [channel][row]
};

// Once for all passes under this metric what no parameter changes: `value_slope`, where the metric has it.
void note_value_slopes(FitData& data, Metric metric);

class SampleStream {
  struct Shapes;
  struct Workspace;

 public:
  // Room that one pass leaves for the next; several threads may pass. Of streams of one model.
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
  // `spare`: of the streams of many small problems, one after another; its own unless it is given.
  SampleStream(const FitData& data, const Model& model, const Residual& residual, double aperture,
               std::shared_ptr<Spare> spare = nullptr);
  // Over some rows only; `scores` and `freedom` are of all rows still.
  SampleStream(const SampleStream& all, std::vector<RowRange> part);

  const FitData& data() const { return data_; }
  const Model& model() const { return model_; }
  const Residual& residual() const { return residual_; }

  // `besides`, where it is given: what the same pass tells, over all rows.
  NormalEquations normal_equations(std::span<const double> p, Besides* besides = nullptr) const;
  // The same at linear weights 0 for the residual linearised at the measurement: a quadratic in the weights.
  NormalEquations linearised_weights(std::span<const double> p) const;
  // That quadratic in the weights of the lobes themselves.
  LobeQuadratic linearised_lobes(std::span<const double> p) const;
  ScoreMatrices scores(std::span<const double> p) const;
  Matrix bread(std::span<const double> p) const;
  // The meat where, with the inverse of the bread, every residual is divided by the root of 1 less its
  // leverage, which makes its square unbiased where all values are as noisy (MacKinnon and White 1985, HC2).
  // With `expected`, the sandwich of the expected meat, it is unbiased where the noise is proportional to the
  // value (Bell and McCaffrey 2002, of that working model; never below HC2, nor above HC3).
  Matrix meat(std::span<const double> p, const Matrix& inverse, const Matrix* expected = nullptr) const;
  // The meat of noise that is the value itself.
  Matrix expected_meat(std::span<const double> p) const;
  // The meat of these scores in the residuals' place, [channel][row], independent of each other or shared
  // within a row.
  Matrix meat_of(std::span<const double> p, const std::vector<std::vector<double>>& scores,
                 Clusters clusters) const;
  // What the values have of the variance of v'g for each v, g the gradient of one value; noise taken as
  // proportional to the value.
  std::vector<NoiseShares> noise_shares(std::span<const double> p,
                                        const std::vector<std::vector<double>>& v) const;
  // The model's values and their standard errors, from the covariance of the solver's parameters.
  ValueErrors value_errors(std::span<const double> p, const Matrix& covariance) const;
  LobeGram lobe_gram(std::span<const double> p, std::size_t group) const;
  // [channel][row]: the model's values. The second writes only the rows that are summed over.
  std::vector<std::vector<double>> values(std::span<const double> p) const;
  void values(std::span<const double> p, std::vector<std::vector<double>>& out) const;
  // [channel][row]: the residuals, before the loss; of the model's values.
  std::vector<std::vector<double>> residual_values(std::span<const double> p) const;
  std::vector<std::vector<double>> residuals_of(std::vector<std::vector<double>> values) const {
    return of_values(std::move(values), false);
  }
  // [channel][row]: the residuals' derivatives by the model's values, before the loss.
  std::vector<std::vector<double>> slopes_of(std::vector<std::vector<double>> values) const {
    return of_values(std::move(values), true);
  }

 private:
  std::vector<std::vector<double>> of_values(std::vector<std::vector<double>> values, bool slopes) const;
  Shapes shapes(std::span<const double> p, std::size_t group, bool derivatives) const;
  // Nothing where the workspace still holds them: one block's lobes serve all passes at the same shapes.
  void fill_lobes(const Shapes& shapes, std::size_t first, std::size_t rows, Workspace& w) const;
  void evaluate_lobes(const Shapes& shapes, std::size_t first, std::size_t rows, Workspace& w) const;
  void fill_tilted(const Shapes& shapes, std::size_t first, std::size_t rows, Workspace& w) const;
  Directions<double> tilt(const Vec3<double>& normal, std::size_t first, std::size_t rows,
                          Workspace& w) const;
  struct Leverage {
    const Matrix* inverse = nullptr;   // of the bread; null: residuals stay as they are
    const Matrix* expected = nullptr;  // covariance of the unknowns under noise that is the value
    bool noise_alone = false;          // that noise in the residuals' place
    const std::vector<std::vector<double>>* scores = nullptr;  // [channel][row] in the residuals' place
    Clusters clusters = Clusters::rows;
  };
  // Only what is not null.
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
  NormalEquations mapped(const ChannelSums& sums, std::span<const double> p) const;
  Matrix lobe_weights(std::span<const double> p) const;  // [channel][lobe]

  const FitData& data_;
  const Model& model_;
  Residual residual_;
  std::vector<ApertureNode> detector_;  // empty: readings are of one direction
  std::vector<RowRange> part_;
  std::shared_ptr<Spare> spare_;
  std::uint64_t id_;  // of streams over these samples: a workspace knows by it whose lobes it holds
};

}  // namespace brdf::fit
