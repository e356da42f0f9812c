// The result of a fit: for every model its material, with the uncertainty and quality of the fit.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "brdf/names.h"
#include "fit/algebra/matrix.h"
#include "fit/assess/half_angles.h"
#include "fit/assess/metric_choice.h"
#include "fit/model/row_groups.h"
#include "io/formats/budget.h"
#include "sheet/data_sheet.h"

namespace brdf::fit {

enum class Verdict {
  converged,
  at_bound,
  determined,
  not_identifiable,
  misfit,
  breaks_energy,  // reflects more light than it receives at a measured angle of incidence
  diverged,
  interrupted
};
// The origin of intervals: the curvature of the cost at its minimum, clipped to the ranges (approximate),
// or the profile of the cost within the bounds.
enum class IntervalsBy { curvature, profile };
enum class Status { free, fixed, at_bound, unidentified };  // of one parameter

}  // namespace brdf::fit

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 8> kNames<fit::Verdict>{
    "converged", "at_bound",      "determined", "not_identifiable",
    "misfit",    "breaks_energy", "diverged",   "interrupted"};
template <>
inline constexpr std::array<std::string_view, 2> kNames<fit::IntervalsBy>{"curvature", "profile"};
template <>
inline constexpr std::array<std::string_view, 4> kNames<fit::Status>{"free", "fixed", "at_bound",
                                                                     "unidentified"};

}  // namespace brdf

namespace brdf::fit {

// Returns whether the material may be used (exit code 0): converged, at_bound (with its warning), or
// determined. For determined, the samples do not fix the division among the weights, but every prediction
// is known.
inline bool usable(Verdict verdict) {
  return verdict == Verdict::converged || verdict == Verdict::at_bound || verdict == Verdict::determined;
}

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Extent {
  double low = kUnknown, high = kUnknown;
};

// A standard uncertainty as the root of the sum of the squares of independent parts.
struct Combined {
  struct Part {
    std::string source;  // a source of the budget, or the scatter of the rows
    double standard_uncertainty = 0;
  };
  double standard_uncertainty = kUnknown;
  std::vector<Part> parts;
  double rowwise = 0, shared = 0;  // of the parts that are independent from row to row, and of the others

  double share(const Part& part) const;  // of the variance
};

// The estimate of one reported parameter, with its uncertainty.
struct Estimate {
  Status status = Status::free;
  std::string name;     // as in the material: alpha_x, kd; terms[1].ks in a sum
  std::string channel;  // empty if all channels share the parameter
  double value = 0;     // tangent_phi in degrees
  double standard_error = 0;
  double freedom = 0;  // degrees of freedom of its variance
  // Effective number of values that decide the parameter: 1 over the sum of their squared shares of its
  // variance.
  double deciding = kUnknown;
  double low = kUnknown, high = kUnknown;  // 95 %, from the noise of the values if the model is correct
  // True if only the range of the parameter limits the interval, or if the samples never contradict values
  // beyond this end. low and high are then the limits of the range.
  bool low_open = true, high_open = true;
  // The remaining members are set for free parameters. with_lack_of_fit is the 95 % interval that allows
  // for lack of fit. It comes from the movement of the parameter when folds of incidences are left out, and
  // always contains low and high.
  Extent with_lack_of_fit;
  Extent left_out, other_metrics;  // range of the value over the folds, and over the other metrics
  // The 95 % interval and the standard deviation of bootstrap replicates, if there are any.
  Extent bootstrap;
  double bootstrap_error = kUnknown;
  // The standard uncertainty with the budget of the instrument. If it is there, all intervals above except
  // those of folds, metrics and replicates contain the budget.
  std::optional<Combined> budget;
};

// The relative errors that the sources of a budget cause in the values of a fitted model, to first order.
struct RowBudget {
  std::shared_ptr<const io::Budget> budget;
  std::vector<std::uint32_t> row;  // of the table of samples
  // [channel][row]: sensitivities, the relative change of a reading per radian of its angles; and f cos_o
  // and f of the model.
  std::vector<std::vector<double>> theta_i, theta_o, signal, values;
  // Number of values for which the curvature of f adds more than a tenth to the standard uncertainty.
  std::size_t beyond_first_order = 0;

  // Returns the relative error of a value for an error of one standard uncertainty of a source, with its
  // sign.
  double error(const io::BudgetSource& source, std::size_t channel, std::size_t k) const;
  // Returns the relative standard uncertainty of a value.
  double combined(std::size_t channel, std::size_t k) const;
  std::vector<double> largest;  // [channel]: the largest signal
  std::size_t lights = 0;       // directions of incidence, for sources that the rows of a light share
};

// The root mean square of each residual (for cube_root, the mean of its terms), over the values for which
// the residual is defined.
struct Metrics {
  double log = kUnknown, cosine_l2 = kUnknown, log_relative = kUnknown;
  double cube_root = kUnknown;  // mean of (((f - g) c_i)^2)^(1/3)
};

// Relative errors, over the measured values above 0.
struct RelativeErrors {
  double median = kUnknown, ninth_decile = kUnknown;  // of |model - value|/value
  double off_by_two = kUnknown;  // share of the light with an error of more than a factor of two
};

// The prediction of a form for rows to which it was not fitted.
struct LeftOut {
  double value = kUnknown;       // mean of the loss that was minimised, rho(r^2), over the held-out values
  std::vector<double> by_group;  // the same mean for every group of rows
  RelativeErrors errors;
  double median_standard_error = 0;            // of errors.median, over the folds
  std::vector<std::vector<double>> solutions;  // [fold] the solver's parameters without the rows of the fold
};

// A cell of half angles with a large residual.
struct WorstRegion {
  HalfAngleRange range;
  std::size_t rows = 0;
  double ratio = 1;  // median of measured over modelled values
  double share = 0;  // share of the cost
};

struct LackOfFit {
  static constexpr std::size_t kMostOthers = 3;
  // Normalised median deviation of ln(measured/model), divided by the noise.
  std::optional<double> residual_over_scatter;
  std::optional<WorstRegion> worst;
  std::vector<WorstRegion> others;  // other cells beyond the noise, sorted by their share
  bool beyond_scatter = false;      // the residual is 1.3 times the noise, or some cell exceeds the noise
  bool exact = false;               // the residual is rounding

  // Returns whether there is a reference to judge the residual by.
  bool judged() const { return exact || residual_over_scatter.has_value(); }
};

// A shape as a function of wavelength: the scale of a parameter is a polynomial in x = 1000 nm /
// wavelength.
struct SmoothCurve {
  std::string parameter;  // alpha, terms[1].alpha
  // The function of the parameter that is a polynomial: "ln", "ln1p", "square", "identity".
  std::string scale;
  std::vector<double> coefficients, standard_errors;  // by powers of x
};

struct MinimumReport {
  double cost;
  int basin;
  Material material;
};

struct Correlations {
  std::vector<std::string> names;  // free parameters
  Matrix matrix;
};

// The covariance of the parameters of a material that a fit determines, identifiable or not, as a sum over
// components that vary independently. Parameters that are held, at a bound or without effect are excluded.
struct ParameterCovariance {
  std::vector<std::string> names;  // as options name them: alpha, kd[r], terms[1].f0; tangent_phi in degrees
  Matrix components;               // [component][parameter]: the covariance is the product A'A
  std::vector<double> freedom;     // [component]: degrees of freedom of its variance
  // [component]: the source of the budget, or "" for the part that is independent from row to row. Empty if
  // the budget of the instrument is not in the covariance.
  std::vector<std::string> sources;

  // Degrees of freedom of a variance that a budget states.
  static constexpr double kStated = 1e9;
};

// The largest directional albedo over the angles of incidence.
struct LargestAlbedo {
  double value, theta;  // degrees
  std::string channel;

  // More than all of the light, beyond the error of the integral.
  static constexpr double kMost = 1 + 2e-3;
  bool breaks_energy() const { return value > kMost; }
};

// The material at an end of a parameter's interval. It describes the samples as well as the interval
// requires. If the end is open, materials beyond it do so too.
struct MaterialAtEnd {
  Material material;
  bool open = false;
};

// Properties of the samples that limit the conclusions of a fit, whatever its form.
struct Context {
  std::optional<double> scatter;        // relative
  std::optional<double> least_scatter;  // the part of it that is known to be noise
  bool interpolated = false;  // the noise is that of an instrument's software, which interpolated rows
  HeldOut held_out = HeldOut::many;
  std::size_t lights = 0;  // or viewing directions, or cells of directions: the units that were held out
  std::string side;        // "incidences"
  // The width (Ward's alpha) of the narrowest highlight that the samples would show. A narrower highlight
  // may lie between the samples. std::nullopt if no highlight can be hidden.
  std::optional<double> hidden_width;
};

struct FormFit {
  Context about;
  std::string form;  // "ward", "oren_nayar+ward"
  Verdict verdict = Verdict::diverged;
  std::vector<std::string> findings;  // sentences; the reason for the verdict comes first
  Material material;
  double median_relative_error = kUnknown;
  RelativeErrors errors;
  LackOfFit lack_of_fit;
  Metrics metrics;
  std::optional<LeftOut> left_out;  // std::nullopt: not requested, interrupted, or a single direction
  std::size_t replicates = 0;       // of the bootstrap
  double bic = kUnknown;            // of the chosen residual: n ln(mean r^2) + p ln n
  std::size_t parameters = 0;
  std::vector<Estimate> estimates;
  bool light_is_off = false;    // a misfit because of the share of light in the wrong place
  std::string few_rows_decide;  // the parameters that few rows decide, and these rows; may be empty
  bool has_free_scale = false;  // the samples are uncalibrated, so energy cannot be judged
  IntervalsBy intervals = IntervalsBy::curvature;
  std::vector<MaterialAtEnd> ends;  // of profiles
  std::vector<SmoothCurve> smooth;  // of --shape smooth
  Correlations correlations;
  std::optional<ParameterCovariance> covariance;  // std::nullopt if some direction has no effect at all
  std::optional<RowBudget> budget;                // std::nullopt: intervals contain the scatter only
  std::optional<double> prediction_error;  // relative standard error of the model's values at the samples
  std::optional<LargestAlbedo> largest_albedo;
  std::optional<LargestAlbedo> largest_measured_albedo;  // over the measured angles of incidence
  double condition = 0;                                  // of the scaled normal matrix
  double loss_scale = 0;
  std::vector<MinimumReport> minima;
  int starts = 0, iterations = 0, passes = 0;
  std::string solver_status;   // of the optimiser: converged, iteration_limit, failed, interrupted
  std::string solver_message;  // its message

  // Returns whether some start gave a finite cost. Otherwise the material has the form's default
  // parameters, and no error is known.
  bool solved() const { return !minima.empty(); }
};

// A term that --form auto added, or tried to add, to the model of the previous step.
struct Step {
  std::string added;          // "a second lobe"
  std::string model;          // the model that was tried
  double left_out = 0;        // held-out value of that model
  double difference = 0;      // held-out value of the model so far minus left_out
  double standard_error = 0;  // of the difference, from the scatter between groups
  double p = 1;               // one-sided p-value of such a fall, corrected for all models tried
  std::size_t tried = 1;
  bool kept = false;
  // Returns whether the step was not kept although it would halve the error. The incidences cannot
  // distinguish such a fall from chance.
  bool refused_halving() const { return !kept && difference > left_out; }
};

struct FitResult {
  std::size_t rows = 0, beyond_max_theta = 0, outside_domain = 0;
  std::vector<std::string> channels;
  sheet::DataSheet sheet;  // of the samples as they were read; empty for a table that a program computed
  MetricChoice metric;     // the residual in use
  std::optional<double> noise_floor;  // relative, from the table itself (io/samples/noise.h)
  std::string refuted_noise;          // why a larger estimate of the noise does not count; otherwise empty
  std::vector<std::optional<double>> channel_noise;
  RowGroups groups;              // the groups that were held out together
  double left_out_rounding = 0;  // held-out values below this are rounding errors of 0
  std::vector<Step> steps;       // of --form auto; otherwise empty
  std::vector<FormFit> ranking;  // best first: by the held-out value, or by the median error without one
  std::size_t recommended = 0;   // the simplest usable model not worse than the best, or else the best
  bool interrupted = false;
};

}  // namespace brdf::fit
